/// @file
/// A body that may also rotate: a Body, its rotation over one unit of t, and the pivot.
#pragma once

#include <graze/body.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// A body that moves and rotates at a constant rate about one axis. World axes, the caller's units, radians.
///
/// At time t, the body's point that is at x at t = 0 is at
///
///     R(t rotation) (x - c) + c + t displacement,     c = position + R(orientation) pivot.
///
/// R(w) is the rotation by |w| radians about w, right-handed. It may be many turns, up to 2^30 radians over the cast.
///
/// @code
/// // A door of 0.8 m, closed along x, opens by a quarter turn about its hinge at the origin.
/// const graze::RotatingBody<double> door{
///     .body = {.shape = graze::Box<double>{{0.4, 0.02, 1}}, .position = {0.4, 0, 0}},
///     .rotation = {0, 0, 1.5707963267948966},
///     .pivot = {-0.4, 0, 0}};
/// assert(door.pivot == -door.body.position);
///
/// // A fan at a pose of Eigen's (eigen.hpp) rotates about its own centre.
/// Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, 2));
/// pose.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
/// const graze::RotatingBody<double> fan{.body = {.shape = graze::Box<double>{{0.5, 0.1, 0.02}},
///                                                .position = pose.translation(),
///                                                .orientation = graze::orientation_of(pose)},
///                                       .rotation = {0, 0, 6}};
/// assert(fan.body.position[2] == 2 && fan.body.orientation.z > 0);
/// @endcode
template <Scalar S>
struct RotatingBody {
  Body<S> body;  ///< The shape, the pose at t = 0, and the displacement of the pivot.
  /// Rotation vector over one unit of t: radians along the axis, world axes.
  Vec3<S> rotation = {0, 0, 0};
  Vec3<S> pivot = {0, 0, 0};  ///< Centre of the rotation, in the body's own frame.
};

}}  // namespace graze::GRAZE_LINKAGE
