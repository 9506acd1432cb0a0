// The offset between two posed frames, with large common parts removed before they can cost accuracy.
//
//   offset = (p_B + R_B c_B) - (p_A + R_A c_A),   error <= 2 u |offset| + 2^-97 (|c_A| + |c_B|),
//
// as p_B - p_A is exact, the rotations are within 2^-98 of |c| and the two sums after them within 2^-100 of what
// they add up, at most |offset| + 2 (|c_A| + |c_B|). It is computed as an unevaluated sum hi + lo of two doubles
// (Dekker 1971, and Knuth, TAOCP 2, 4.2.2). Sums are Knuth's. Products use std::fma if the compiler has it (and may
// contract), and otherwise Veltkamp's splitting (and it cannot). Every product that goes into a sum is rounded before
// (machine.hpp), so contraction changes no result. The splitting is exact for |x| < 2^996.
#pragma once

#include <array>
#include <cmath>
#include <graze/detail/numeric/machine.hpp>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct TwoDoubles {
  double hi = 0, lo = 0;
};
// Operations on two numbers side by side.
struct TwoDoublesOfTwo {
  TwoLanes hi, lo;
};

// a + b = hi + lo exactly (Knuth). A product is rounded before it is added twice.
inline TwoDoubles two_sum(double a, double b) {
  a = fl(a);
  b = fl(b);
  const double hi = a + b, bb = hi - a;
  return {hi, (a - (hi - bb)) + (b - bb)};
}
inline TwoDoublesOfTwo two_sum(TwoLanes a, TwoLanes b) {
  const TwoLanes hi = a + b, bb = hi - a;
  return {hi, (a - (hi - bb)) + (b - bb)};
}

// a b = hi + lo exactly, barring underflow. Fused: only where fuses().
template <bool kFused = false>
TwoDoubles two_product(double a, double b) {
  // Rounded as it is: fused with a sum that it goes into later it would be another number there than here.
  const double hi = fl(a * b);
#if GRAZE_FUSES_IF_THERE
  if constexpr (kFused) return {hi, fused_difference(a, b, hi)};
#endif
#if defined(__FMA__) || defined(__FP_FAST_FMA) || defined(__ARM_FEATURE_FMA)
  return {hi, std::fma(a, b, -hi)};
#else
  // Without the instruction std::fma is a call. The halves have 26 bits, so their products are exact.
  constexpr double kSplit = 0x1p27 + 1;
  const double p = fl(kSplit * a), q = fl(kSplit * b);
  const double a_hi = p - (p - a), a_lo = a - a_hi, b_hi = q - (q - b), b_lo = b - b_hi;
  return {hi, ((fl(a_hi * b_hi) - hi) + fl(a_hi * b_lo) + fl(a_lo * b_hi)) + fl(a_lo * b_lo)};
#endif
}
template <bool kFused = false>
TwoDoublesOfTwo two_product(TwoLanes a, TwoLanes b) {
#if GRAZE_FUSES_IF_THERE
  if constexpr (kFused) {
    const TwoLanes hi = fl(a * b);
    return {hi, fused_difference(a, b, hi)};
  }
#endif
  const TwoDoubles p = two_product<kFused>(a[0], b[0]), q = two_product<kFused>(a[1], b[1]);
  return {TwoLanes{p.hi, q.hi}, TwoLanes{p.lo, q.lo}};
}

// Relative errors below 2^-100 for each of these (Joldes, Muller, Popescu 2017, algorithms 6, 10 and 17).
inline TwoDoubles operator+(TwoDoubles x, TwoDoubles y) {
  const TwoDoubles s = two_sum(x.hi, y.hi), t = two_sum(x.lo, y.lo);
  const TwoDoubles v = two_sum(s.hi, s.lo + t.hi);
  return two_sum(v.hi, t.lo + v.lo);
}
inline TwoDoubles operator-(TwoDoubles x) { return {-x.hi, -x.lo}; }
template <bool kFused>
TwoDoubles multiplied(TwoDoubles x, TwoDoubles y) {
  const TwoDoubles p = two_product<kFused>(x.hi, y.hi);
  return two_sum(p.hi, p.lo + (fl(x.lo * y.hi) + fl(x.hi * y.lo)));
}
template <bool kFused>
TwoDoubles divided(TwoDoubles x, TwoDoubles y) {
  const double first = x.hi / y.hi;
  const TwoDoubles rest = x + -multiplied<kFused>(y, TwoDoubles{first, 0});
  return two_sum(first, rest.hi / y.hi);
}
inline TwoDoubles operator*(TwoDoubles x, TwoDoubles y) { return multiplied<false>(x, y); }
inline TwoDoubles operator/(TwoDoubles x, TwoDoubles y) { return divided<false>(x, y); }

