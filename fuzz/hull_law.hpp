// Checks the building of a hull against CGAL's hull of the same points in integers.
//
//   1. Adjacency is made exactly for points that are not all in one plane.
//   2. Its vertices are the extreme points, one of equal ones.
//   3. It is the graph of a triangulated sphere with 3 V - 6 edges. Every vertex below the top of a facet's normal has
//      a neighbour above itself.
//   4. The support along any direction is the greatest vertex within rounding, with adjacency or without.
//   5. Faces that are taken as a hint are the boundary: every point is on or below each of them, every extreme point is
//      a corner, and every edge is shared by two.
// The sign of every comparison is one of integers. A fault is a printable reason, or empty.
#pragma once

#include <graze/scalar.hpp>
#include <span>
#include <string>
#include <vector>

#include "corpus/random.hpp"

namespace graze::fuzz {

// The points that the building's guarantee covers, which are the finite ones. All of them are made smaller by one power
// of two where a magnitude exceeds 1e60, in float 2^126. A coordinate is taken for zero where another is so much
// greater that the prepared coordinates would not be exact.
template <Scalar S>
[[nodiscard]] std::vector<Vec3<S>> as_hull_question(std::span<const Vec3<double>> points);

// `random` chooses directions, starts and how the faces are spoilt.
template <Scalar S>
[[nodiscard]] std::string hull_fault(std::span<const Vec3<S>> points, corpus::Random& random);

}  // namespace graze::fuzz
