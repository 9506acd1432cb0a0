// What the building of a hull must be, by CGAL's hull of the same points in integers.
//
//   1  adjacency is made exactly for points that are not all in one plane;
//   2  its vertices are the extreme points, one of equal ones;
//   3  it is the graph of a triangulated sphere, 3 V - 6 edges, and every vertex below the top of a facet's
//      normal has a neighbour above itself;
//   4  the support along any direction is the greatest vertex but for rounding, with adjacency or without;
//   5  faces that are taken as a hint are the boundary: every point on or below each, every extreme point a
//      corner, every edge shared by two.
// The sign of every comparison is one of integers. A fault is a printable reason, or empty.
#pragma once

#include <graze/scalar.hpp>
#include <span>
#include <string>
#include <vector>

#include "corpus/random.hpp"

namespace graze::fuzz {

// The points as far as the building promises something of them: those that are finite, all made smaller by
// one power of two where a magnitude exceeds 1e60, of float 2^126, and a coordinate taken for zero where
// another is so much greater that the prepared coordinates would not be exact.
template <Scalar S>
[[nodiscard]] std::vector<Vec3<S>> as_hull_question(std::span<const Vec3<double>> points);

// `random` chooses directions, starts and how the faces are spoilt.
template <Scalar S>
[[nodiscard]] std::string hull_fault(std::span<const Vec3<S>> points, corpus::Random& random);

}  // namespace graze::fuzz
