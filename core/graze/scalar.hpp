// The scalars graze computes in, and the two vectors that everything else is written with.
//
// S is float or double, IEEE 754, round to nearest. u = kUnitRoundoff<S> = 2^-24 or 2^-53.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <graze/linkage.hpp>
#include <limits>

#ifndef GRAZE_COMPILED
#include <graze/detail/numeric/flags.hpp>
#endif

namespace graze { inline namespace GRAZE_LINKAGE {

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

// 2^e.
[[nodiscard]] inline double power_of_two(int e) {
  if (e < -1022 || e > 1023) return std::ldexp(1.0, e);
  return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}
// floor(log2 |x|) for a finite x != 0.
[[nodiscard]] inline int exponent_of(double x) {
  const int biased = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
  return biased == 0 ? std::ilogb(x) : biased - 1023;
}

// Does the machine take this subnormal for 0 (denormals-are-zero)? Then it is not what the caller gave.
template <Scalar S>
[[nodiscard]] inline bool is_flushed(S x) {
  using Bits = std::conditional_t<sizeof(S) == 8, std::uint64_t, std::uint32_t>;
  return x == 0 && static_cast<Bits>(std::bit_cast<Bits>(x) << 1) != 0;
}

// n / |n| for any finite n != 0: scaled first, so that no square vanishes or overflows.
template <Scalar S>
Vec3<S> unit(const Vec3<S>& n) {
  const S most = n.cwiseAbs().maxCoeff();
  if (!(most > 0)) return Vec3<S>::Zero();
  const Vec3<S> scaled = n / most;
  return scaled / scaled.norm();
}

// A rotation x -> q x conj(q) / |q|^2 for any q != 0: rational in q, so a posed vertex is an exact rational.
// (1, 1, 0, 0) is exactly 90 degrees about x. |q| = 1 is neither needed nor assumed. An Eigen::Quaternion of
// the same scalar, or a Map of one, converts to it, number by number; whoever has one has included
// <Eigen/Geometry>, which graze does not need.
template <Scalar S>
struct Quaternion {
  S w = 1, x = 0, y = 0, z = 0;

  constexpr Quaternion() = default;
  constexpr Quaternion(S real, S i, S j, S k) : w(real), x(i), y(j), z(k) {}
  template <class Derived>
  requires std::same_as<typename Derived::Scalar, S> Quaternion(const Eigen::QuaternionBase<Derived>& q)
      : Quaternion(q.w(), q.x(), q.y(), q.z()) {}

  // True also for (w, 0, 0, 0) with any w != 0, and for its negative.
  [[nodiscard]] bool is_identity() const { return x == 0 && y == 0 && z == 0; }
};

}}  // namespace graze::GRAZE_LINKAGE