// x t for a time of any size: a double from 2^996 on has no halves.
inline TwoDoubles times(TwoDoubles x, double t) {
  const double power = t > 0x1p500 ? 0x1p500 : 1.0;
  return TwoDoubles{x.hi * power, x.lo * power} * TwoDoubles{t / power, 0};
}

using TwoDoubles3 = std::array<TwoDoubles, 3>;
inline TwoDoubles3 operator+(const TwoDoubles3& x, const TwoDoubles3& y) {
  return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}
inline TwoDoubles3 operator-(const TwoDoubles3& x) { return {-x[0], -x[1], -x[2]}; }
inline TwoDoubles3 exactly(const Vec3<double>& x) {
  return {TwoDoubles{x[0], 0}, TwoDoubles{x[1], 0}, TwoDoubles{x[2], 0}};
}
inline Vec3<double> rounded_once(const TwoDoubles3& x) {
  return {x[0].hi + x[0].lo, x[1].hi + x[1].lo, x[2].hi + x[2].lo};
}
// By a power of two: exact.
inline TwoDoubles3 scaled_by(TwoDoubles3 x, double power) {
  for (TwoDoubles& one : x) one = {one.hi * power, one.lo * power};
  return x;
}

// The part of that error which the centres leave, over their lengths, however near they cancel.
inline constexpr double kOffsetOfCenters = 0x1p-97;

// R(q) c with relative error below 2^-98 |c|:  c + 2 (w (u x c) + u x (u x c)) / |q|^2,  q = (w, u).
template <bool kFused>
[[gnu::flatten]] inline TwoDoubles3 rotated_in_pairs(const Quaternion<double>& q, const Vec3<double>& c) {
  const auto times = [](const TwoDoubles& x, const TwoDoubles& y) { return multiplied<kFused>(x, y); };
  const TwoDoubles w{q.w, 0}, u[3] = {{q.x, 0}, {q.y, 0}, {q.z, 0}};
  TwoDoubles norm = times(w, w);
  for (const TwoDoubles& one : u) norm = norm + times(one, one);
  const auto cross = [&](const TwoDoubles3& x) {
    TwoDoubles3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      out[i] = times(u[j], x[k]) + -times(u[k], x[j]);
    }
    return out;
  };
  const TwoDoubles3 given = {TwoDoubles{c[0], 0}, TwoDoubles{c[1], 0}, TwoDoubles{c[2], 0}};
  const TwoDoubles3 once = cross(given), twice = cross(once);
  TwoDoubles3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const TwoDoubles turned = divided<kFused>(times(w, once[i]) + twice[i], norm);
    out[i] = given[i] + (turned + turned);
  }
  return out;
}
inline TwoDoubles3 rotate_accurately(const Quaternion<double>& q, const Vec3<double>& c) {
  return fuses() ? rotated_in_pairs<true>(q, c) : rotated_in_pairs<false>(q, c);
}

// R(q), each entry within 9 u. The numerators are within 4 u |q|^2, as three sums of rounded products whose
// magnitudes add up to at most |q|^2. The divisor |q|^2 is within 4 u relatively, the quotient rounds once, and no
// entry exceeds 1.
inline Mat3<double> rotation_matrix(const Quaternion<double>& q) {
  const double ww = fl(q.w * q.w), xx = fl(q.x * q.x), yy = fl(q.y * q.y), zz = fl(q.z * q.z),
               xy = fl(q.x * q.y), xz = fl(q.x * q.z), yz = fl(q.y * q.z), wx = fl(q.w * q.x),
               wy = fl(q.w * q.y), wz = fl(q.w * q.z);
  Mat3<double> r;
  r << ww + xx - yy - zz, 2 * (xy - wz), 2 * (xz + wy),  //
      2 * (xy + wz), ww - xx + yy - zz, 2 * (yz - wx),   //
      2 * (xz - wy), 2 * (yz + wx), ww - xx - yy + zz;
  return r / (ww + xx + yy + zz);
}

