// The scalars graze computes in, and the two vectors that everything else is written with.
//
// S is float or double, IEEE 754, round to nearest. u = kUnitRoundoff<S> = 2^-24 or 2^-53.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross
#include <concepts>
#include <cstdint>
#include <limits>

#if defined(__FAST_MATH__)
#error "graze: -ffast-math voids every rounding bound in these headers; compile without it"
#endif

namespace graze {

template <class S>
concept Scalar = std::same_as<S, float> || std::same_as<S, double>;

template <Scalar S>
using Vec3 = Eigen::Matrix<S, 3, 1>;

template <Scalar S>
using Mat3 = Eigen::Matrix<S, 3, 3>;

// u, the unit roundoff: |fl(x op y) - (x op y)| <= u |x op y|.
template <Scalar S>
inline constexpr S kUnitRoundoff = std::numeric_limits<S>::epsilon() / 2;

template <Scalar S>
inline constexpr S kInfinity = std::numeric_limits<S>::infinity();

// A rotation x -> q x conj(q) / |q|^2 for any q != 0: rational in q, so a posed vertex is an exact rational.
// (1, 1, 0, 0) is exactly 90 degrees about x. |q| = 1 is neither needed nor assumed.
template <Scalar S>
struct Quaternion {
  S w = 1, x = 0, y = 0, z = 0;

  // True also for (w, 0, 0, 0) with any w != 0, and for its negative.
  [[nodiscard]] bool is_identity() const { return x == 0 && y == 0 && z == 0; }
};

}  // namespace graze
