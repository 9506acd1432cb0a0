// A double for a checker's message: the shortest decimal that reads back to the same bits.
#pragma once

#include <charconv>
#include <string>

namespace graze::oracle {

[[nodiscard]] inline std::string text(double x) {
  char buffer[32];  // at most 24 characters: sign, 17 digits, point, exponent
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

}  // namespace graze::oracle
