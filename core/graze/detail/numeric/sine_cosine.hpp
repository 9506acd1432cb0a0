// Sine, cosine and hypotenuse without libm, whose last digits differ from one system to the next.
//
// The angle is reduced by multiples of pi/2 in three doubles (Cody and Waite 1980). In two doubles, Taylor's series
// takes an eighth of the remainder. Its last terms are of size 2^-105. Three doublings restore the angle.
#pragma once

#include <graze/detail/numeric/pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <class Number>
struct SineCosine {
  Number sine, cosine;
};
// Takes the nearest multiple of pi/2 from x >= 0, and returns how many they are.
inline std::int64_t remove_quarters(TwoDoubles& x) {
  constexpr double kToInteger = 0x1p52;  // above it doubles are integers
  const double quarters = (fl(x.hi * 0x1.45f306dc9c883p-1) + kToInteger) - kToInteger;
  // Pi/2 in three doubles, each in two halves of at most 26 bits.
  struct Part {
    double high, low;
  };
  constexpr Part kParts[] = {
      {0x1.921fb5p+0, 0x4442d18p-52}, {0x1.1a6263p-54, 0x3145c07p-106}, {-0x1.f1976bp-110, -0x7ed8fbcp-162}};
  for (const Part& part : kParts) {
    const double whole = part.high + part.low, product = fl(quarters * whole);
    // A number of 27 bits times a half is exact, and so is each difference (Dekker 1971).
    const double rest = (quarters * part.high - product) + quarters * part.low;
    x = x + -(quarters < 0x1p27 ? TwoDoubles{product, rest} : two_product(quarters, whole));
  }
  return static_cast<std::int64_t>(quarters);
}
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
  const double tail =
      -0x1.ae64567f544e4p-26 +
      fl(z * (0x1.6124613a86d09p-33 + fl(z * (-0x1.ae7f3e733b81fp-41 + fl(z * 0x1.952c77030ad4ap-49)))));
  TwoDoubles sum = of(z * tail) + TwoDoubles{0x1.71de3a556c734p-19, -0x1.c154f8ddc6c00p-73};
  sum = q * sum + TwoDoubles{-0x1.a01a01a01a01ap-13, -0x1.a01a01a01a01ap-73};
  sum = q * sum + TwoDoubles{0x1.1111111111111p-7, 0x1.1111111111111p-63};
  sum = q * sum + TwoDoubles{-0x1.5555555555555p-3, -0x1.5555555555555p-57};
  return x + x * (q * sum);
}
// cos x - 1. From x^12 on a double is enough.
inline TwoDoubles cosine_less_one(TwoDoubles q) {
  const double z = q.hi;
  const double tail =
      0x1.1eed8eff8d898p-29 + fl(z * (-0x1.93974a8c07c9dp-37 + fl(z * 0x1.ae7f3e733b81fp-45)));
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
  for (std::size_t i = N - 1; i-- > 0;) sum = c[i] + fl(z * sum);
  return sum;
}

}  // namespace series

// x >= 0, at most kMostTurn / 2.
inline SineCosine<TwoDoubles> sine_cosine(TwoDoubles x) {
  using series::of;
  const std::int64_t quarters = remove_quarters(x);
  const TwoDoubles eighth{x.hi / 8, x.lo / 8}, q = eighth * eighth;
  TwoDoubles s = series::sine(eighth, q), less = series::cosine_less_one(q);
  for (int doubling = 0; doubling < 3; ++doubling) {
    // sin 2y = 2 (sin y + sin y (cos y - 1)), cos 2y - 1 = -2 sin^2 y: no digits are lost where y is small.
    const TwoDoubles twice = s + s * less, square = s * s;
    s = {2 * twice.hi, 2 * twice.lo};
    less = {-2 * square.hi, -2 * square.lo};
  }
  return after_quarters(quarters, s, of(1) + less);
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
  const std::int64_t quarters = x.hi > 0.785 ? remove_quarters(x) : 0;
  const double r = x.hi, e = x.lo, z = r * r;
  const double of_sine = series::horner(z, {-1 / 6., 1 / 120., -1 / 5040., 1 / 362880., -1 / 39916800.,
                                            1 / 6227020800., -1 / 1307674368000., 1 / 355687428096000.});
  const double of_cosine = series::horner(z, {1 / 24., -1 / 720., 1 / 40320., -1 / 3628800., 1 / 479001600.,
                                              -1 / 87178291200., 1 / 20922789888000.});
  const double s = r + (fl(r * z * of_sine) + fl(e * (1 - z / 2)));
  const double w = 1 - z / 2, c = w + (((1 - w) - z / 2) + (fl(z * z * of_cosine) - fl(r * e)));
  return after_quarters(quarters, s, c);
}

// The angle x has any sign, and at most the size above.
inline SineCosine<double> rounded_sine_cosine(double x) {
  const SineCosine<double> out = rounded_sine_cosine(TwoDoubles{std::abs(x), 0});
  return {std::copysign(1.0, x) * out.sine, out.cosine};
}

// sqrt(x^2 + y^2), within 2 u: a power of two keeps the squares in range.
inline double hypotenuse(double x, double y) {
  const double most = std::max(std::abs(x), std::abs(y));
  if (!(most > 0 && most < kInfinity<double>)) return most;
  const int k = exponent_of(most);
  const double down = power_of_two(-k), a = x * down, b = y * down;
  return square_root(fl(a * a) + fl(b * b)) * power_of_two(k);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
