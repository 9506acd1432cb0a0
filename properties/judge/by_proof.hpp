// What an accepted proof settles about an answer, in double. Every bound is rounded up by kSlack, and the
// scale down: what is then still within the limit is so without doubt; the rest is the oracle's.
#pragma once

#include "properties/judge/answer.hpp"

namespace graze::tool {

inline constexpr double kSlack = 1 + 1e-6;

// The proof says as much as the outcome claims.
[[nodiscard]] bool proves_verdict(const Proof& proof, Outcome outcome);

// Of tier standard: nothing about the answer is left open.
[[nodiscard]] bool settled_by(const Proof& proof, const corpus::Case& problem, const engine::Answer& answer,
                              const Limits& limits);

// Of tier certified: the verdict is shown, the bracket holds, and it is narrow.
[[nodiscard]] bool certified_by(const Proof& proof, const corpus::Case& problem, const engine::Answer& answer,
                                const Limits& limits);

// What rounding the times to float costs, a length; nothing in double, whose width counts it.
[[nodiscard]] double rounding_of_times(const corpus::Case& problem, double time, const Limits& limits);

}  // namespace graze::tool
