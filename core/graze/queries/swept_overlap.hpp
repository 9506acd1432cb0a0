// Declared, with what it promises, in graze/swept_overlap.hpp.
#pragma once

#include <graze/portal/mpr.hpp>
#include <graze/support/validate.hpp>
#include <graze/swept_overlap.hpp>

namespace graze::inline GRAZE_LINKAGE {

namespace detail {

// No contact is later than this: s r.r <= h(r) + R |r|. Nor is the swept set larger than it need be, which
// keeps its rounding that of C. Negative: C is left behind, r separates.
template <Scalar S>
S last_contact(const Cso<S>& cso, const SweepLimits<S>& limits, Counters& counters) {
  const Vec3<S>& r = cso.direction();
  ++counters.supports;
  const S reach = r.dot(cso.support(r).w) + (cso.radius() + limits.noise) * r.norm();
  return std::min(limits.s_max, reach / r.squaredNorm());
}

template <Scalar S>
void swept_by_portals(SweptOverlapResult<S>& out, const Cso<S>& cso, const SweepLimits<S>& limits) {
  const Sweep<S> sweep = mpr_sweep(cso, limits, out.counters);
  out.outcome = sweep.outcome == Outcome::initially_overlapping ? Outcome::hit : sweep.outcome;
  if (out.outcome == Outcome::miss) out.normal = sweep.n;
}

// 0 from the swept set by GJK; `support` is the set's, of the core.
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
  } else {
    // Apart, but with an axis too tilted to say so (distance.hpp), or inside without a tetrahedron.
    swept_by_portals(out, cso, limits);
  }
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
  if (detail::refused(out, a, b, checked)) return out;
  const Cso<S> cso(a, b, options.target_distance);
  const SweepLimits<S> limits = sweep_limits(cso, checked);
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
  const auto moved = [&](CsoPoint<S> p) {
    p.w += sweep;
    p.e = Vec3<S>::UnitX();
    return p;
  };
  if (options.method == SweptMethod::gjk) {
    detail::swept_by_distance(out, cso, limits, s_end, [&](const Vec3<S>& n) {
      const CsoPoint<S> p = cso.support(n);
      return n.dot(sweep) > 0 ? moved(p) : p;
    });
  } else {
    detail::swept_by_distance(out, cso, limits, s_end, [&](const Vec3<S>& n) {
      const CsoPoint<S> before = cso.support(n), after = moved(cso.support(n));
      return n.dot(after.w) > n.dot(before.w) ? after : before;
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

}  // namespace graze::inline GRAZE_LINKAGE
