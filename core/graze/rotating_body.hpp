// A body that may also turn. World axes, caller's units, radians.
#pragma once

#include <graze/body.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

// World position of the body's point x at time t, with x_0 = position + R(orientation) x at t = 0:
//   R(t rotation) (x_0 - c) + c + t displacement,     c = position + R(orientation) pivot.
// R(w) is the rotation by |w| radians about w (right-handed); any angle, many turns too.
template <Scalar S>
struct RotatingBody {
  Body<S> body;
  Vec3<S> rotation = Vec3<S>::Zero();  // rotation vector over one unit of t: radians along the axis
  Vec3<S> pivot = Vec3<S>::Zero();     // centre of the rotation, in the body's own frame
};

}}  // namespace graze::GRAZE_LINKAGE
