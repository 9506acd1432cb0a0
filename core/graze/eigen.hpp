/// @file
/// Bodies and shapes from `Eigen::Isometry3f` and `Eigen::Isometry3d`, which are {R x + t}.
///
/// The rotation becomes a quaternion. Its four numbers are rounded, by a few u each. From there on they are the exact
/// pose. `pose` must be a rotation and a translation. An `Eigen::Quaternion` converts to graze's without this header.
#pragma once

#include <Eigen/Geometry>
#include <graze/body.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The rotation of a pose as a quaternion, rounded by a few u.
template <Scalar S, int kOptions>
Quaternion<S> orientation_of(const Eigen::Transform<S, 3, Eigen::Isometry, kOptions>& pose) {
  return Eigen::Quaternion<S>(pose.linear());
}

/// The body of `shape` at `pose`, which moves by `displacement` per unit of t, in world axes.
///
/// @code
/// Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, 5));
/// pose.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
/// const graze::Body<double> crate = graze::body_at(graze::Box<double>{{1, 1, 1}}, pose, {0, 0, -10});
/// assert(crate.position[2] == 5 && !crate.orientation.is_identity());
/// @endcode
template <Scalar S, int kOptions>
Body<S> body_at(std::type_identity_t<Shape<S>> shape,
                const Eigen::Transform<S, 3, Eigen::Isometry, kOptions>& pose,
                const std::type_identity_t<Vec3<S>>& displacement = Vec3<S>::Zero()) {
  return {.shape = std::move(shape),
          .position = pose.translation(),
          .orientation = orientation_of(pose),
          .displacement = displacement};
}

/// The shape at a pose: {R x + t : x in shape}.
template <Scalar S, int kOptions>
Shape<S> posed(std::type_identity_t<Shape<S>> shape,
               const Eigen::Transform<S, 3, Eigen::Isometry, kOptions>& pose) {
  return posed<S>(std::move(shape), Vec3<S>(pose.translation()), orientation_of(pose));
}

}}  // namespace graze::GRAZE_LINKAGE
