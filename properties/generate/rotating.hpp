// The laws' own generator of cases with rotating bodies. It is as broad as case.hpp, and takes the shapes, poses and
// motions from there.
//
// Every case picks the rotation of its bodies:
//
// - freely, slowly, by many turns, or both alike
// - invisibly
// - like a lash, whose tip meets the other body as fast as the bounds of its motion allow (tip_contact.hpp)
// - like a propeller, with the other body above its sweep
// - far out in their own frames, or on far arms, nearly as one (far.hpp)
// - not at all, one body or both
//
// Pivots are at the origin of the body, at small integers, or far off. In two thirds of the cases a point of B meets a
// point of A at a chosen time (0, t_max and times beyond among them). In a few of those it stays beside it by one part
// in 2^8 or 2^24. A pure function of the random bits: the rotation up to the meeting is rational, and its angle is
// summed (corpus/families/turning.hpp), so the bits are the same everywhere.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// size, 0 to 100, as in draw_case.
[[nodiscard]] corpus::Case draw_rotating(corpus::Random& random, int size);

}  // namespace graze::law