// The rows of R(q): numerators, |q|^2 and the quotients as sums of two doubles, within 2^-98.
inline std::array<TwoDoubles3, 3> rotation_rows(const Quaternion<double>& q) {
  const TwoDoubles ww = two_product(q.w, q.w), xx = two_product(q.x, q.x), yy = two_product(q.y, q.y),
                   zz = two_product(q.z, q.z), norm = (ww + xx) + (yy + zz);
  const auto twice = [&](double a, double b, double c, double d) {
    const TwoDoubles sum = two_product(a, b) + two_product(c, d);
    return TwoDoubles{2 * sum.hi, 2 * sum.lo} / norm;
  };
  return {
      TwoDoubles3{((ww + xx) + -(yy + zz)) / norm, twice(q.x, q.y, -q.w, q.z), twice(q.x, q.z, q.w, q.y)},
      TwoDoubles3{twice(q.x, q.y, q.w, q.z), ((ww + yy) + -(xx + zz)) / norm, twice(q.y, q.z, -q.w, q.x)},
      TwoDoubles3{twice(q.x, q.z, -q.w, q.y), twice(q.y, q.z, q.w, q.x), ((ww + zz) + -(xx + yy)) / norm}};
}

// R(q), each entry within 0.6 u: rounded once.
inline Mat3<double> accurate_rotation_matrix(const Quaternion<double>& q) {
  const std::array<TwoDoubles3, 3> rows = rotation_rows(q);
  Mat3<double> r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r(static_cast<int>(i), static_cast<int>(j)) = rows[i][j].hi + rows[i][j].lo;
    }
  }
  return r;
}

// True for the 24 rotations that permute the axes with signs: one, two or four components, all of one
// magnitude. Their matrix is exact.
inline bool permutes_axes(const Quaternion<double>& q) {
  double magnitude = 0;
  int count = 0;
  for (const double c : {q.w, q.x, q.y, q.z}) {
    if (c == 0) continue;
    if (count > 0 && std::abs(c) != magnitude) return false;
    magnitude = std::abs(c);
    ++count;
  }
  return count == 1 || count == 2 || count == 4;
}

inline Vec3<double> accurate_offset(const Vec3<double>& p_a, const Quaternion<double>& q_a,
                                    const Vec3<double>& c_a, const Vec3<double>& p_b,
                                    const Quaternion<double>& q_b, const Vec3<double>& c_b) {
  const bool off_a = c_a.cwiseAbs().maxCoeff() > 0, off_b = c_b.cwiseAbs().maxCoeff() > 0;
  if (!off_a && !off_b) return p_b - p_a;
  const auto posed = [](const Quaternion<double>& q, const Vec3<double>& c) {
    if (q.is_identity()) return TwoDoubles3{TwoDoubles{c[0], 0}, TwoDoubles{c[1], 0}, TwoDoubles{c[2], 0}};
    return rotate_accurately(q, c);
  };
  const TwoDoubles3 a = posed(q_a, c_a), b = posed(q_b, c_b);
  Vec3<double> out;
  for (int i = 0; i < 3; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const TwoDoubles sum = two_sum(p_b[i], -p_a[i]) + (b[k] + -a[k]);
    out[i] = sum.hi + sum.lo;
  }
  return out;
}

// p + R(q) c, within 2 u of itself and 2^-97 of |c|. For a body whose centre is farther from its origin
// than it is large: its position may cancel what the rotation makes of the centre.
inline Vec3<double> placed_center(const Vec3<double>& p, const Quaternion<double>& q, const Vec3<double>& c) {
  const Vec3<double> zero = Vec3<double>::Zero();
  return accurate_offset(zero, Quaternion<double>{}, zero, p, q, c);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
