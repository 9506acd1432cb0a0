// Cases far from their frame of reference: bodies far out in their own frames, and both bodies on arms that are far
// longer than they are. Rounding there loses a few units in the last place of the distance, and the bodies are that
// near to each other. Drawing shapes of moderate size never produces this by chance, wherever their pivots are.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Two rods, of which one rotates and comes tip to tip with the other at the time t. One or both are 2^10 to 2^50 out in
// their own frames. Their pivots are at the far ends, so balls about them touch where the tips do. Gives both bodies
// shape, pose, position and spin, and no other motion.
void place_far_rods(corpus::Random& random, corpus::Case& problem, double t);

// Both bodies rotate about points 2^8 to 2^40 away. They are alike except for a few units in the last place of a pivot
// or a rotation vector. Gives both bodies shape, pose, position and spin, and one velocity.
void place_far_arms(corpus::Random& random, corpus::Case& problem);

}  // namespace graze::law
