// What an accepted proof settles about an answer, in double. Every bound is rounded up by kSlack, and the
// scale down: what is then still within the limit is so without predicate_error; the rest is the oracle's.
#pragma once

#include "properties/judge/judgement.hpp"

namespace graze::law {

inline constexpr double kSlack = 1 + 1e-6;

// The proof says as much as the outcome claims.
[[nodiscard]] bool proves_verdict(const Proof& proof, Outcome outcome);
// Of turning bodies: and the bracket that the answer states.
[[nodiscard]] bool proves(const RotatingProof& proof, const engine::Answer& answer);

// Nothing about the answer is left open. Of tier standard: its errors are within kappa u scale; of tier
// certified: the verdict is shown, the bracket holds, and it is narrow. `seen`: the case as the method saw
// it.
[[nodiscard]] bool is_settled_by(const Proof& proof, const engine::Method& method, const corpus::Case& seen,
                                 const engine::Answer& answer);

}  // namespace graze::law
