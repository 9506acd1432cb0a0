// A body as exact rationals: its posed vertices at t = 0 in world axes, its radius, its displacement.
#pragma once

#include "corpus/case.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

// The vertices of a sum are the products of its parts': a shape with more of them than this through sums is
// refused (a hull given as such may have any number).
inline constexpr std::size_t kMostSumVertices = 4096;

struct ExactBody {
  // position + R(q) x, R(q) x = q x conj(q) / |q|^2, of every vertex x of the shape's core, in the order of
  // its index in a proof (core/graze/shape.hpp).
  std::vector<RationalPoint> vertices;
  // The body is the hull of the vertices plus a ball of this radius.
  Rational radius;
  RationalPoint displacement;
};

// Is the shape the hull of finitely many rational points plus one ball? So are points, segments, triangles,
// spheres, capsules, boxes, hulls, and what the combinators make of them: a sum adds the radii, and the parts
// of a hull must have the same one. Not so are ellipsoids, cylinders, cones, hulls of parts of different
// radii, sums of more than kMostSumVertices vertices, and invalid shapes. No vertex is computed.
[[nodiscard]] bool is_exact_body(const Shape<double>& shape);

// Throws std::invalid_argument, with the reason, where is_exact_body says no, and for a pose or a
// displacement that is not finite or a zero quaternion.
[[nodiscard]] ExactBody exact_body(const Body<double>& body);

}  // namespace graze::oracle
