// Computes the rotation by a rotation vector w over time t: the quaternion (cos(|w| t/2), sin(|w| t/2) w/|w|), as
// sums of two doubles.
//
// Error: turn_error, 2^-90 and 2^-98 of the angle, up to kMostTurn radians. The half angle is reduced by multiples of
// pi/2 in three doubles (Cody and Waite 1980). Taylor's series takes an eighth of the remainder. Its last terms are
// of size 2^-105. Three doublings restore the angle. Nothing here uses libm, so the bits are the same everywhere and
// under contraction (offset.hpp).
#pragma once

#include <graze/detail/numeric/pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Beyond, one unit in the last place of t would be many turns for a body of any size.
inline constexpr double kMostTurn = 0x1p30;

// Error bound of a rotated point's position, relative to its distance from the pivot. A wrong angle moves a point by
// as much. The angle is within 2^-102 of itself: |w|^2 is three exact products and two sums (2^-103.4), its root a
// Newton step (2^-104), and the product with t adds 2^-103.7. 2^-98 leaves room. The reduced angle is within 2^-104
// more. The series, the doublings and the rotation of a point add up to 2^-90.
[[nodiscard]] constexpr double turn_error(double angle) { return 0x1p-90 + 0x1p-98 * angle; }

template <class Number>
struct SineCosine {
  Number sine, cosine;
};
// The sine and cosine of the angle with that sine and cosine plus the given number of quarter turns.
template <class Number>
SineCosine<Number> after_quarters(std::int64_t quarters, const Number& s, const Number& c) {
  switch (quarters & 3) {
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

namespace series {

inline TwoDoubles of(double x) { return {x, 0}; }

// x (1 - x^2/3! + ...), |x| < 0.0983. q = x^2 as two doubles. From x^11 on a double is enough: those terms are below
// 2^-55 of x.
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
// cos x - 1. From x^12 on a double is enough.
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

// c_0 + c_1 z + ...
template <std::size_t N>
double horner(double z, const double (&c)[N]) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = c[i] + z * sum;
  return sum;
}

}  // namespace series

// x >= 0, at most kMostTurn / 2.
inline SineCosine<TwoDoubles> sine_cosine(TwoDoubles x) {
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
  return after_quarters(static_cast<std::int64_t>(quarters), s, of(1) + less);
}

// Rounded: each within u. x as above, but of twice the size.
//
// The remainder of x after whole quarter turns is r + e, |r| <= 0.7855, |e| <= u |r|, which differs from the exact
// one by at most turn_error.
//
// Sine: r z S(z), z = r^2, is at most 0.1 |r| and known to 6 u of itself, 0.48 u. The term e (1 - z/2) leaves 0.02 u,
// the series' next term less, and the last sum rounds by u/2, being below 1.
//
// Cosine: z/2 is within u/4. The rounding of 1 - z/2 is corrected exactly. z^2 C(z) is at most 0.016, within 0.1 u,
// and the last sum adds u/2 again.
inline SineCosine<double> rounded_sine_cosine(TwoDoubles x) {
  std::int64_t quarter = 0;
  if (x.hi > 0.785) {
    const double quarters = std::nearbyint(x.hi * 0x1.45f306dc9c883p-1);
    for (const double part : {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110}) {
      x = x + -two_product(quarters, part);
    }
    quarter = static_cast<std::int64_t>(quarters);
  }
  const double r = x.hi, e = x.lo, z = r * r;
  const double of_sine = series::horner(z, {-1 / 6., 1 / 120., -1 / 5040., 1 / 362880., -1 / 39916800.,
                                            1 / 6227020800., -1 / 1307674368000., 1 / 355687428096000.});
  const double of_cosine = series::horner(z, {1 / 24., -1 / 720., 1 / 40320., -1 / 3628800., 1 / 479001600.,
                                              -1 / 87178291200., 1 / 20922789888000.});
  const double s = r + (r * z * of_sine + e * (1 - z / 2));
  const double w = 1 - z / 2, c = w + (((1 - w) - z / 2) + (z * z * of_cosine - r * e));
  return after_quarters(quarter, s, c);
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
    const SineCosine<TwoDoubles> angle = sine_cosine(half_ * TwoDoubles{t, 0});
    return {angle.cosine, {angle.sine * axis_[0], angle.sine * axis_[1], angle.sine * axis_[2]}};
  }
  // |w| t, and w / |w|, within 2^-100 of themselves. Requires w != 0.
  [[nodiscard]] TwoDoubles angle(double t) const {
    return TwoDoubles{2 * half_.hi, 2 * half_.lo} * TwoDoubles{t, 0};
  }
  [[nodiscard]] const TwoDoubles3& axis() const { return axis_; }

 private:
  TwoDoubles half_{};  // |w| / 2
  TwoDoubles3 axis_{};
};

