// Rounded points of a body that another may be placed at, in world axes at t = 0.
#pragma once

#include <vector>

#include "corpus/case.hpp"

namespace graze::fuzz {

// The feature points by kind of shape. A shape with its vertices as numbers returns them in the order of those numbers.
// A box and other polytopes return their vertices. A curved shape returns the middles of the faces of its bounding box.
// A shape without a point returns none.
[[nodiscard]] std::vector<Vec3<double>> feature_points(const Body<double>& body);

// The point in the body's own frame.
[[nodiscard]] Vec3<double> into_body(const Body<double>& body, const Vec3<double>& world);

}  // namespace graze::fuzz
