// distance(A, B) = min |a - b| at t = 0, with the closest points and a separating axis: GJK.
//
// Units: the caller's length, world axes. Guarantee: lower <= distance <= upper up to kappa u scale
// (docs/guarantees.md); both are 0 in contact. Where the bodies are apart by more than kappa u scale, the
// normal proves lower: the slab across it between the bodies is so wide. The search stops at the duality gap
// upper - lower that is asked for. [Gilbert, Johnson, Keerthi 1988; van den Bergen 2003]
#pragma once

#include <graze/body.hpp>
#include <graze/prepared.hpp>
#include <graze/result.hpp>
#include <graze/warm_start.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
struct DistanceOptions {
  Request request = Request::normal | Request::witnesses;
  S tolerance = 0;           // of the gap, over scale; 0: the rounding bound
  int max_iterations = 256;  // support evaluations
  WarmStart start = {};      // of a former answer about the pair
};

template <Scalar S>
struct DistanceResult {
  Invalid invalid = Invalid::none;  // other than none: nothing but invalid_at is valid
  InvalidAt invalid_at = {};
  S lower = 0, upper = kInfinity<S>;
  bool stalled = false;  // the gap asked for was not reached; the bracket is what is known
  // Where lower > 0, when asked for: unit, from A to B, and the closest points, in world coordinates.
  Vec3<S> normal = Vec3<S>::Zero();
  Vec3<S> point_a = Vec3<S>::Zero(), point_b = Vec3<S>::Zero();
  WarmStart warm;  // for the next question about the pair; empty where there is nothing to keep
  Counters counters;
};

template <Scalar S>
DistanceResult<S> distance(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options = {});
template <Scalar S>
DistanceResult<S> distance(const Prepared<S>& a, const Prepared<S>& b,
                           const DistanceOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/distance_query.hpp>
#endif
