// Other numbers for the same set: a shape described in another way. Nothing is returned if no other description is free
// of rounding. `salt` chooses.
#pragma once

#include <cstdint>
#include <optional>

#include "properties/edit/shape.hpp"

namespace graze::law {

// The vertices of a hull in another order, some of them twice, or the parts of a sum or a hull of shapes in another
// order.
[[nodiscard]] std::optional<Shape<double>> reordered(const Shape<double>& shape, std::uint64_t salt);

// A hull with points of it besides its vertices: midpoints of two of them, of edges among them, and of those and a
// third, which mostly lie inside. Segments, triangles and boxes become such hulls.
[[nodiscard]] std::optional<Shape<double>> with_redundant_points(const Shape<double>& shape,
                                                                 std::uint64_t salt);

// The same set as another kind of shape:
//
// - a sphere as a rounded point, a capsule as a rounded segment or the hull of two spheres
// - a box as a sum of segments or a hull
// - a cylinder as a disk swept along its axis, a cone as the hull of disk and apex
// - a rounding as a sum with a sphere, any sum or posing of polytopes as the hull of its vertices
[[nodiscard]] std::optional<Shape<double>> described_otherwise(const Shape<double>& shape,
                                                               std::uint64_t salt);

// Hulls given with adjacency become hulls without. Hulls without it that are large enough for it to matter
// (hull_graph.hpp) get it. In a combinator, the first such part changes.
[[nodiscard]] std::optional<Shape<double>> with_other_adjacency(const Shape<double>& shape);
// The same for both bodies, or nothing if neither has such a hull.
[[nodiscard]] std::optional<corpus::Case> with_other_hulls(const corpus::Case& problem);

}  // namespace graze::law
