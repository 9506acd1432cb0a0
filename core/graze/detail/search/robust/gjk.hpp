// distance(x, C) = min |c - x| over c in C, for the core C of a CSO: GJK.
// Units: internal (cso.hpp).   Frame: world axes.
//
// Guarantee: lower <= distance <= upper, up to `Cso::reach_error` and a few u |x|. Both hold at every
// step: upper is the length of a convex combination of points of C - x, lower = n.x - h(n) for a unit n.
// Notation   y = w - x.   v = the simplex's point closest to 0.   n = unit vector from the simplex to x.
// Stops when upper - lower <= gap. [Gilbert, Johnson, Keerthi 1988, and van den Bergen 2003, 4.3]
// Differs: a step that neither adds a point nor brings v nearer ends the search with the bracket that it has.
#pragma once

#include <graze/detail/search/robust/simplex.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct Distance {
  S lower = 0, upper = kInfinity<S>;
  Vec3<S> n = Vec3<S>::Zero();  // unit, from C to x, proves lower (zero if nothing does)
  bool stalled = false;         // the gap was not closed
};

// `support(n)` is the core's, or that of a set made from it. `simplex` may come from a former call (of any x) as a
// warm start. If it is empty, the search begins along `start`. On return it holds the closest feature. It stops early
// once upper <= near_enough. With lower > near_enough it also stops once upper - lower <= loose_gap: a tolerance
// leaves no verdict open.
template <Scalar S, class Support>
Distance<S> gjk_distance(const Support& support, const Vec3<S>& x, const Vec3<S>& start, Simplex<S>& simplex,
                         S gap, S near_enough, int budget, Counters& counters, S loose_gap = 0) {
  GRAZE_ASSERT(gap >= 0);  // x may be anything: NaN ends the search with a bracket of [0, infinity]
  Distance<S> out;
  if (simplex.size == 0) {
    simplex.add(support(start));
    ++counters.supports;
  }
  while (true) {
    const Closest<S> closest = closest_to_origin(simplex, x);
    ++counters.gjk_iterations;
    const S upper = square_root(closest.dist_sq);
    // NaN, or no nearer: the last bracket stands, with the simplex that gave it: the rejected point goes.
    if (!(upper < out.upper)) {
      if (simplex.size > 1) --simplex.size;
      out.stalled = !(out.upper - out.lower <= gap);
      return out;
    }
    out.upper = upper;
    reduce(simplex, closest);
    if (upper <= near_enough || simplex.size == 4 || closest.n == Vec3<S>::Zero()) return out;
    if (budget-- <= 0) {
      out.stalled = true;
      return out;
    }
    const CsoPoint<S> next = support(closest.n);
    ++counters.supports;
    const S lower = dot(closest.n, x - next.w);
    if (lower > out.lower) {
      out.lower = lower;
      out.n = closest.n;
    }
    if (out.upper - out.lower <= (out.lower > near_enough ? std::max(gap, loose_gap) : gap)) return out;
    if (simplex.holds(next)) {
      // The support is a vertex of the feature itself: its own normal cannot be bettered, only its rounding.
      out.stalled = true;
      return out;
    }
    simplex.add(next);
  }
}

// The same of the core itself.
template <Scalar S>
Distance<S> gjk_distance(const Cso<S>& cso, const Vec3<S>& x, Simplex<S>& simplex, S gap, S near_enough,
                         int budget, Counters& counters) {
  return gjk_distance([&cso](const Vec3<S>& n) { return cso.support(n); }, x, Vec3<S>(x - cso.middle()),
                      simplex, gap, near_enough, budget, counters);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
