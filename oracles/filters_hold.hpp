// Where the process does not round to nearest, or flushes subnormals (a library linked with -ffast-math turns
// that on for everybody), the error bounds of filtered.hpp and double_double.hpp are void.
#pragma once

#include <limits>

namespace graze::oracle {

[[nodiscard]] inline bool filters_hold() {
  volatile double least = std::numeric_limits<double>::min(), half_unit = 0x1p-53, one = 1;
  const double subnormal = least / 2;
  volatile double kept = subnormal;
  return kept * 2 == least && one + half_unit == one && -one - half_unit == -one &&
         (one + 0x1p-52) + half_unit == one + 0x1p-51;
}

}  // namespace graze::oracle
