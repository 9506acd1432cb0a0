// What lies far from where it is measured: bodies far out in their own frames, and both bodies on arms that
// are far longer than they are. What is lost to rounding there is a few units in the last place of the
// distance, and the bodies are that near to each other: what the drawing of shapes of moderate size, wherever
// their pivots are, comes to by no chance.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Two rods, of which one turns and comes tip to tip with the other at the time t; one or both are 2^10 to
// 2^50 out in their own frames. Their pivots are at the far ends: balls about them touch where the tips do.
// Gives both bodies shape, pose, position and spin; they do not move otherwise.
void place_far_rods(corpus::Random& random, corpus::Case& problem, double t);

// Both bodies turn about points 2^8 to 2^40 away, alike but for a few units in the last place: of a pivot,
// or of a rotation vector. Gives both bodies shape, pose, position and spin, and one velocity.
void place_far_arms(corpus::Random& random, corpus::Case& problem);

}  // namespace graze::law
