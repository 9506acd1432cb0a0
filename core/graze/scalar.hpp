/// @file
/// The scalars that graze computes in, and the vectors, matrices and quaternions that everything else is written
/// with.
///
/// S is float or double, IEEE 754, round to nearest. u = 2^-24 or 2^-53 is kUnitRoundoff.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <graze/detail/numeric/products.hpp>
#include <graze/linkage.hpp>
#include <limits>

#ifndef GRAZE_COMPILED
#include <graze/detail/numeric/flags.hpp>
#endif

namespace graze { inline namespace GRAZE_LINKAGE {

/// A scalar of graze: float or double.
///
/// @code
/// static_assert(graze::Scalar<float> && graze::Scalar<double> && !graze::Scalar<long double>);
/// @endcode
template <class S>
concept Scalar = std::same_as<S, float> || std::same_as<S, double>;

/// A point, a direction or a displacement: `Eigen::Vector3f` or `Eigen::Vector3d`.
template <Scalar S>
using Vec3 = Eigen::Matrix<S, 3, 1>;

/// A matrix of three rows and three columns: `Eigen::Matrix3f` or `Eigen::Matrix3d`. `Eigen::Quaternion`
/// turns a rotation into a Quaternion.
template <Scalar S>
using Mat3 = Eigen::Matrix<S, 3, 3>;

/// u, the unit roundoff: |fl(x op y) - (x op y)| <= u |x op y|. It is 2^-24 for float and 2^-53 for double.
template <Scalar S>
inline constexpr S kUnitRoundoff = std::numeric_limits<S>::epsilon() / 2;

/// Infinity, for instance as the `t_max` of a ray.
template <Scalar S>
inline constexpr S kInfinity = std::numeric_limits<S>::infinity();

/// 2^e for any e. It is 0 for e below -1074, and infinite for e above 1023. It takes constant time.
///
/// @code
/// assert(graze::power_of_two(-3) == 0.125 && graze::power_of_two(2000) == graze::kInfinity<double>);
/// assert(graze::exponent_of(-0.2) == -3 && graze::exponent_of(8) == 3);  // 0.2 is between 2^-3 and 2^-2
/// assert(!graze::is_flushed(graze::power_of_two(-1074)));  // this machine keeps subnormal numbers
/// @endcode
[[nodiscard]] inline double power_of_two(int e) {
  if (e < -1022 || e > 1023) return std::ldexp(1.0, e);
  return detail::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}
/// floor(log2 |x|) for a finite x != 0, exact.
[[nodiscard]] inline int exponent_of(double x) {
  const int biased = static_cast<int>(detail::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
  return biased == 0 ? std::ilogb(x) : biased - 1023;
}

/// True if the machine takes the subnormal x for 0 (denormals-are-zero). A query would then compute with another number
/// than the caller gave, so it refuses a vector, an extent or a quaternion with such a number (Invalid::out_of_range).
template <Scalar S>
[[nodiscard]] inline bool is_flushed(S x) {
  using Bits = std::conditional_t<sizeof(S) == 8, std::uint64_t, std::uint32_t>;
  return x == 0 && static_cast<Bits>(detail::bit_cast<Bits>(x) << 1) != 0;
}

/// The direction n / |n| of a finite n, or 0 for n = 0. n is scaled first, so no square vanishes or overflows.
///
/// @code
/// const graze::Vec3<double> n = graze::unit(graze::Vec3<double>(0, 3e200, -4e200));
/// assert(std::abs(n[1] - 0.6) <= 4 * graze::kUnitRoundoff<double> && std::abs(n.norm() - 1) < 1e-15);
/// assert(graze::unit(graze::Vec3<float>(0, 0, 0)).isZero());
/// @endcode
template <Scalar S>
Vec3<S> unit(const Vec3<S>& n) {
  const S most = n.cwiseAbs().maxCoeff();
  if (!(most > 0)) return Vec3<S>::Zero();
  const Vec3<S> scaled = n / most;
  return scaled / detail::norm(scaled);
}

/// An orientation: the rotation x -> q x conj(q) / |q|^2 for any q = (w, x, y, z) other than 0.
///
/// The length of q does not matter. The rotation is rational in q, so a posed vertex is an exact rational. For
/// example, (1, 1, 0, 0) is exactly 90 degrees about x. An `Eigen::Quaternion` of the same scalar, or a Map of one,
/// converts to it number by number. graze itself does not include <Eigen/Geometry>.
///
/// @code
/// const graze::Quaternion<double> quarter_turn(1, 1, 0, 0), none;
/// assert(none.is_identity() && !quarter_turn.is_identity());
///
/// const graze::Mat3<double> matrix{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};  // a quarter turn about z
/// const graze::Quaternion<double> rounded = Eigen::Quaterniond(matrix);
/// assert(rounded.x == 0 && rounded.y == 0 && std::abs(rounded.w - rounded.z) < 1e-15);
/// @endcode
template <Scalar S>
struct Quaternion {
  S w = 1;  ///< Real part. The default is no rotation.
  S x = 0;  ///< Imaginary part along x.
  S y = 0;  ///< Imaginary part along y.
  S z = 0;  ///< Imaginary part along z.

  // g++ 12 crashes on a list of bodies in braces if it has to find out noexcept here or in Shape, and on Vec3's Zero() as
  // the default of their fields.
  constexpr Quaternion() noexcept = default;
  /// real + i, j and k times the imaginary units.
  constexpr Quaternion(S real, S i, S j, S k) : w(real), x(i), y(j), z(k) {}
  /// The same quaternion from Eigen.
  template <class Derived>
  requires std::same_as<typename Derived::Scalar, S> Quaternion(const Eigen::QuaternionBase<Derived>& q)
      : Quaternion(q.w(), q.x(), q.y(), q.z()) {}

  /// True for (w, 0, 0, 0) with any w, negative ones included.
  [[nodiscard]] bool is_identity() const { return x == 0 && y == 0 && z == 0; }
};

}}  // namespace graze::GRAZE_LINKAGE
