// Proofs with wrong claims: found ones changed a little, and invented ones.
//
// Every change is small and in one place: bounds by one unit in the last place or by a lot, an axis tilted or turned
// round, another vertex, a point of a portal left out or moved. The result may claim too much, too little, or the right
// thing by other means. Only a checker can tell.
#pragma once

#include <graze/rotating_proof.hpp>

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::fuzz {

// One change half of the time, otherwise two or three.
void spoil(Proof& proof, const corpus::Case& problem, corpus::Random& random);
void spoil(RotatingProof& proof, const corpus::Case& problem, corpus::Random& random);

// The same proof with an earlier lower bound, or none, or a later upper one, or none.
[[nodiscard]] Proof claiming_less(Proof proof, const corpus::Case& problem, corpus::Random& random);

}  // namespace graze::fuzz
