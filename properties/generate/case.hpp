// The laws' own generator of cases: small, full of ties and touching, and easy to shrink.
//
// The families of the corpus are each hard in one way and as hard as requested. This one is broad instead. Every case
// picks a kind of coordinate: small integers, floats, full doubles, powers of two, or a mixture, with neighbours one
// unit in the last place from an earlier coordinate. It also picks one of three ways to place B: freely, with a feature
// of B meeting a feature of A at a chosen time (0 and t_max among them), or on shared planes. Shapes are of every kind.
// One in eight is a combinator, nested at most three deep. A pure function of the random bits, the same everywhere.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// size, 0 to 100, bounds the vertices of a hull (4 + size / 8) and the spread of exponents.
[[nodiscard]] corpus::Case draw_case(corpus::Random& random, int size);

}  // namespace graze::law
