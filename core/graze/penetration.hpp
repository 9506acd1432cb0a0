/// @file
/// Penetration: how deep are two bodies in each other at t = 0, and which way is out?
///
/// - *least*: min over unit n of h(n), where h(n) = max over C of n.c. Moving B by h(n) n makes the bodies only
///   touch, and no shorter move does. By EPA.
/// - *along d*: max {s : s d/|d| in C}. Moving B by that much along d makes them only touch. By MPR.
///
/// The guarantee is lower <= depth <= upper up to kappa u scale (in the table of guarantees). `lower` is the depth of
/// a polytope inside C, or a point of C on the line. `upper` is h(n) of the normal that is returned, over n.d along
/// d.
//
// The core of C only: C is the core rounded by R, and the least h of the two differ by R for the same n. If the origin is
// outside the core, within R of it, the least h of the core is minus its distance: GJK.
#pragma once

#include <graze/body.hpp>
#include <graze/prepared.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The options of penetration() and penetration_along(). Options out of range are `invalid_input`.
template <Scalar S>
struct PenetrationOptions {
  Request request = Request::normal | Request::witnesses;  ///< The results to compute. There is no proof.
  S tolerance = 0;  ///< The width upper - lower, over scale, at which to stop. 0 stops at the rounding bound.
  /// The largest number of support evaluations. A search ends by itself: for polytopes with equally near faces after as
  /// many as C has vertices, and for curved shapes after some hundred. The table of guarantees allows 4,096.
  int max_iterations = 1 << 20;
};

/// The answer of penetration() and penetration_along().
template <Scalar S>
struct PenetrationResult {
  /// initially_overlapping, miss (the bodies are apart), not_converged (neither is known) or invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;  ///< For invalid_input: the reason.
  InvalidAt invalid_at = {};        ///< For invalid_input: the place.
  /// For initially_overlapping: the lower end of the bracket of the depth, a length. For a miss 0.
  S lower = 0;
  S upper = kInfinity<S>;  ///< The upper end of the bracket. For a miss 0.
  bool stalled = false;    ///< The requested width was not reached. The bracket is valid.
  /// Unit, from A to B, world axes. For initially_overlapping, if requested: the direction of least penetration, or
  /// along d the supporting normal where the line leaves C. For a miss: an axis that separates the bodies.
  Vec3<S> normal = Vec3<S>::Zero();
  /// For initially_overlapping, if requested: the world points of A and of B that the move brings together. point_a -
  /// point_b is depth normal, or depth d/|d| along d. The error is kappa u scale along the normal, and sideways the
  /// root of 2 depth times that. For curved shapes, errors up to 4,000 u scale along the normal were seen (a cone and
  /// a box, float).
  //
  // Sideways: |x - depth n|^2 <= 2 depth (depth - n.x) for |x| <= depth. For curved shapes the points are those of the
  // search's last face, whose own directions differ from the normal.
  Vec3<S> point_a = Vec3<S>::Zero();
  Vec3<S> point_b = Vec3<S>::Zero();  ///< The point of B, likewise.
  Counters counters;                  ///< The work that was done.
};

/// The least penetration depth at t = 0, and the direction in which the least move of B separates the bodies.
///
/// Lengths are in the caller's unit, vectors in world axes, and the normal points from A to B. Touching is contact of
/// depth 0. A flat C, for instance of two triangles in a plane, has depth 0 throughout. Invalid input is the outcome
/// `invalid_input`.
///
/// It evaluates the support function 2 to 4 times typically for spheres and capsules, and 10 to 40 times for boxes and
/// hulls. Cylinders, cones and ellipsoids take 10 to some hundred. So it costs several times as much as distance(), and
/// more for deeper overlaps. It may allocate memory for the faces of its polytope. Nothing is
/// thrown except std::bad_alloc.
///
/// @code
/// const graze::Body<double> floor{.shape = graze::Box<double>{{50, 50, 1}}, .position = {0, 0, -1}};
/// graze::Body<double> ball{.shape = graze::Sphere<double>{0.5}, .position = {3, 2, 0.3}};
/// const graze::PenetrationResult<double> r = graze::penetration(floor, ball);
/// assert(r.outcome == graze::Outcome::initially_overlapping && std::abs(r.upper - 0.2) < 1e-12);
/// ball.position += r.upper * r.normal;  // now they only touch
/// assert(std::abs(ball.position[2] - 0.5) < 1e-12);
/// @endcode
template <Scalar S>
PenetrationResult<S> penetration(const Body<S>& a, const Body<S>& b,
                                 const PenetrationOptions<S>& options = {});
/// The same for prepared bodies, which saves preparing them again.
template <Scalar S>
PenetrationResult<S> penetration(const Prepared<S>& a, const Prepared<S>& b,
                                 const PenetrationOptions<S>& options = {});
/// How far B must move along `direction` until the bodies only touch. The direction is in world axes and of any
/// length except 0, which is `invalid_input`. The depth is a length along it.
///
/// It evaluates the support function 10 to 20 times typically for boxes and hulls, and 20 to 80 times for curved and
/// rounded shapes. Nothing is thrown or allocated.
///
/// @code
/// const graze::Body<double> box{.shape = graze::Box<double>{{1, 1, 1}}};
/// const graze::PenetrationResult<double> r = graze::penetration_along<double>(box, box, {0, 3, 0});
/// assert(std::abs(r.lower - 2) < 1e-12 && std::abs(r.upper - 2) < 1e-12);
///
/// const graze::PenetrationOptions<double> depth_alone{.request = graze::Request::verdict};
/// assert(graze::penetration_along<double>(box, box, {0, 3, 0}, depth_alone).normal.isZero());
/// @endcode
template <Scalar S>
PenetrationResult<S> penetration_along(const Body<S>& a, const Body<S>& b, const Vec3<S>& direction,
                                       const PenetrationOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/penetration_query.hpp>
#endif