// R(w t) R(q) for many t, in doubles. A rotation leaves the part of a column of R(q) along its axis a, and rotates
// the rest:
//   along + cos |w| t across + sin |w| t aside,   along = a a^T R(q), across = R(q) - along, aside = a x R(q).
// Each entry is within 7 u. The three matrices are made in pairs and rounded once. In an entry across^2 + aside^2 <=
// 1, so the roundings of both and of the products add up to u each (Cauchy). Sine and cosine add sqrt(2) u. The
// roundings of the inner sum, of `along` and of the outer sum add u each: 6.42 u.
class TurnedRotation {
 public:
  TurnedRotation() = default;
  TurnedRotation(const TurnsAbout& turns, const Quaternion<double>& q) {
    fuses() ? prepare<true>(turns, q) : prepare<false>(turns, q);
  }
  // R(q), each entry within 0.6 u.
  [[nodiscard]] const Mat3<double>& start() const { return start_; }
  // turns: the rotation that this object was made for.
  [[nodiscard]] Mat3<double> at(const TurnsAbout& turns, double t) const {
    const SineCosine<double> angle = rounded_sine_cosine(turns.angle(t));
    return along_ + (angle.cosine * across_ + angle.sine * aside_);
  }

 private:
  template <bool kFused>
  [[gnu::flatten]] void prepare(const TurnsAbout& turns, const Quaternion<double>& q) {
    using Pair = exact::PairOf<kFused>;
    using Pair3 = exact::Pair3Of<kFused>;
    const auto product = [](double a, double b) { return exact::product<kFused>(a, b); };
    const auto scaled = [](const Pair3& x, const Pair& by) { return Pair3{x[0] * by, x[1] * by, x[2] * by}; };
    const Pair ww = product(q.w, q.w), xx = product(q.x, q.x), yy = product(q.y, q.y), zz = product(q.z, q.z),
               norm = (ww + xx) + (yy + zz);
    const TwoDoubles inverse = TwoDoubles{1, 0} / two_sum(norm.hi, norm.lo);
    const Pair over{inverse.hi, inverse.lo}, twice_over{2 * over.hi, 2 * over.lo};
    const auto mixed = [&](double a, double b, double c, double d) {
      return (product(a, b) + product(c, d)) * twice_over;
    };
    const std::array<Pair3, 3> column = {
        Pair3{((ww + xx) - (yy + zz)) * over, mixed(q.x, q.y, q.w, q.z), mixed(q.x, q.z, -q.w, q.y)},
        Pair3{mixed(q.x, q.y, -q.w, q.z), ((ww + yy) - (xx + zz)) * over, mixed(q.y, q.z, q.w, q.x)},
        Pair3{mixed(q.x, q.z, q.w, q.y), mixed(q.y, q.z, -q.w, q.x), ((ww + zz) - (xx + yy)) * over}};
    Pair3 axis;
    for (std::size_t i = 0; i < 3; ++i) axis[i] = {turns.axis()[i].hi, turns.axis()[i].lo};
    for (std::size_t j = 0; j < 3; ++j) {
      const Pair3 lasting = scaled(axis, exact::dot(axis, column[j])), turned = exact::cross(axis, column[j]);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto r = static_cast<int>(i), c = static_cast<int>(j);
        start_(r, c) = exact::rounded(column[j][i]);
        along_(r, c) = exact::rounded(lasting[i]);
        across_(r, c) = exact::rounded(column[j][i] - lasting[i]);
        aside_(r, c) = exact::rounded(turned[i]);
      }
    }
  }

  Mat3<double> start_ = Mat3<double>::Identity();
  Mat3<double> along_ = Mat3<double>::Zero(), across_ = Mat3<double>::Zero(), aside_ = Mat3<double>::Zero();
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
