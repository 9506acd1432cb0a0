// An answer as text: a block to read, or one JSON object a line whose numbers read back to the same bits.
#pragma once

#include <string>

#include "corpus/case.hpp"
#include "engines/method.hpp"

namespace graze::tool {

[[nodiscard]] std::string answer_block(const corpus::Case& problem, const engine::Method& method,
                                       const engine::Answer& answer);

// {"id", "outcome", "because", "toi": {"lower", "upper"}, "normal", "point_a", "point_b", "method", "scalar",
// "tier", "iterations", "supports"}; null for what the answer does not hold: a miss has no toi, only a hit
// has a normal and witnesses, and "upper" is null where nothing bounds the time from above. "because" is why
// a case was refused, or that its start was passed over. The JSON says all that the block says.
//
// Of a rotating method also "plan" and "reasons" of the plan_json below, "hidden_motion" and
// "poses". Of a query, in place of "toi", "query", "stalled", "normal_out" and, where the query has them,
// "distance", "depth", "t_in" and "t_out", each {"lower", "upper"}; of times "inf" and "-inf" are strings.
//
// Of an engine of others: "id", "query", "method", "scalar", "tier", "failure" (what kept it from answering, or null),
// "outcome", "because" (what happened, or what the engine says), "toi", the intervals of a query, "normal", "point_a",
// "point_b" (null where its answers do not hold them) and "ns".
[[nodiscard]] std::string answer_json(const corpus::Case& problem, const engine::Method& method,
                                      const engine::Answer& answer);

// Why an input was refused, and where: "body b: shape.half_extents[1] is negative".
[[nodiscard]] std::string invalid_text(const engine::Answer& answer);

// What must be simulated, and why. {"id", "plan": "linear", "reasons": ["neither body turns"]}
[[nodiscard]] std::string plan_block(const corpus::Case& problem, const Plan& plan);
[[nodiscard]] std::string plan_json(const corpus::Case& problem, const Plan& plan);

}  // namespace graze::tool
