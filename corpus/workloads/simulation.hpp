// A small simulation of rigid bodies, whose steps are the questions of a workload.
//
// Semi-implicit Euler: velocities first, then positions. The orientation step is q += dt/2 (0, w) q,
// normalised by a square root. A body that is below the floor is lifted onto it and gets an impulse at its
// lowest point, with friction. It is not a physics engine. It moves bodies as engines do, in additions,
// products, quotients and square roots in a fixed order, so that it has the same bits everywhere. Units:
// metres, seconds, radians. The z-axis points up.
#pragma once

#include <vector>

#include "corpus/families/draw.hpp"

namespace graze::corpus {

inline constexpr double kStep = 1.0 / 60;   // seconds
inline constexpr double kGravity = 9.8125;  // metres per second squared

struct Member {
  Shape<double> shape = Point<double>{};
  Vec3<double> position = Vec3<double>::Zero(), velocity = Vec3<double>::Zero();
  Quaternion<double> orientation = {};
  Vec3<double> spin = Vec3<double>::Zero();   // angular velocity, world axes
  Vec3<double> pivot = Vec3<double>::Zero();  // centre of its rotation, own frame (`velocity` is the pivot's)
  bool moves = false;
  bool falls = false;  // gravity and the floor act on it
  int group = 0;       // pairs of one group are not queried, except in group 0
  double floor = 0;    // z of the surface that it lies on
};

// Vector operations of the simulations, each sum in a fixed order.
[[nodiscard]] double dot(const Vec3<double>& l, const Vec3<double>& r);
[[nodiscard]] Vec3<double> cross(const Vec3<double>& l, const Vec3<double>& r);
[[nodiscard]] double length(const Vec3<double>& x);
// From y = 0 on the positive x-axis to the direction (c, s) of length 1, about z.
[[nodiscard]] Quaternion<double> turn_to(double c, double s);

class Simulation {
 public:
  // `place` is added to every position that is asked about: where the world's origin is.
  Simulation(Draw& draw, const Vec3<double>& place);

  std::vector<Member> members;
  double skin = 0;  // at rest, bodies are this far above what they lie on (length)
  double bounce = 0.25, friction = 0.5;

  Draw& draw() { return draw_; }
  // Moves everything by a step. The velocities are those that the questions of this step were asked with.
  void move();
  // Gravity for a step, on what falls.
  void accelerate();
  // The questions of a step, at the velocities that are set: the pairs of which one moves and whose swept
  // bounding boxes meet.
  [[nodiscard]] std::vector<Case> questions() const;

 private:
  void meet_floor(Member& one) const;

  Draw& draw_;
  Vec3<double> place_;
  bool in_seconds_;  // a question is of velocities over 1/60 s, not of displacements over 1
  StartPolicy policy_;
};

}  // namespace graze::corpus
