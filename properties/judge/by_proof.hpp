// Decides in double how much of an answer an accepted proof settles. Every bound is rounded up by kSlack, and the scale
// down. A result within the limit is then so without predicate_error, and the rest is left to the oracle.
#pragma once

#include "properties/judge/judgement.hpp"

namespace graze::law {

inline constexpr double kSlack = 1 + 1e-6;

// The proof says as much as the outcome claims.
[[nodiscard]] bool proves_verdict(const Proof& proof, Outcome outcome);
// For rotating bodies, the proof also covers the bracket that the answer states.
[[nodiscard]] bool proves(const RotatingProof& proof, const engine::Answer& answer);

// Nothing about the answer is left open. In tier standard, its errors are within kappa u scale. In tier certified, the
// verdict is shown, the bracket holds, and it is narrow. `seen`: the case as the method saw it.
[[nodiscard]] bool is_settled_by(const Proof& proof, const engine::Method& method, const corpus::Case& seen,
                                 const engine::Answer& answer);

}  // namespace graze::law
