// overlap(A, B): do the bodies touch at t = 0? By MPR, or by GJK. Touching counts.
//
// Guarantee: right wherever distance or penetration exceeds kappa u scale (docs/guarantees.md).
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze::inline GRAZE_LINKAGE {

template <Scalar S>
struct OverlapResult {
  // initially_overlapping, miss, not_converged or invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};
  Vec3<S> normal = Vec3<S>::Zero();  // of a miss: unit, from A to B, world axes; separates the bodies
  Counters counters;
};

// The ray from a point of C's inside through the origin leaves C beyond it, or not.
template <Scalar S>
OverlapResult<S> overlap_mpr(const Body<S>& a, const Body<S>& b);
// The distance is zero, or not.
template <Scalar S>
OverlapResult<S> overlap_gjk(const Body<S>& a, const Body<S>& b);
// Do they touch at t = 0? Touching counts.
template <Scalar S>
OverlapResult<S> overlap_exact(const Body<S>& a, const Body<S>& b);

}  // namespace graze::inline GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/exact/queries.hpp>
#include <graze/queries/overlap.hpp>
#endif
