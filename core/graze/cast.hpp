/// @file
/// Casts: when do two linearly moving convex shapes first touch? Rays too, as a ray is the cast of a Point.
///
/// The time of impact (TOI) is the least t in [0, t_max] at which A + t v_A and B + t v_B are in contact, if there is
/// one. The v are the displacements, and t_max is 1 by default. Touching counts. The tier of CastOptions decides the
/// guarantee of the answer:
///
/// - *standard*, the default, for all shapes: the answer is true for some convex set within kappa u scale of the
///   difference C = A - B, with kappa = 64. So it is late, or has the wrong verdict, only where a change of the shapes by
///   that length would make it right. u is the unit roundoff of S.
/// - *certified*, for all shapes: toi_lower <= TOI <= toi_upper for the true shapes, rounding included. The bracket
///   is at most kLinearCertifiedWidth of scale wide, plus the rounding of its times to S. Choose it if no contact may
///   be missed.
/// - *exact*, for points, segments, triangles, boxes, hulls, spheres, capsules, and what posed(), rounded(), sum() and
///   swept() make of them, at any target distance: the TOI of the true shapes, correctly rounded. `toi_lower` is the
///   largest S not above it, and `toi_upper` the least not below it. Choose it for the verdict of ties.
///
/// Error bounds and widths are lengths. scale is the largest of the diagonals of the two bounding boxes and the distance
/// of their centres at the start. A bracket of times is w wide if the bodies move by w relative to each other within it.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// Casts A against B in the tier of the options. This is the function to call.
///
/// The bodies are in world axes and the caller's units. Invalid input is the outcome `invalid_input`. There is no global
/// state, so any number of threads may cast at once. Nothing is thrown or allocated, except that exact answers about
/// rounded polytopes may allocate. The normal points from A to B.
///
/// It evaluates the support function 5 to 20 times typically, and at most `max_iterations` times in the standard
/// tier. One evaluation is constant for simple shapes. For a hull it is linear in the vertices, or sublinear with
/// adjacency.
///
/// @code
/// const graze::Body<double> floor{.shape = graze::Box<double>{{50, 50, 1}}, .position = {0, 0, -1}};
/// const graze::Body<double> ball{
///     .shape = graze::Sphere<double>{0.5}, .position = {3, 2, 10.5}, .displacement = {0, 0, -20}};
///
/// const graze::CastResult<double> r = graze::cast(floor, ball);
/// assert(r.outcome == graze::Outcome::hit && r.normal[2] == 1);
/// assert(r.toi_lower <= 0.5 && 0.5 - r.toi_lower < 1e-12);
///
/// const graze::CastResult<double> proved = graze::cast(floor, ball, {.tier = graze::Tier::certified});
/// assert(proved.toi_lower <= 0.5 && 0.5 <= proved.toi_upper);
///
/// // A ray: a point whose displacement is the direction, here a unit vector. So the time is the distance along it.
/// const graze::Body<double> ray{.position = {0, 0, 7}, .displacement = {0, 0, -1}};
/// assert(std::abs(graze::cast(floor, ray, {.t_max = graze::kInfinity<double>}).toi_lower - 7) < 1e-12);
/// @endcode
template <Scalar S>
CastResult<S> cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});

/// The standard tier by conservative advancement, whatever tier and method the options name. A baseline for
/// comparison: it takes a distance search for each step, and slows down if the bodies graze.
template <Scalar S>
CastResult<S> cast_conservative_advancement(const Body<S>& a, const Body<S>& b,
                                            const CastOptions<S>& options = {});
/// The standard tier by the GJK ray cast, whatever tier and method the options name.
template <Scalar S>
CastResult<S> cast_gjk_ray(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});
/// The standard tier by the MPR sweep, whatever tier and method the options name.
///
/// @code
/// // Three methods of the standard tier, and the other tiers, under a name each.
/// const graze::Body<double> plate{.shape = graze::Box<double>{{2, 2, 0.1}}};
/// const graze::Body<double> ball{
///     .shape = graze::Sphere<double>{0.25}, .position = {0, 0, 2}, .displacement = {0, 0, -4}};
/// for (const graze::CastResult<double>& r :
///      {graze::cast_mpr_sweep(plate, ball), graze::cast_gjk_ray(plate, ball), graze::cast_exact(plate, ball),
///       graze::cast_conservative_advancement(plate, ball), graze::cast_certified(plate, ball)}) {
///   assert(std::abs(r.toi_lower - 0.4125) < 1e-12);
/// }
/// @endcode
template <Scalar S>
CastResult<S> cast_mpr_sweep(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});

/// The certified tier, whatever tier and method the options name. It computes in double, and rounds times outward to
/// S. A tie may take a second search in pairs of doubles.
template <Scalar S>
CastResult<S> cast_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});
/// The exact tier, whatever tier and method the options name. A point can be cast at an ellipsoid, a cylinder or a
/// cone without a target distance. Otherwise these and hulls of shapes are `invalid_input` (Invalid::not_exact).
template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});

/// The guaranteed width of a bracket of the certified tier, over scale: 9,000 u. The rounding of support points, which
/// limits it, is below 100 u for shapes whose numbers are of similar size. Shapes that lie more than 1e12 of the
/// scale out in their own frames may have wider brackets.
inline constexpr double kLinearCertifiedWidth = 1e-12;

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/casts/ladder.hpp>
#endif
