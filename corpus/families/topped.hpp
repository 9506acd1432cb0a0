// Shapes with a known top feature, and paths that pass it: the building blocks of the grazing families.
//
// Frame: a topped shape, posed, lies in z <= 0. Its top feature lies in z = 0 and holds the origin. B is the
// mirror image at the origin of a topped shape, so that C = A - B is the sum of two topped ones, and topped.
// All are on the grid (draw.hpp): statements about the plane z = 0 are exact.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

struct Topped {
  Shape<double> shape;
  Quaternion<double> orientation;
  Vec3<double> position = Vec3<double>::Zero();
};

// Points, segments, triangles, boxes (standing on a corner, or on an edge) and hulls of 4 to 24 vertices,
// about `reach` in size. Tilted boxes have integers up to 10. The other vertices of a triangle or a hull lie
// below z = 0 by at least a grid step, and by 1/4.
Topped topped_vertex(Draw& draw, double reach);
// The top is an edge along `edge`, a horizontal vector of the grid, its ends at one or two times it, either
// way.
Topped topped_edge(Draw& draw, double reach, const Vec3<double>& edge);
Topped topped_face(Draw& draw, double reach);
// One of the three, the edge any.
Topped topped_any(Draw& draw, double reach);
// Horizontal. It is along an axis half of the time.
Vec3<double> edge_vector(Draw& draw);
// The hull of `top` and of points below it, 4 to 24 together, in any order, moved by -shift.
Shape<double> hull_under(Draw& draw, std::vector<Vec3<double>> top, double reach, const Vec3<double>& shift);

// Turned about z, if that is exact.
void turn_about_z(Draw& draw, Topped& body);
// {-x : x in body}.
Topped mirrored(const Topped& body);
// No point of the body is farther from the z-axis.
double reach_of(const Topped& body);

// A = a, B = the mirror image of b, at the time t0 in 3/8 .. 5/8 at (0, 0, delta), so that the path passes
// C's top feature, the origin, at the height delta. v is horizontal: along `direction` if that is not zero.
// B's own z-coordinate is exactly delta, however small. The bodies start apart and may end so. The horizon
// may be infinite. The scene is then left as it is (one time in six), or turned exactly by a rotation of the
// cube. With full doubles, half of the time, it is turned by any integer quaternion and rounded.
void pass_over(Draw& draw, Case& problem, const Topped& a, const Topped& b, const Vec3<double>& direction,
               double delta);
// The end of it: the horizon, the scale of time, the turn of the scene, and which body is which.
void finish_exactly(Draw& draw, Case& problem);

}  // namespace graze::corpus
