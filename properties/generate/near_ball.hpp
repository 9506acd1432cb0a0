// Balls that meet features that floats, or doubles, cannot tell apart.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Half of the cases are a ball and a hull with three corners that are one to a float, which the ball meets first. The
// corner that a float takes for the farthest is not the farthest. In the others, a ball far smaller than the rounding
// of its position passes through a flat shape. Its side of that shape at contact is rounding. A pure function of the
// random bits.
[[nodiscard]] corpus::Case draw_near_ball(corpus::Random& random);

}  // namespace graze::law
