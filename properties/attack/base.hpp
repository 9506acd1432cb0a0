// The bases of mutants: true proofs of cases that an oracle decides cheaply.
#pragma once

#include <optional>

#include "corpus/format/proof_io.hpp"
#include "corpus/random.hpp"

namespace graze::attack {

// Small shapes. Half of them are linear (properties/generate/case.hpp). Most of the others are of the kinds that a
// bound of motion is written for:
//
// - a body that sweeps about its pivot by parts of a turn, whole turns and several, with the other beside its sweep,
//   resting with a pivot of its own, sliding or rotating too
// - balls written as other shapes, on far pivots
//
// The rest are the laws' own rotating cases (properties/generate/rotating.hpp).
[[nodiscard]] corpus::Case draw_case(corpus::Random& random);

// The proof of a method that `random` names, if it has one for this case: a rotating one for a case with a
// spin.
[[nodiscard]] std::optional<corpus::ProofRecord> proved(const corpus::Case& problem, corpus::Random& random);

}  // namespace graze::attack
