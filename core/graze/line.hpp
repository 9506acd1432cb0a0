// line(A, B) = {t in R : the bodies touch at t} = [t_in, t_out]: the signed answer of a linear motion.
//
// Nothing is clipped: t may be negative, and [0, t_max] plays no part. At rest (v = 0) it is all of R or
// nothing. By portals: one where the line {t v} enters C, one where it leaves, seen from behind
// (search/robust/portal.hpp). Inputs: bodies in world axes, the caller's units. Guarantee: the answer is true for
// some convex set within kappa u scale of C (docs/guarantees.md), as the MPR sweep's; each end is a bracket.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
struct LineOptions {
  Request request = Request::normal;
  S target_distance = 0;     // m: contact is when the distance reaches m (length)
  S tolerance = 0;           // of the search, over scale; 0: the rounding bound
  int max_iterations = 256;  // portal steps of each end
};

template <Scalar S>
struct LineResult {
  // hit: [t_in, t_out] is not empty; miss: it is; not_converged: the brackets are what is known;
  // invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};
  // hit: in_lower <= t_in <= in_upper, out_lower <= t_out <= out_upper; at rest -infinity and infinity.
  S in_lower = -kInfinity<S>, in_upper = kInfinity<S>, out_lower = -kInfinity<S>, out_upper = kInfinity<S>;
  // hit, when asked for: unit, from A to B, supporting normals of C where the line enters and where it
  // leaves; zero at rest. miss: normal_in is an axis that separates the bodies for all t.
  Vec3<S> normal_in = Vec3<S>::Zero(), normal_out = Vec3<S>::Zero();
  Counters counters;
};

template <Scalar S>
LineResult<S> line(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options = {});
// The same of the true shapes: each end between two neighbouring S, or known as one.
template <Scalar S>
LineResult<S> line_exact(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/line_query.hpp>
#endif
