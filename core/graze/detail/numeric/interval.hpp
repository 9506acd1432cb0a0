// Intervals of doubles that are not rounded outwards: a caller compares with a slack above the rounding of what it forms.
#pragma once

#include <algorithm>
#include <graze/detail/numeric/machine.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The numbers between lo and hi. Rounding is covered by the slack of the caller's comparison.
struct Interval {
  double lo = 0, hi = 0;
  Interval() = default;
  Interval(double x) : lo(x), hi(x) {}  // NOLINT: a number is one
  Interval(double l, double h) : lo(l), hi(h) {}
};
inline Interval fl(Interval x) { return {fl(x.lo), fl(x.hi)}; }
inline Interval operator+(Interval x, Interval y) { return {x.lo + y.lo, x.hi + y.hi}; }
inline Interval operator-(Interval x, Interval y) { return {x.lo - y.hi, x.hi - y.lo}; }
inline Interval operator-(Interval x) { return {-x.hi, -x.lo}; }
inline Interval operator*(double s, Interval x) {
  return s >= 0 ? Interval{s * x.lo, s * x.hi} : Interval{s * x.hi, s * x.lo};
}
inline Interval operator*(Interval x, Interval y) {
  const double a = x.lo * y.lo, b = x.lo * y.hi, c = x.hi * y.lo, d = x.hi * y.hi;
  return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
}
inline Interval square(Interval x) {
  const double a = x.lo * x.lo, b = x.hi * x.hi;
  return {x.lo <= 0 && x.hi >= 0 ? 0 : std::min(a, b), std::max(a, b)};
}
inline double square(double x) { return x * x; }
inline double largest(Interval x) { return std::max(-x.lo, x.hi); }
inline Interval clipped(Interval x, double lo, double hi) {
  return {std::min(std::max(x.lo, lo), hi), std::max(std::min(x.hi, hi), lo)};
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
