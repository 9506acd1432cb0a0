// Placement of bodies at their meeting, for the families of needles, slivers, near-parallel and near-equal
// bodies.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

// The corners of a point, segment, triangle, box or hull, in its own frame.
[[nodiscard]] std::vector<Vec3<double>> corners(const Shape<double>& shape);

// B's position is such that at the time t, moving by v, its point b stands on A's point a and `beside` it
// (a and b from the bodies' positions, in world axes). Rounded to a float unless coordinates are doubles.
void meet(Draw& draw, Case& problem, const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& beside,
          const Vec3<double>& v, double t);
// A time in 0 .. 2 of the meeting: in most cases within the horizon of 1.
[[nodiscard]] double meeting_time(Random& random);
// Mostly 1, otherwise 1/2, 4 or infinity.
void draw_horizon(Random& random, Case& problem);
// 10^-k as this kind of coordinate. With integers it is rounded to a double.
[[nodiscard]] double small_unit(const Draw& draw, double k);
// Half a turn of the scene about one of the axes, or none: exact whatever the orientations are.
void turn_by_half_turn(Draw& draw, Case& problem);
// |q|^2 R(q) x, exact for small integers.
[[nodiscard]] Vec3<double> rotate_scaled(const Quaternion<double>& q, const Vec3<double>& x);
// An integer motion v past a contact with normal n: on a tangent, in, out, or none. The contact is at t0, at times 0.
struct IntegerPassage {
  Vec3<double> v;
  double t0;
};
[[nodiscard]] IntegerPassage draw_passage(Random& random, const Vec3<double>& n);
// The path passes a top feature (vertex, edge, face, or the pole of a sphere) of C at the height delta above
// it. The horizon may be infinite.
void pass_top_feature(Draw& draw, Case& problem, double delta);

}  // namespace graze::corpus
