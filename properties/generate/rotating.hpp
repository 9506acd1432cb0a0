// The laws' own generator of cases whose bodies turn: as broad as case.hpp, of which it takes the
// shapes, poses and motions.
//
// Every case picks how its bodies turn: freely; slowly; by many turns; both alike; in a way that cannot be
// seen; like a lash, whose tip meets the other body as fast as the bounds of its motion allow
// (tip_contact.hpp); like a propeller, the other body above what it sweeps; far out in their own frames, or on
// far arms, nearly as one (far.hpp); or not at all, one body or both.
// Pivots are at the origin of the body, at small integers, or far off. Two thirds of the cases are placed so
// that a point of B meets a point of A at a chosen time (0, t_max and what lies beyond among them), a few of
// those so that it stays beside it by one part in 2^8 or 2^24. A pure function of the random bits: the turn
// up to the meeting is a rational rotation, and its angle is summed (corpus/families/turning.hpp), so the
// bits are the same everywhere.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// size, 0 to 100, as in draw_case.
[[nodiscard]] corpus::Case draw_rotating(corpus::Random& random, int size);

}  // namespace graze::law
