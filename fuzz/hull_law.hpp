// What the building of a hull must be, by CGAL's hull of the same points in integers.
//
//   1  adjacency is made exactly for points that are not all in one plane;
//   2  its vertices are the extreme points, one of equal ones;
//   3  it is the graph of a triangulated sphere, 3 V - 6 edges, and every vertex below the top of a facet's
//      normal has a neighbour above itself;
//   4  the support along any direction is the greatest vertex, from any start, with adjacency or without;
//   5  faces that are taken as a hint are the boundary: every point on or below each, every extreme point a
//      corner, every edge shared by two.
// Exact: the sign of every comparison is one of integers. A fault is a printable reason, or empty.
#pragma once

#include <graze/scalar.hpp>
#include <span>
#include <string>

#include "corpus/random.hpp"

namespace graze::fuzz {

// Whether the building promises anything: finite, of magnitudes at most 1e60, and so near to each other that
// the prepared coordinates are exact.
template <Scalar S>
[[nodiscard]] bool is_hull_question(std::span<const Vec3<S>> points);

// `random` chooses directions, starts and how the faces are spoilt.
template <Scalar S>
[[nodiscard]] std::string hull_fault(std::span<const Vec3<S>> points, corpus::Random& random);

}  // namespace graze::fuzz
