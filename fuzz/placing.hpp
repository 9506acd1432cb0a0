// Points of a body that another may be placed at, in world axes at t = 0; rounded.
#pragma once

#include <vector>

#include "corpus/case.hpp"

namespace graze::fuzz {

// The vertices of a shape that has them as numbers, in the order of those numbers; of a box and other
// polytopes their vertices; of what is curved the middles of the faces of its bounding box. None for a shape
// without a point.
[[nodiscard]] std::vector<Vec3<double>> feature_points(const Body<double>& body);

// The point in the body's own frame.
[[nodiscard]] Vec3<double> into_body(const Body<double>& body, const Vec3<double>& world);

}  // namespace graze::fuzz
