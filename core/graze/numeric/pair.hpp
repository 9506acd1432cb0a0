// Numbers as unevaluated sums hi + lo of two doubles, quick rather than neat.
//
// Nothing is normalised: |lo| may be a few u of what was added up, which cancellation in hi does not shrink,
// so errors are bounded by sizes, not by values. With |x| <= X, |x.lo| <= 2^-49 X, and likewise y:
//   x + y    within 2^-101 (X + Y):  the sum of the high parts is exact, two roundings among the low ones.
//            With P the power of two below m = 2^-49 (X + Y): u P for the low halves, and u P for what is
//            at most 17/16 m, or 2 u P if that is 2 P or more, when 3 u P <= 1.6 u m; 2 u m at most.
//   x y      within 2^-97 X Y:       the product of the high parts is exact, lo lo is left out (2^-98 X Y),
//            and three roundings of what is below 2^-47 X Y.
// Sums are Knuth's, products exact by Veltkamp or std::fma (offset.hpp).
#pragma once

#include <graze/numeric/offset.hpp>

namespace graze::inline GRAZE_LINKAGE::exact {

struct Pair {
  double hi, lo;  // not set unless given
};
using Pair3 = std::array<Pair, 3>;

// Exact.
inline Pair product(double a, double b) {
  const detail::TwoDoubles p = detail::two_product(a, b);
  return {p.hi, p.lo};
}
inline Pair difference(double a, double b) {
  const detail::TwoDoubles s = detail::two_sum(a, -b);
  return {s.hi, s.lo};
}

inline Pair operator+(const Pair& x, const Pair& y) {
  const detail::TwoDoubles s = detail::two_sum(x.hi, y.hi);
  return {s.hi, s.lo + (x.lo + y.lo)};
}
inline Pair operator-(const Pair& x) { return {-x.hi, -x.lo}; }
inline Pair operator-(const Pair& x, const Pair& y) { return x + -y; }
inline Pair operator*(const Pair& x, const Pair& y) {
  const detail::TwoDoubles p = detail::two_product(x.hi, y.hi);
  return {p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi)};
}
[[nodiscard]] inline double rounded(const Pair& x) { return x.hi + x.lo; }

inline Pair dot(const Pair3& a, const Pair3& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }
inline Pair3 cross(const Pair3& a, const Pair3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Pair3 scaled(const Pair3& x, const Pair& s) { return {x[0] * s, x[1] * s, x[2] * s}; }

}  // namespace graze::inline GRAZE_LINKAGE::exact
