// A propeller: a body that turns many times about an oblique axis, and another that stays above what it
// sweeps, or comes near along the axis, or meets it. The axis that separates the other body from all that is
// swept is the one of rotation, as far as can be told; that of the two bodies at any time leans.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Places the body that does not turn, and gives it its motion over [0, horizon]. The shapes, the turning
// body's pose and its spin stay as they are.
void place_propeller(corpus::Random& random, bool a_turns, corpus::Case& problem, double horizon);

}  // namespace graze::law
