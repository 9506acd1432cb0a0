// Declared, with what it promises, in graze/swept_overlap.hpp.
#pragma once

#include <graze/detail/casts/pair_kind.hpp>
#include <graze/detail/search/fast/fast_gjk.hpp>
#include <graze/detail/search/fast/fast_walk.hpp>
#include <graze/detail/search/fast/swept_support.hpp>
#include <graze/detail/search/robust/mpr.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/swept_overlap.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// No contact is later than this: s r.r <= h(r) + R |r|. Nor is the swept set larger than it need be, which
// keeps its rounding that of C. Negative: C is left behind, r separates.
template <Scalar S>
S last_contact(const Cso<S>& cso, const SweepLimits<S>& limits, Counters& counters) {
  const Vec3<S>& r = cso.direction();
  ++counters.supports;
  const S reach = dot(r, cso.support(r).w) + fl((cso.radius() + limits.noise) * norm(r));
  return std::min(limits.s_max, reach / squared_norm(r));
}

template <Scalar S>
void swept_by_portals(SweptOverlapResult<S>& out, const Cso<S>& cso, const SweepLimits<S>& limits) {
  const Sweep<S> sweep = mpr_sweep(cso, limits, out.counters);
  out.outcome = sweep.outcome == Outcome::initially_overlapping ? Outcome::hit : sweep.outcome;
  if (out.outcome == Outcome::miss) out.normal = sweep.n;
}

// Searches let the path end where C does: at s_end. Does the axis n of a miss, `gap` wide, separate to the
// path's own end? An axis that faces the path soon stops separating. One that lies across it is tilted until it faces
// away, beyond the rounding of n.r.
template <Scalar S>
[[nodiscard]] bool goes_to_the_end(const Cso<S>& cso, const SweepLimits<S>& limits, S s_end, S gap,
                                   Vec3<S>& n, Counters& counters) {
  const Vec3<S>& r = cso.direction();
  const S rate = dot(n, r), least = 16 * kUnitRoundoff<S> * norm_1(n) * r.cwiseAbs().maxCoeff();
  if (!(limits.s_max > s_end) || rate > least) return true;
  if (gap + fl(limits.s_max * (rate - least)) > 0) return true;
  const Vec3<S> tilted = unit(Vec3<S>(n + ((4 * least - rate) / squared_norm(r)) * r));
  ++counters.supports;
  if (!(dot(tilted, r) > 2 * least) || !(dot(tilted, cso.support(tilted).w) + cso.radius() < 0)) return false;
  n = tilted;
  return true;
}

// The distance of 0 from the swept set by GJK. `support` is the set's, of the core.
template <Scalar S, class Support>
void swept_by_distance(SweptOverlapResult<S>& out, const Cso<S>& cso, const SweepLimits<S>& limits, S s_end,
                       const Support& support) {
  const S R = cso.radius(), fine = limits.fine();
  Simplex<S> simplex;
  const Vec3<S> start = S(s_end / 2) * cso.direction() - cso.middle();
  const Distance<S> d = gjk_distance(support, Vec3<S>(Vec3<S>::Zero()), start, simplex, fine, R + fine,
                                     limits.budget, out.counters);
  out.counters.iterations = out.counters.gjk_iterations;
  const S apart = d.upper - R;
  if (apart <= fine || (apart <= limits.noise && !(d.lower - R > fine))) {
    out.outcome = Outcome::hit;
  } else if (d.lower - R > 0) {
    out.outcome = Outcome::miss;
    out.normal = d.n;
    if (!goes_to_the_end(cso, limits, s_end, S(d.lower - R), out.normal, out.counters)) {
      // By portals an axis separates to the end, or lies across the path.
      const Sweep<S> sweep = mpr_sweep(cso, limits, out.counters);
      if (sweep.outcome == Outcome::miss) out.normal = sweep.n;
    }
  } else {
    // Apart, but with an axis too tilted to say so (distance.hpp), or inside without a tetrahedron.
    swept_by_portals(out, cso, limits);
  }
}

// Searches let the path end where C does. Does the axis n of a miss separate to its own end? An axis that faces the
// path soon stops separating. One that lies across it is tilted until it faces away, beyond the rounding of n.r. r is
// within u, and three products and sums are as large, 14 u |n|_1 (search/exact/passage.hpp).
template <Scalar S>
[[nodiscard]] bool goes_to_the_end(const PreparedPair<S>& pair, double horizon, Triple& n,
                                   Counters& counters) {
  const Triple& r = pair.direction();
  const double r_sq = dot(r, r), rate = dot(n, r), least = 16 * kUnitRoundoff<double> * sum(magnitude(n));
  if (!(horizon > swept_reach(pair, horizon)) || rate > least) return true;
  n = n + ((4 * least - rate) / r_sq) * r;
  PairSupport<S> support(pair, counters);
  PairVertex w;
  support.sure(n, w);
  return dot(n, r) > 2 * least && support.separates(n, w);
}

// The answer of a quick search. If it returns false, nothing is proved and only the counters of `out` have changed.
// The axis of a miss separates for the whole path.
template <Scalar S>
[[nodiscard]] bool take(SweptOverlapResult<S>& out, Outcome outcome, const Triple& axis) {
  if (outcome == Outcome::not_converged) return false;
  out.outcome = outcome == Outcome::miss ? outcome : Outcome::hit;
  if (outcome == Outcome::miss) out.normal = unit(axis.vector()).template cast<S>();
  return true;
}

