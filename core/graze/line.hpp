/// @file
/// Lines: from when to when do two linearly moving bodies touch, over all times?
///
/// line(A, B) = {t in R : the bodies touch at t} = [t_in, t_out]. Nothing is clipped, so t may be negative. The
/// search finds one portal where the line {t v} enters C = A - B, and one where it leaves. The answer is true for
/// some convex set within kappa u scale of C (in the table of guarantees).
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The options of line() and line_exact(). Options out of range are `invalid_input`.
template <Scalar S>
struct LineOptions {
  Request request = Request::normal;  ///< The results to compute. There are no witnesses and no proof.
  S target_distance = 0;              ///< m, a length: contact is when the distance reaches m.
  /// Convergence target, a length over scale. 0 stops at the rounding bound. line_exact() only checks it.
  S tolerance = 0;
  int max_iterations = 256;  ///< The largest number of portal steps of each end. line_exact() only checks it.
};

/// The answer of line() and line_exact().
template <Scalar S>
struct LineResult {
  /// hit ([t_in, t_out] is not empty), miss (it is empty), not_converged (the brackets are valid, but wide) or
  /// invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;  ///< For invalid_input: the reason.
  InvalidAt invalid_at = {};        ///< For invalid_input: the place.
  /// For a hit: in_lower <= t_in <= in_upper and out_lower <= t_out <= out_upper. At rest -infinity and infinity.
  S in_lower = -kInfinity<S>;
  S in_upper = kInfinity<S>;    ///< The upper end of t_in.
  S out_lower = -kInfinity<S>;  ///< The lower end of t_out.
  S out_upper = kInfinity<S>;   ///< The upper end of t_out.
  /// For a hit, if requested: unit, from A to B, world axes. They are supporting normals of C where the line enters
  /// and leaves, and 0 at rest. For a miss, normal_in is an axis that separates the bodies at all times.
  Vec3<S> normal_in = Vec3<S>::Zero();
  Vec3<S> normal_out = Vec3<S>::Zero();  ///< Normal at the exit of the line.
  Counters counters;                     ///< The work that was done.
};

/// From when to when do the bodies touch? World axes, the caller's units, and t in units of the displacement.
///
/// Bodies at rest relative to each other touch at all times or at none. Invalid input is the outcome `invalid_input`.
/// Nothing is thrown or allocated.
///
/// It evaluates the support function 12 to 30 times typically for polytopes, twice as often as a cast. Curved and
/// rounded shapes take 30 to 150. In time it costs several casts of polytopes, and far more casts of spheres and
/// capsules. If only the first contact matters, call cast().
///
/// @code
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> ball{.shape = graze::Sphere<double>{1}, .displacement = {4, 0, 0}};
/// const graze::LineResult<double> r = graze::line(wall, ball);
/// assert(r.outcome == graze::Outcome::hit);
/// assert(std::abs(r.in_lower - 2) < 1e-12 && std::abs(r.out_upper - 3) < 1e-12);
/// @endcode
template <Scalar S>
LineResult<S> line(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options = {});
/// The same for the true shapes: each end is between two neighbouring numbers S, or is one. Only for the shapes of
/// the exact tier (cast.hpp). Others are `invalid_input` (Invalid::not_exact).
///
/// For polytopes it takes about as long as line(). Spheres, capsules, rounded shapes and a target distance take another
/// search, which allocates memory and takes longer (0.25 ms for two spheres, 0.7 ms for two boxes at a target distance).
///
/// @code
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> ray{.displacement = {3, 0, 0}};
/// const graze::LineResult<double> r = graze::line_exact(wall, ray);
/// assert(r.in_lower == 3 && r.in_upper == 3);
/// assert(r.out_upper == std::nextafter(r.out_lower, 4));  // 11/3 is not a double
///
/// const graze::LineOptions<double> options{.target_distance = 3};  // within 3 of the wall
/// assert(graze::line_exact(wall, ray, options).in_lower == 2);
/// @endcode
template <Scalar S>
LineResult<S> line_exact(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/line_query.hpp>
#endif
