// A double for a checker's message: to the last bit, and readable.
#pragma once

#include <cstdio>
#include <string>

namespace graze::oracle {

[[nodiscard]] inline std::string text(double x) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "%a (%.17g)", x, x);
  return buffer;
}

}  // namespace graze::oracle
