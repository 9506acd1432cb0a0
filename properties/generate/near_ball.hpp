// Balls that meet what floats, or doubles, cannot tell apart.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Half of them: a ball, and a hull with three corners that are one to a float, which it meets first; the corner that a
// float takes for the farthest is not. The others: a ball far smaller than what its place rounds by, and a flat shape,
// which it passes through; on which side of that it is at contact is rounding. A pure function of the random bits.
[[nodiscard]] corpus::Case draw_near_ball(corpus::Random& random);

}  // namespace graze::law
