/// @file
/// A body: a shape, its pose at t = 0, and its displacement over one unit of t.
#pragma once

#include <graze/shape.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// A body that moves without rotation. All vectors are in world axes and in the caller's units.
///
/// At time t, the body's point x is at
///
///     position + R(orientation) x + t displacement.
///
/// Invalid lists the inputs that a query refuses. Use body_at() of eigen.hpp if the pose is an `Eigen::Isometry3d`, and
/// RotatingBody if the body rotates.
///
/// @code
/// const graze::Body<double> crate{
///     .shape = graze::Box<double>{{0.5, 0.5, 0.5}}, .position = {0, 0, 10}, .displacement = {0, 0, -20}};
/// const std::vector<graze::Body<double>> bodies = {crate, {.shape = graze::Sphere<double>{1}}, {.position = {1, 0, 0}}};
/// assert(crate.orientation.is_identity() && bodies[0].position == crate.position);
///
/// const graze::Body<double> refused{.position = {graze::kLeastMagnitude / 2, 0, 0}};  // below the range
/// assert(graze::validate(refused) == graze::Invalid::out_of_range);
/// @endcode
template <Scalar S>
struct Body {
  Shape<S> shape = {};               ///< In the body's own frame. By default a point.
  Vec3<S> position = {0, 0, 0};      ///< Position of the origin of the body's frame at t = 0.
  Quaternion<S> orientation = {};    ///< Any quaternion other than 0. An `Eigen::Quaternion` converts to it.
  Vec3<S> displacement = {0, 0, 0};  ///< Length per unit of t.
};

}}  // namespace graze::GRAZE_LINKAGE
