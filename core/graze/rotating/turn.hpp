// Rotation by a rotation vector w over time t: the quaternion (cos(|w| t/2), sin(|w| t/2) w/|w|), as sums of
// two doubles.
//
// Error: turn_error, 2^-90 and 2^-98 of the angle, up to kMostTurn radians. The half angle is reduced by
// multiples of pi/2 in three doubles (Cody and Waite 1980), an eighth of what is left goes into Taylor's
// series, whose last terms are of size 2^-105, and three doublings bring it back. Nothing here is libm's, so
// the bits are the same everywhere and under contraction (offset.hpp).
#pragma once

#include <graze/numeric/offset.hpp>

namespace graze::inline GRAZE_LINKAGE::detail {

// Beyond, one unit in the last place of t would be many turns for a body of any size.
inline constexpr double kMostTurn = 0x1p30;

// How far a turned point may be from where it should be, over its distance from the pivot. A wrong angle
// moves a point by as much, and the angle is within 2^-102 of itself: |w|^2 is three exact products and two
// sums (2^-103.4), its root a step of Newton's (2^-104), and the product with t adds 2^-103.7. 2^-98 leaves
// room. The reduced angle is within 2^-104 more, and the series, the doublings and what turns a point come to
// 2^-90.
[[nodiscard]] constexpr double turn_error(double angle) { return 0x1p-90 + 0x1p-98 * angle; }

struct SineCosine {
  TwoDoubles sine, cosine;
};

namespace series {

inline TwoDoubles of(double x) { return {x, 0}; }

// x (1 - x^2/3! + ...), |x| < 0.0983; q = x^2 as two doubles. From x^11 on a double is enough: those terms
// are below 2^-55 of x.
inline TwoDoubles sine(TwoDoubles x, TwoDoubles q) {
  const double z = q.hi;
  const double tail = -0x1.ae64567f544e4p-26 +
                      z * (0x1.6124613a86d09p-33 + z * (-0x1.ae7f3e733b81fp-41 + z * 0x1.952c77030ad4ap-49));
  TwoDoubles sum = of(z * tail) + TwoDoubles{0x1.71de3a556c734p-19, -0x1.c154f8ddc6c00p-73};
  sum = q * sum + TwoDoubles{-0x1.a01a01a01a01ap-13, -0x1.a01a01a01a01ap-73};
  sum = q * sum + TwoDoubles{0x1.1111111111111p-7, 0x1.1111111111111p-63};
  sum = q * sum + TwoDoubles{-0x1.5555555555555p-3, -0x1.5555555555555p-57};
  return x + x * (q * sum);
}
// cos x - 1; from x^12 on a double is enough.
inline TwoDoubles cosine_less_one(TwoDoubles q) {
  const double z = q.hi;
  const double tail = 0x1.1eed8eff8d898p-29 + z * (-0x1.93974a8c07c9dp-37 + z * 0x1.ae7f3e733b81fp-45);
  TwoDoubles sum = of(z * tail) + TwoDoubles{-0x1.27e4fb7789f5cp-22, -0x1.cbbc05b4fa99ap-76};
  sum = q * sum + TwoDoubles{0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76};
  sum = q * sum + TwoDoubles{-0x1.6c16c16c16c17p-10, 0x1.f49f49f49f49fp-65};
  sum = q * sum + TwoDoubles{0x1.5555555555555p-5, 0x1.5555555555555p-59};
  sum = q * sum + TwoDoubles{-0.5, 0};
  return q * sum;
}

}  // namespace series

// x >= 0, at most kMostTurn / 2.
inline SineCosine sine_cosine(TwoDoubles x) {
  using series::of;
  const double quarters = std::nearbyint(x.hi * 0x1.45f306dc9c883p-1);
  for (const double part : {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110}) {
    x = x + -two_product(quarters, part);
  }
  const TwoDoubles eighth{x.hi / 8, x.lo / 8}, q = eighth * eighth;
  TwoDoubles s = series::sine(eighth, q), less = series::cosine_less_one(q);
  for (int doubling = 0; doubling < 3; ++doubling) {
    // sin 2y = 2 (sin y + sin y (cos y - 1)), cos 2y - 1 = -2 sin^2 y: no digits are lost where y is small.
    const TwoDoubles twice = s + s * less, square = s * s;
    s = {2 * twice.hi, 2 * twice.lo};
    less = {-2 * square.hi, -2 * square.lo};
  }
  const TwoDoubles c = of(1) + less;
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

// sqrt(x), x > 0, within 2^-100: one step of Newton's on the double's root.
inline TwoDoubles root(TwoDoubles x) {
  const double first = std::sqrt(x.hi);
  if (!(first > 0)) return {};
  const TwoDoubles rest = x + -two_product(first, first);
  return two_sum(first, rest.hi / (2 * first));
}

// A unit quaternion w + (x, y, z), as sums of two doubles.
struct Turn {
  TwoDoubles w{1, 0};
  TwoDoubles3 v{};

  [[nodiscard]] TwoDoubles3 operator()(const TwoDoubles3& x) const {
    const TwoDoubles3 once = cross(v, x), twice = cross(v, once);
    TwoDoubles3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const TwoDoubles moved = w * once[i] + twice[i];
      out[i] = x[i] + TwoDoubles{2 * moved.hi, 2 * moved.lo};
    }
    return out;
  }
  // First `right`, then this; rounded to doubles. `right` of any length: so is the result.
  [[nodiscard]] Quaternion<double> after(const Quaternion<double>& right) const {
    const TwoDoubles rw{right.w, 0};
    const TwoDoubles3 rv{TwoDoubles{right.x, 0}, TwoDoubles{right.y, 0}, TwoDoubles{right.z, 0}};
    const TwoDoubles3 both = cross(v, rv);
    TwoDoubles scalar = w * rw;
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
      scalar = scalar + -(v[i] * rv[i]);
      const TwoDoubles sum = (w * rv[i] + v[i] * rw) + both[i];
      out[i] = sum.hi + sum.lo;
    }
    return {scalar.hi + scalar.lo, out[0], out[1], out[2]};
  }

