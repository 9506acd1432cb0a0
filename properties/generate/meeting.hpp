// Parts shared by drawn meetings.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// The place of a body's point x at the time t, when the body has rotated by `turn` about its pivot, less the body's
// position.
[[nodiscard]] Vec3<double> carried(const Body<double>& body, const corpus::Spin& spin,
                                   const Quaternion<double>& turn, double t, const Vec3<double>& x);

// Each component within size of 0.
[[nodiscard]] Vec3<double> draw_vector(corpus::Random& random, double size);

// With components that are integers of 1 to 4 or within [-1, 1]. Its length is not 1.
[[nodiscard]] Quaternion<double> draw_orientation(corpus::Random& random);

// A point to meet at: a vertex, or a point on a side of the bounds, in the shape's own frame.
[[nodiscard]] Vec3<double> draw_feature(corpus::Random& random, const Shape<double>& shape);

// A distance that makes of a meeting a near miss, or a shallow overlap: 2^-8 or 2^-24, of either sign.
[[nodiscard]] double draw_beside(corpus::Random& random);

}  // namespace graze::law
