// Numbers as unevaluated sums hi + lo of two doubles, quick rather than neat.
//
// Nothing is normalised: |lo| may be a few u of what was added up, which cancellation in hi does not shrink.
// So errors are bounded by sizes, not by values. With |x| <= X, |x.lo| <= 2^-49 X, and likewise y:
//   x + y    within 2^-101 (X + Y).  The sum of the high parts is exact, two roundings among the low ones.
//            Let P be the power of two below m = 2^-49 (X + Y). The low halves cost u P. Their sum is at most
//            17/16 m and costs u P, or 2 u P if it is 2 P or more, when 3 u P <= 1.6 u m. In all 2 u m at most.
//   x y      within 2^-97 X Y.       The product of the high parts is exact, lo lo is left out (2^-98 X Y),
//            and three roundings of what is below 2^-47 X Y.
// Sums are Knuth's. Products are exact by Veltkamp or std::fma (offset.hpp), or fused.
//
// Fused pairs are the same numbers, with products by one instruction (machine.hpp): 2 operations instead of 17. A
// caller that forms many of them calls fuses() once, and then runs one of two copies of the code. Both products are
// exact, so both copies have the same bits. Beyond 2^996 and below 2^-969 Veltkamp's is not exact. Its users stay
// within that range (exact_scene.hpp), or add what is far larger.
#pragma once

#include <graze/detail/numeric/offset.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// T: a double, or two of them side by side (machine.hpp), one of either body.
template <bool kFused, class T = double>
struct PairOf {
  T hi, lo;  // not set unless given
};
template <bool kFused, class T = double>
using Pair3Of = std::array<PairOf<kFused, T>, 3>;
using Pair = PairOf<false>;
using Pair3 = Pair3Of<false>;

// Exact. Fused: only where fuses().
template <bool kFused = false, class T = double>
PairOf<kFused, T> product(T a, T b) {
  const auto p = two_product<kFused>(a, b);
  return {p.hi, p.lo};
}
template <bool kFused = false>
PairOf<kFused> difference(double a, double b) {
  const TwoDoubles s = two_sum(a, -b);
  return {s.hi, s.lo};
}

// The same number.
template <bool kFused, bool kOther, class T>
PairOf<kFused, T> pair_as(const PairOf<kOther, T>& x) {
  return {x.hi, x.lo};
}
template <bool kFused, bool kOther, class T>
Pair3Of<kFused, T> pairs_as(const std::array<PairOf<kOther, T>, 3>& x) {
  return {pair_as<kFused>(x[0]), pair_as<kFused>(x[1]), pair_as<kFused>(x[2])};
}

template <bool kFused, class T>
PairOf<kFused, T> operator+(const PairOf<kFused, T>& x, const PairOf<kFused, T>& y) {
  const auto s = two_sum(x.hi, y.hi);
  return {s.hi, s.lo + (x.lo + y.lo)};
}
template <bool kFused, class T>
PairOf<kFused, T> operator-(const PairOf<kFused, T>& x) {
  return {-x.hi, -x.lo};
}
template <bool kFused, class T>
PairOf<kFused, T> operator-(const PairOf<kFused, T>& x, const PairOf<kFused, T>& y) {
  return x + -y;
}
template <bool kFused, class T>
PairOf<kFused, T> operator*(const PairOf<kFused, T>& x, const PairOf<kFused, T>& y) {
  const PairOf<kFused, T> p = product<kFused>(x.hi, y.hi);
  return {p.hi, p.lo + (fl(x.hi * y.lo) + fl(x.lo * y.hi))};
}
template <bool kFused>
[[nodiscard]] double rounded(const PairOf<kFused>& x) {
  return x.hi + x.lo;
}

template <bool kFused, class T>
PairOf<kFused, T> dot(const std::array<PairOf<kFused, T>, 3>& a, const std::array<PairOf<kFused, T>, 3>& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
template <bool kFused, class T>
Pair3Of<kFused, T> cross(const std::array<PairOf<kFused, T>, 3>& a,
                         const std::array<PairOf<kFused, T>, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Pair3 scaled(const Pair3& x, const Pair& s) { return {x[0] * s, x[1] * s, x[2] * s}; }

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
