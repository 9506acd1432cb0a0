// The measure of a value that is not a number, or that has no bound.
#pragma once

#include <cmath>
#include <graze/scalar.hpp>
#include <limits>

#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

inline constexpr double kInf = std::numeric_limits<double>::infinity();
inline constexpr Enclosure kUnbounded = {kInf, kInf};

inline bool finite(const Vec3<double>& x) {
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

}  // namespace graze::oracle
