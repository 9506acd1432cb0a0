// penetration(A, B) = how deep two bodies in contact are in each other at t = 0.
//
//   least:  min over unit n of h(n), h(n) = max over C of n.c. Moving B by h(n) n makes them only touch, and
//           no shorter move does. By EPA (search/robust/epa.hpp).
//   along d:  max {s : s d/|d| in C}: moving B by that much along d. By MPR, the far end of a line in C.
//
// Units: the caller's length, world axes; the normal from A to B. Touching is contact, of depth 0; a C of
// fewer dimensions has depth 0 throughout. Apart: outcome miss (how far: distance.hpp). Guarantee: lower <=
// depth <= upper up to kappa u scale (docs/guarantees.md): lower is the depth of a polytope inside C (a point
// of C on the line), upper is h(n) of the very normal that is returned (over n.d).
//
// The core of C only: C is the core rounded by R, and the least h of the two differ by R for the same n.
// Where the origin is outside the core, within R of it, the least h of the core is minus its distance: GJK.
#pragma once

#include <graze/body.hpp>
#include <graze/prepared.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
struct PenetrationOptions {
  Request request = Request::normal | Request::witnesses;
  S tolerance = 0;  // of upper - lower, over scale; 0: the rounding bound
  // Support evaluations. A search ends by itself: after 300 at most of two primitives, after as many as C has vertices
  // of polytopes with equally near faces.
  int max_iterations = 1 << 20;
};

template <Scalar S>
struct PenetrationResult {
  // initially_overlapping; miss: apart; not_converged: neither is known; invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};
  // initially_overlapping: the depth (length). 0, 0 for a miss.
  S lower = 0, upper = kInfinity<S>;
  bool stalled = false;  // the gap asked for was not reached; the bracket is what is known
  // Unit, from A to B. initially_overlapping, when asked for: the direction of least penetration; along d:
  // the supporting normal where the line leaves C. miss: an axis that separates the bodies.
  Vec3<S> normal = Vec3<S>::Zero();
  // initially_overlapping, when asked for: world points of A and of B, point_a - point_b = depth normal
  // (along d: depth d/|d|), which the move brings together: up to kappa u scale along the normal, and
  // sideways by the root of 2 depth times that: |x - depth n|^2 <= 2 depth (depth - n.x) for |x| <= depth.
  // Of curved shapes the points are those of the search's last face, whose own directions differ from the normal: off
  // by up to 4,000 u scale along it was seen (a cone and a box, float).
  Vec3<S> point_a = Vec3<S>::Zero(), point_b = Vec3<S>::Zero();
  Counters counters;
};

template <Scalar S>
PenetrationResult<S> penetration(const Body<S>& a, const Body<S>& b,
                                 const PenetrationOptions<S>& options = {});
template <Scalar S>
PenetrationResult<S> penetration(const Prepared<S>& a, const Prepared<S>& b,
                                 const PenetrationOptions<S>& options = {});
// `direction`: world axes, any length but zero (out_of_range).
template <Scalar S>
PenetrationResult<S> penetration_along(const Body<S>& a, const Body<S>& b, const Vec3<S>& direction,
                                       const PenetrationOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/penetration_query.hpp>
#endif
