// overlap(A, B): do the bodies touch at t = 0? By MPR, or by GJK. Touching counts.
//
// Guarantee: right wherever distance or penetration exceeds kappa u scale (docs/guarantees.md).
#pragma once

#include <graze/distance.hpp>
#include <graze/portal/mpr.hpp>

namespace graze {

template <Scalar S>
struct OverlapResult {
  // initially_overlapping, miss, not_converged or invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  Vec3<S> normal = Vec3<S>::Zero();  // of a miss: unit, from A to B, world axes; separates the bodies
  Counters counters;
};

// The ray from a point of C's inside through the origin leaves C beyond it, or not.
template <Scalar S>
OverlapResult<S> overlap_mpr(const Body<S>& a, const Body<S>& b) {
  OverlapResult<S> out;
  const CastOptions<S> options;
  out.invalid = validate(a, b, options);
  if (out.invalid != Invalid::none) return out;
  const Cso<S> cso(a, b);
  const Sweep<S> sweep = mpr_overlap(cso, sweep_limits(cso, options), out.counters);
  out.outcome = sweep.outcome;
  if (sweep.outcome == Outcome::miss) out.normal = sweep.n;
  return out;
}

// The distance is zero, or not.
template <Scalar S>
OverlapResult<S> overlap_gjk(const Body<S>& a, const Body<S>& b) {
  OverlapResult<S> out;
  DistanceOptions<S> options;
  options.request = Request::normal;
  const DistanceResult<S> d = distance(a, b, options);
  out.invalid = d.invalid;
  out.counters = d.counters;
  if (out.invalid != Invalid::none) return out;
  out.normal = d.normal;
  out.outcome = d.lower > 0    ? Outcome::miss
                : d.upper == 0 ? Outcome::initially_overlapping
                               : Outcome::not_converged;
  return out;
}

}  // namespace graze
