// h(n) = max over x in shape of n.x, in rounded doubles. It is used to place, bound and measure cases, never
// to judge an answer. n is in the body's own frame and of any length. The bits are the same everywhere: a
// fixed order of additions, multiplications, divisions and square roots.
#pragma once

#include "corpus/case.hpp"

namespace graze::corpus {

// -infinity for a shape without a point: an empty hull or combinator, a missing part.
[[nodiscard]] double support_value(const Shape<double>& shape, const Vec3<double>& n);

// The box [low, high], axes of the shape's frame turned by q.
struct Bounds {
  Vec3<double> low, high;
};
[[nodiscard]] Bounds bounds(const Shape<double>& shape, const Quaternion<double>& q = {});

}  // namespace graze::corpus
