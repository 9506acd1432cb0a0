// A propeller: a body that rotates many times about an oblique axis, and another that stays above the swept volume,
// comes near it along the axis, or meets it. The axis that separates the other body from the whole swept volume is the
// axis of rotation, within rounding. The axis that separates the two bodies at any time is oblique to it.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Places the body that does not rotate, and gives it its motion over [0, horizon]. The shapes, the rotating body's pose
// and its spin stay as they are.
void place_propeller(corpus::Random& random, bool a_turns, corpus::Case& problem, double horizon);

}  // namespace graze::law
