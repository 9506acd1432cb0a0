// Declared, with what it promises, in graze/overlap.hpp.
#pragma once

#include <graze/distance.hpp>
#include <graze/overlap.hpp>
#include <graze/portal/mpr.hpp>

namespace graze::inline GRAZE_LINKAGE {

template <Scalar S>
OverlapResult<S> overlap_mpr(const Body<S>& a, const Body<S>& b) {
  OverlapResult<S> out;
  const CastOptions<S> options;
  out.invalid = validate(a, b, options);
  if (detail::refused(out, a, b, options)) return out;
  const Cso<S> cso(a, b);
  const Sweep<S> sweep = mpr_overlap(cso, sweep_limits(cso, options), out.counters);
  out.outcome = sweep.outcome;
  if (sweep.outcome == Outcome::miss) out.normal = sweep.n;
  return out;
}

template <Scalar S>
OverlapResult<S> overlap_gjk(const Body<S>& a, const Body<S>& b) {
  OverlapResult<S> out;
  DistanceOptions<S> options;
  options.request = Request::normal;
  const DistanceResult<S> d = distance(a, b, options);
  out.invalid = d.invalid;
  out.invalid_at = d.invalid_at;
  out.counters = d.counters;
  if (out.invalid != Invalid::none) return out;
  out.normal = d.normal;
  out.outcome = d.lower > 0    ? Outcome::miss
                : d.upper == 0 ? Outcome::initially_overlapping
                               : Outcome::not_converged;
  return out;
}

}  // namespace graze::inline GRAZE_LINKAGE