 private:
  static TwoDoubles3 cross(const TwoDoubles3& l, const TwoDoubles3& r) {
    TwoDoubles3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      out[i] = l[j] * r[k] + -(l[k] * r[j]);
    }
    return out;
  }
};

// Turns about a fixed axis, prepared once: w of any magnitude in the door's range, 0 too.
class TurnsAbout {
 public:
  explicit TurnsAbout(const Vec3<double>& w) {
    const double most = w.cwiseAbs().maxCoeff();
    if (!(most > 0)) return;
    const int k = exponent_of(most);
    TwoDoubles square;
    for (int i = 0; i < 3; ++i) {
      const double x = w[i] * power_of_two(-k);
      square = square + two_product(x, x);
    }
    const TwoDoubles length = root(square);
    for (std::size_t i = 0; i < 3; ++i) {
      axis_[i] = TwoDoubles{w[static_cast<int>(i)] * power_of_two(-k), 0} / length;
    }
    half_ = {length.hi * power_of_two(k - 1), length.lo * power_of_two(k - 1)};
  }
  [[nodiscard]] bool turns() const { return half_.hi > 0; }
  [[nodiscard]] Turn at(double t) const {
    if (!turns()) return {};
    const SineCosine angle = sine_cosine(half_ * TwoDoubles{t, 0});
    return {angle.cosine, {angle.sine * axis_[0], angle.sine * axis_[1], angle.sine * axis_[2]}};
  }

 private:
  TwoDoubles half_{};  // |w| / 2
  TwoDoubles3 axis_{};
};

}  // namespace graze::inline GRAZE_LINKAGE::detail
