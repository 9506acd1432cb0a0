// The content of a picture of a case: the time and place where the bodies meet or pass, the distance, and the
// viewing direction.
#pragma once

#include <string>

#include "reports/drawing/geometry.hpp"

namespace graze::draw {

// The least distance (>= 0) or the depth of penetration (< 0) of the bodies at one time.
struct Separation {
  Real distance = 0;
  Vec normal = Vec::Zero();                          // unit, from A to B, zero if none is known
  Vec point_a = Vec::Zero(), point_b = Vec::Zero();  // about the scene's origin
};

struct Scene {
  const corpus::Case* problem = nullptr;
  std::string result;    // the outcome and its time, by our default method
  bool drawable = true;  // the method took the case
  bool has_contact = false;

  Vec origin = Vec::Zero();  // A's position: places below are seen from here
  Real diagonal_a = 0, diagonal_b = 0, scale = 0;
  bool turns = false;
  Real speed = 0;           // speed of B's contact point past A's at the moment, length per unit of t
  Real turn_rate = 0;       // the faster body's, radians per unit of t
  Real moment = 0;          // first contact, or the nearest approach
  Real end = 0;             // the last time that is drawn
  Vec focus = Vec::Zero();  // the contact, or the middle of the gap between the bodies
  Vec touching_a = Vec::Zero(), touching_b = Vec::Zero();  // the points of A and B, at the moment
  Vec normal = Vec::Zero();                                // unit, from A to B
  Vec velocity = Vec::Zero();                              // velocity of B's point there relative to A's
  // A length that decides the case, if one is far below the scene: a clearance, a depth, a gap.
  std::optional<Real> margin;
  std::string margin_name;

  [[nodiscard]] Pose pose_a(Real t, const Vec& about) const {
    return pose_at(problem->a, problem->spin_a, t, origin + about);
  }
  [[nodiscard]] Pose pose_b(Real t, const Vec& about) const {
    return pose_at(problem->b, problem->spin_b, t, origin + about);
  }
};

// Calls our default method once. For a miss it searches the nearest approach.
[[nodiscard]] Scene make_scene(const corpus::Case& problem);

// Towards `axis`, or, without one, along the contact plane and across the motion: A below, B above, moving
// to the right.
[[nodiscard]] View make_view(const Scene& scene, const std::optional<Vec3<double>>& axis);

}  // namespace graze::draw
