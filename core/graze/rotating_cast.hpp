/// @file
/// Rotating casts: when do two convex shapes first touch, if both move and rotate?
#pragma once

#include <graze/rotating_result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// Casts A against B, rotation included, over [0, t_max].
///
/// The bodies are in world axes, the caller's units and radians. Without a method, the plan decides what must be
/// simulated. With one, that method runs for any motion. Everything is computed in double, and times are rounded
/// outward to S. The standard and the certified tier support all shapes. A certified bracket of rotating bodies is at
/// most 1e-9 of the scale wide. The exact tier is `invalid_input` if a rotation is visible. The table of guarantees
/// has the rest.
///
/// Invalid input is the outcome `invalid_input`. Nothing is thrown, and nothing but a requested proof is allocated.
/// There is no global state. A hit takes some hundred support evaluations, and the cost grows with the angle.
///
/// @code
/// // A bar of half length 1 rotates by a quarter turn. Its end meets a post.
/// const graze::RotatingBody<double> bar{
///     .body = {.shape = graze::Capsule<double>{0.1, 1}, .orientation = {1, 0, 1, 0}},
///     .rotation = {0, 0, 1.5707963267948966}};
/// const graze::RotatingBody<double> post{.body = {.shape = graze::Cylinder<double>{0.1, 5}, .position = {0, 1, 0}}};
///
/// const graze::RotatingResult<double> r = graze::cast(bar, post, {.tier = graze::Tier::certified});
/// assert(r.outcome == graze::Outcome::hit && r.plan.effects == graze::Effects::rotating);
/// // cos(angle) = 0.2: the bar's axis is 0.2 from the post's.
/// const double angle = std::acos(0.2) / 1.5707963267948966;
/// assert(r.toi_lower <= angle && angle <= r.toi_upper && r.toi_upper - r.toi_lower < 1e-8);
/// @endcode
template <Scalar S>
RotatingResult<S> cast(const RotatingBody<S>& a, const RotatingBody<S>& b,
                       const RotatingOptions<S>& options = {});

/// The plan of cast() without a method. For invalid input the plan has no meaning.
///
/// @code
/// const graze::RotatingBody<double> spinning_ball{.body = {.shape = graze::Sphere<double>{1}}, .rotation = {0, 0, 300}};
/// const graze::RotatingBody<double> box{
///     .body = {.shape = graze::Box<double>{{1, 1, 1}}, .position = {5, 0, 0}, .displacement = {-4, 0, 0}}};
/// const graze::Plan plan = graze::plan(spinning_ball, box);
/// assert(plan.effects == graze::Effects::linear && plan.has(graze::PlanReason::unseen_spin_a));
/// @endcode
template <Scalar S>
Plan plan(const RotatingBody<S>& a, const RotatingBody<S>& b, const RotatingOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/rotating/rotating_search.hpp>
#endif
