// overlap(A, B): do the bodies touch at t = 0? By MPR, or by GJK. Touching counts.
//
// Guarantee: right wherever distance or penetration exceeds kappa u scale (docs/guarantees.md).
#pragma once

#include <graze/body.hpp>
#include <graze/prepared.hpp>
#include <graze/result.hpp>
#include <graze/warm_start.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
struct OverlapResult {
  // initially_overlapping, miss, not_converged or invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};
  Vec3<S> normal = Vec3<S>::Zero();  // of a miss: unit, from A to B, world axes; separates the bodies
  // mpr, gjk: for the next question about the pair; without an axis and vertices where there is nothing to keep.
  WarmStart warm;
  Counters counters;
};

// By MPR: does the ray from an interior point of C = A - B through the origin leave C beyond the origin?
template <Scalar S>
OverlapResult<S> overlap_mpr(const Body<S>& a, const Body<S>& b, const WarmStart& start = {});
template <Scalar S>
OverlapResult<S> overlap_mpr(const Prepared<S>& a, const Prepared<S>& b, const WarmStart& start = {});
// By GJK: is the distance zero?
template <Scalar S>
OverlapResult<S> overlap_gjk(const Body<S>& a, const Body<S>& b, const WarmStart& start = {});
template <Scalar S>
OverlapResult<S> overlap_gjk(const Prepared<S>& a, const Prepared<S>& b, const WarmStart& start = {});
// Of the true shapes, decided exactly: see tier exact (cast.hpp).
template <Scalar S>
OverlapResult<S> overlap_exact(const Body<S>& a, const Body<S>& b);

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/overlap_query.hpp>
#endif
