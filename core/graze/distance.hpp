/// @file
/// Distance: how far apart are two bodies at t = 0, and where are they closest?
///
/// distance(A, B) = min |a - b| over a in A and b in B, by GJK. The search stops at the requested duality gap upper -
/// lower. [Gilbert, Johnson, Keerthi 1988, and van den Bergen 2003]
#pragma once

#include <graze/body.hpp>
#include <graze/prepared.hpp>
#include <graze/result.hpp>
#include <graze/warm_start.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The options of distance() and distance_exact(), which only checks `tolerance` and `max_iterations`. Options out of range are `invalid_input`.
template <Scalar S>
struct DistanceOptions {
  Request request = Request::normal | Request::witnesses;  ///< The results to compute. There is no proof.
  S tolerance = 0;  ///< The width upper - lower, over scale, at which to stop. 0 stops at the rounding bound.
  int max_iterations = 256;  ///< The largest number of support evaluations.
  WarmStart start = {};      ///< The `warm` of an earlier answer about the pair.
};

/// The answer of distance() and distance_exact().
template <Scalar S>
struct DistanceResult {
  Invalid invalid = Invalid::none;  ///< If it is not none, nothing else but `invalid_at` is valid.
  InvalidAt invalid_at = {};        ///< The place of an invalid input.
  S lower = 0;                      ///< The lower end of the bracket of the distance, a length. 0 in contact.
  S upper = kInfinity<S>;           ///< The upper end of the bracket. 0 in contact.
  bool stalled = false;             ///< The requested width was not reached. The bracket is valid.
  /// If lower > 0, and if requested: unit, from A to B, world axes.
  Vec3<S> normal = Vec3<S>::Zero();
  /// If lower > 0, and if requested: the closest point of A, in world coordinates.
  Vec3<S> point_a = Vec3<S>::Zero();
  Vec3<S> point_b = Vec3<S>::Zero();  ///< The closest point of B, likewise.
  WarmStart warm;     ///< For the next query about the pair. It is empty if there is nothing to keep.
  Counters counters;  ///< The work that was done.
};

/// The distance of two bodies at t = 0, in the caller's length and in world axes. Motion is ignored.
///
/// The guarantee is lower <= distance <= upper up to kappa u scale (in the table of guarantees). If the bodies are
/// apart by more than that, the normal proves `lower`: the slab between the bodies across it is at least that wide.
/// Invalid input is in `invalid` and `invalid_at`. Nothing is thrown or allocated. It evaluates the support function 1
/// to 10 times typically, and 3 to 50 times for cylinders, cones and ellipsoids.
///
/// @code
/// const graze::Body<double> floor{.shape = graze::Box<double>{{50, 50, 1}}, .position = {0, 0, -1}};
/// graze::Body<double> ball{.shape = graze::Sphere<double>{0.5}, .position = {3, 2, 2.5}};
/// graze::DistanceResult<double> r = graze::distance(floor, ball);
/// assert(r.lower <= 2 && 2 <= r.upper && r.upper - r.lower < 1e-12 && r.normal[2] == 1);
///
/// ball.position[2] = 2.4;  // the next step begins where the last one ended
/// r = graze::distance(floor, ball, {.start = r.warm});
/// assert(std::abs(r.lower - 1.9) < 1e-12);
///
/// const graze::DistanceOptions<double> coarse{.request = graze::Request::verdict, .tolerance = 1e-3};
/// r = graze::distance(floor, ball, coarse);  // the bracket alone
/// assert(r.lower <= 1.9 && 1.9 <= r.upper && !r.stalled && r.normal.isZero());
/// @endcode
template <Scalar S>
DistanceResult<S> distance(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options = {});
/// The same for prepared bodies, which saves preparing them again.
template <Scalar S>
DistanceResult<S> distance(const Prepared<S>& a, const Prepared<S>& b,
                           const DistanceOptions<S>& options = {});
/// The same for the true shapes: the distance is between two neighbouring numbers S, or is one. Only for the shapes of
/// the exact tier (cast.hpp). Others are invalid (Invalid::not_exact).
///
/// It computes in exact numbers. It allocates memory, and takes 10 to 40 times as long as distance().
///
/// @code
/// const graze::Body<double> box{.shape = graze::Box<double>{{1, 1, 1}}};
/// const graze::Body<double> ball{.shape = graze::Sphere<double>{2}, .position = {4, 5, 1}};
/// assert(graze::distance_exact(box, ball).lower == 3 && graze::distance_exact(box, ball).upper == 3);
/// const graze::Body<double> point{.position = {2, 2, 0}};
/// const graze::DistanceResult<double> r = graze::distance_exact(box, point);  // the root of 2
/// assert(r.lower < r.upper && r.upper == std::nextafter(r.lower, 2.0));
/// @endcode
template <Scalar S>
DistanceResult<S> distance_exact(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/distance_query.hpp>
#include <graze/detail/queries/exact_queries.hpp>
#endif
