// Meshes of bodies and of their difference, for pictures in three dimensions.
//
// A polytope's mesh is its exact hull. A curved shape's is the hull of points of it: a grid of them for the whole,
// and rings about the direction in which it touches, each at half the angle of the one before, so that near the
// contact the mesh is as fine as anybody cares to look. Every vertex of a mesh is a point of the shape (but for the
// rounding of its coordinates); the mesh of a curved shape lies within it.
#pragma once

#include <array>
#include <vector>

#include "reports/drawing/geometry.hpp"

namespace graze::show {

struct Mesh {
  std::vector<Vec3<double>> vertices = {};
  std::vector<std::array<int, 3>> triangles =
      {};                                      // counter-clockwise from outside; of a flat mesh both sides
  std::vector<std::array<int, 2>> edges = {};  // where planes meet that differ by more than a few degrees
  bool curved = false;
};

// Of the directions in which a curved shape is sampled: so many around, a multiple of four, and from pole to pole; and
// rings about that in which it touches, each at half the angle of the one before. 20 rings come to 3e-5 degrees, where
// the mesh is off by 1e-13 of a radius.
struct Grid {
  int meridians = 40, parallels = 20, rings = 20;
};
inline constexpr Grid kFine = {}, kCoarse = {24, 12, 0};
// The fewest rings, of 4 to 20, with which a mesh of this size is off by less than `length` beside its contact.
[[nodiscard]] int rings_for(double length, double size);

// In the shape's frame. `towards`: the direction, in that frame, in which the shape touches; zero for none.
[[nodiscard]] Mesh mesh_of(const Shape<double>& shape, const draw::Vec& towards, Grid grid = kFine);

// C = A - B + ball(margin) of the bodies as they stand; `normal` is that of C where it touches, zero for none.
[[nodiscard]] Mesh mesh_of_difference(const Shape<double>& a, const draw::Pose& at_a, const Shape<double>& b,
                                      const draw::Pose& at_b, double margin, const draw::Vec& normal);

}  // namespace graze::show
