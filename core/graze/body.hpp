// A body: a shape, where it is at t = 0, and how it moves over one unit of t. World axes, caller's units.
#pragma once

#include <graze/shape.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

// World position of the body's point x at time t (linear motion):
//   position + R(orientation) x + t displacement.
// From an Eigen::Isometry3d: body_at (eigen.hpp).
template <Scalar S>
struct Body {
  Shape<S> shape = {};
  Vec3<S> position = Vec3<S>::Zero();
  Quaternion<S> orientation = {};          // any q != 0; an Eigen::Quaternion converts to it
  Vec3<S> displacement = Vec3<S>::Zero();  // length per unit of t
};

}}  // namespace graze::GRAZE_LINKAGE
