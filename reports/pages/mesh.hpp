// Meshes of bodies and of their difference, for pictures in three dimensions.
//
// A polytope's mesh is its exact hull. The mesh of a curved shape is the hull of points on it. A grid of points covers
// the whole shape. Rings surround the contact direction, each at half the angle of the one before, so the mesh is as
// fine as needed near the contact. Every vertex of a mesh is a point of the shape (except for rounding of its
// coordinates), so the mesh of a curved shape lies within the shape.
#pragma once

#include <array>
#include <vector>

#include "reports/drawing/geometry.hpp"

namespace graze::show {

struct Mesh {
  std::vector<Vec3<double>> vertices = {};
  std::vector<std::array<int, 3>> triangles =
      {};                                      // counter-clockwise from outside, both sides of a flat mesh
  std::vector<std::array<int, 2>> edges = {};  // edges where planes meet that differ by more than a few
                                               // degrees
  bool curved = false;
};

// The directions in which a curved shape is sampled: `around` of them, a multiple of four, and the number from pole to
// pole. Rings surround the contact direction, each at half the angle of the one before. With 20 rings the last is at
// 3e-5 degrees, and the mesh there deviates by 1e-13 of a radius.
struct Grid {
  int meridians = 40, parallels = 20, rings = 20;
};
inline constexpr Grid kFine = {}, kCoarse = {24, 12, 0};
// The fewest rings, of 4 to 20, with which a mesh of this size is off by less than `length` beside its contact.
[[nodiscard]] int rings_for(double length, double size);

// The mesh in the shape's frame. `towards` is the contact direction in that frame, or zero if there is no contact.
[[nodiscard]] Mesh mesh_of(const Shape<double>& shape, const draw::Vec& towards, Grid grid = kFine);

// The mesh of C = A - B + ball(margin) for the bodies at their poses. `normal` is C's normal at the contact, or zero
// for no contact.
[[nodiscard]] Mesh mesh_of_difference(const Shape<double>& a, const draw::Pose& at_a, const Shape<double>& b,
                                      const draw::Pose& at_b, double margin, const draw::Vec& normal);

}  // namespace graze::show
