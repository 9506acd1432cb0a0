// Bodies that stand, lie and roll on the plane z = 0, and regular polygons: what the families of bodies at
// rest, of wheels and of equal distances are made of.
#pragma once

#include <array>

#include "corpus/families/topped.hpp"

namespace graze::corpus {

// Posed, the body lies in z >= 0 and touches z = 0. On the grid: both statements are exact.
//
// The shape is one of these:
//   - a ball,
//   - a capsule, cylinder or cone that stands or lies (a cone on its side, one of 3 : 4 : 5),
//   - an ellipsoid on a pole,
//   - one of topped_any(), mirrored.
// In half of the cases a ball is added about it. Extents are up to `reach`, 4 at least.
[[nodiscard]] Topped standing(Draw& draw, double reach);
// The same, without corners: the first three kinds.
[[nodiscard]] Topped standing_smooth(Draw& draw, double reach);

// Half a turn about x, which exchanges up and down.
inline constexpr Quaternion<double> kUpsideDown = {0, 1, 0, 0};
// z to -y: an upright body then lies along y.
inline constexpr Quaternion<double> kLaidDown = {1, 1, 0, 0};

// Turns the whole scene by an integer quaternion q with every length times |q|^2, so that nothing is rounded:
// |q|^2 R(q) x is a sum of integers times x. It covers the shapes that `stretched` supports.
void turn_stretched(Draw& draw, Case& problem);
// The shape times a small integer, exactly. It covers leaves and rounded or posed shapes.
[[nodiscard]] Shape<double> stretched(const Shape<double>& shape, double factor);
// x and `units` in its last place, of a float or of a double by the kind of coordinate.
[[nodiscard]] double moved_by_units(const Draw& draw, double x, int units);

using Point2 = std::array<double, 2>;
// The corners of a regular polygon of radius 1, first * 2^doublings of them, first = 3, 4 or 5. By square
// roots, to a few units in the last place.
[[nodiscard]] std::vector<Point2> regular_polygon(int first, int doublings);
// Points of a sphere of radius 1, to rounding, evenly spread: heights in equal steps, and turned by the golden
// angle from one to the next.
[[nodiscard]] std::vector<Vec3<double>> sphere_points(int count);

}  // namespace graze::corpus