// Two polytopes, one of which moves past the other: by GJK on the swept set, or by the portals of a cast.
template <Scalar S, bool kBoth>
[[nodiscard]] bool fast_swept_gjk(const PreparedPair<S>& pair, double horizon,
                                  const SweptOverlapOptions<S>& options, SweptOverlapResult<S>& out) {
  SweptSupport<S, kBoth> support(pair, swept_reach(pair, horizon), out.counters);
  FastGjk<S, SweptSupport<S, kBoth>> gjk(support, out.counters);
  WarmStart start;
  start.axis = scaled_near_one(fast_first_direction(pair)).vector();
  const FastState state = gjk.run(start, 0, true, options.max_iterations);
  out.counters.iterations = out.counters.gjk_iterations;
  // If the path nearly touches, the robust search's bracket decides.
  if (state == FastState::open || (state == FastState::apart && !gjk.separated())) return false;
  Triple n = gjk.axis();
  if (state == FastState::apart && !goes_to_the_end(pair, horizon, n, out.counters)) return false;
  return take(out, state == FastState::apart ? Outcome::miss : Outcome::hit, n);
}
template <Scalar S>
[[nodiscard]] bool fast_swept_mpr(const PreparedPair<S>& pair, double horizon,
                                  const SweptOverlapOptions<S>& options, SweptOverlapResult<S>& out) {
  FastWalk<S, false, true> walk(pair, horizon, 0, options.max_iterations, out.counters);
  const FastSweep& found = walk.run();
  out.counters.iterations = out.counters.portal_steps;
  Triple n = found.n;
  if (found.outcome == Outcome::miss && !goes_to_the_end(pair, horizon, n, out.counters)) return false;
  return take(out, found.outcome, n);
}

template <Scalar S>
[[nodiscard]] bool fast_swept(const Body<S>& a, const Body<S>& b, const SweptOverlapOptions<S>& options,
                              SweptOverlapResult<S>& out) {
  const auto horizon = [&](const auto& pair) {
    return double(options.t_max) * power_of_two(pair.speed_exponent() - pair.length_exponent());
  };
  const PairKind kind = kind_of(a, b, options.target_distance);
  if (kind == PairKind::polytopes) {
    const PreparedPair<S> pair(a, b);
    if (!pair.moves() || !(options.t_max > 0)) return false;
    switch (options.method) {
      case SweptMethod::gjk:
        return fast_swept_gjk<S, false>(pair, horizon(pair), options, out);
      case SweptMethod::before_after:
        return fast_swept_gjk<S, true>(pair, horizon(pair), options, out);
      case SweptMethod::mpr:
        break;
    }
    return fast_swept_mpr(pair, horizon(pair), options, out);
  }
  if (options.method != SweptMethod::mpr || kind != PairKind::curved || !(options.t_max > 0)) return false;
  const CurvedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves()) return false;
  CurvedWalk<S> walk(pair, horizon(pair), 0, options.max_iterations, out.counters);
  const CurvedSweep& found = walk.run();
  // The test of goes_to_the_end(), without its second try.
  const bool ends = horizon(pair) <= 2 * (pair.extent() + pair.radius()) ||
                    dot(found.n, pair.direction()) > 16 * kUnitRoundoff<double> * sum(magnitude(found.n));
  return (found.outcome != Outcome::miss || ends) && take(out, found.outcome, found.n);
}

}  // namespace detail

template <Scalar S>
SweptOverlapResult<S> swept_overlap(const Body<S>& a, const Body<S>& b,
                                    const SweptOverlapOptions<S>& options) {
  SweptOverlapResult<S> out;
  CastOptions<S> checked;
  checked.t_max = options.t_max;
  checked.target_distance = options.target_distance;
  checked.max_iterations = options.max_iterations;
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked) || detail::fast_swept(a, b, options, out)) return out;
  const detail::Cso<S> cso(a, b, options.target_distance);
  const detail::SweepLimits<S> limits = detail::sweep_limits(cso, checked);
  if (options.method == SweptMethod::mpr) {
    detail::swept_by_portals(out, cso, limits);
    return out;
  }
  const S s_end = limits.s_max > 0 ? detail::last_contact(cso, limits, out.counters) : S(0);
  if (s_end < 0) {
    out.outcome = Outcome::miss;
    out.normal = unit(cso.direction());
    return out;
  }
  const Vec3<S> sweep = -s_end * cso.direction();
  // The far end of the sweep is another point of the same features.
  const auto moved = [&](detail::CsoPoint<S> p) {
    p.w += sweep;
    p.e = Vec3<S>::UnitX();
    return p;
  };
  if (options.method == SweptMethod::gjk) {
    detail::swept_by_distance(out, cso, limits, s_end, [&](const Vec3<S>& n) {
      const detail::CsoPoint<S> p = cso.support(n);
      return detail::dot(n, sweep) > 0 ? moved(p) : p;
    });
  } else {
    detail::swept_by_distance(out, cso, limits, s_end, [&](const Vec3<S>& n) {
      const detail::CsoPoint<S> before = cso.support(n), after = moved(cso.support(n));
      return detail::dot(n, after.w) > detail::dot(n, before.w) ? after : before;
    });
  }
  return out;
}

template <Scalar S>
SweptOverlapResult<S> swept_overlap_before_after(const Body<S>& a, const Body<S>& b,
                                                 SweptOverlapOptions<S> options) {
  options.method = SweptMethod::before_after;
  return swept_overlap(a, b, options);
}

}}  // namespace graze::GRAZE_LINKAGE
