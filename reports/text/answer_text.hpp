// An answer as text: a block to read, or one JSON object a line whose numbers read back to the same bits.
#pragma once

#include <string>

#include "corpus/case.hpp"
#include "engines/method.hpp"

namespace graze::tool {

[[nodiscard]] std::string answer_block(const corpus::Case& problem, const engine::Method& method,
                                       const engine::Answer& answer);

// {"id", "outcome", "because", "toi": {"lower", "upper"}, "normal", "point_a", "point_b", "method", "scalar", "tier",
// "iterations", "supports"}. Fields that the answer does not hold are null. A miss has no toi, only a hit has a normal
// and witnesses, and "upper" is null if no upper bound on the time is known. "because" is the reason for a refused
// case, or tells that its start was passed over. The JSON holds everything that the block holds.
//
// Rotating methods add "plan" and "reasons" of the plan_json below, "hidden_motion" and "poses". Queries have "query",
// "stalled" and "normal_out" instead of "toi". If the query has them, they also have "distance", "depth", "t_in" and
// "t_out", each {"lower", "upper"}. Infinite times are the strings "inf" and "-inf".
//
// Third-party engines have these fields: "id", "query", "method", "scalar", "tier", "failure" (the kind of failure, or
// null), "outcome", "because" (the event, or the engine's message), and "toi". They also have the intervals of a query,
// "normal", "point_a", "point_b" (null if its answers do not hold them) and "ns".
[[nodiscard]] std::string answer_json(const corpus::Case& problem, const engine::Method& method,
                                      const engine::Answer& answer);

// Why an input was refused, and where: "body b: shape.half_extents[1] is negative".
[[nodiscard]] std::string invalid_text(const engine::Answer& answer);

// The simulated motion and the reasons. {"id", "plan": "linear", "reasons": ["neither body rotates"]}
[[nodiscard]] std::string plan_block(const corpus::Case& problem, const Plan& plan);
[[nodiscard]] std::string plan_json(const corpus::Case& problem, const Plan& plan);

}  // namespace graze::tool
