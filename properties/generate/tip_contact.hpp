// A lash: a long and thin body that rotates about its end, square to itself. Its other end meets the other body's
// front. The point of contact moves along the normal, as fast as any point of the body may, so any shortfall in a bound
// of its motion shows here.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

struct Lash {
  bool is_a = false;  // the body that is the lash
  int axis = 0;       // the coordinate axis that it rotates about
};
[[nodiscard]] Lash draw_lash(corpus::Random& random);
// A turn of it up to the meeting, of small integers.
[[nodiscard]] Quaternion<double> draw_turn_of(const Lash& lash, corpus::Random& random);

// Gives the lash its shape, pose, pivot and motion, and the other body, every second time, the shape of a ball. The
// bodies have rotated by turn_a and turn_b when they meet at t > 0, or stay beside each other.
void place_lash(corpus::Random& random, const Lash& lash, corpus::Case& problem,
                const Quaternion<double>& turn_a, const Quaternion<double>& turn_b, double t);

}  // namespace graze::law
