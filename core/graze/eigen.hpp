// Poses as Eigen's isometries: {R x + t}, in Eigen::Isometry3f and Eigen::Isometry3d.
//
// The rotation becomes a quaternion, whose four numbers are rounded, a few u each; from there on they are the
// exact pose (scalar.hpp). `pose` must be what its type says, a rotation and a translation. Quaternions need
// no help: an Eigen::Quaternion converts to graze's wherever one is asked for.
#pragma once

#include <Eigen/Geometry>
#include <graze/body.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S, int kOptions>
Quaternion<S> orientation_of(const Eigen::Transform<S, 3, Eigen::Isometry, kOptions>& pose) {
  return Eigen::Quaternion<S>(pose.linear());
}

// The body of `shape` at `pose`, moving by `displacement` per unit of t.
template <Scalar S, int kOptions>
Body<S> body_at(std::type_identity_t<Shape<S>> shape,
                const Eigen::Transform<S, 3, Eigen::Isometry, kOptions>& pose,
                const std::type_identity_t<Vec3<S>>& displacement = Vec3<S>::Zero()) {
  return {.shape = std::move(shape),
          .position = pose.translation(),
          .orientation = orientation_of(pose),
          .displacement = displacement};
}

// {R x + t : x in shape}.
template <Scalar S, int kOptions>
Shape<S> posed(std::type_identity_t<Shape<S>> shape,
               const Eigen::Transform<S, 3, Eigen::Isometry, kOptions>& pose) {
  return posed<S>(std::move(shape), Vec3<S>(pose.translation()), orientation_of(pose));
}

}}  // namespace graze::GRAZE_LINKAGE
