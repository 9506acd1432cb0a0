// The contenders of a campaign: methods of one kind, which are asked about cases and held to their rows of
// the guarantees.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engines/guarantees.hpp"

namespace graze::tool {

// A campaign has up to three parts, each with its own cases and contenders; "casts", "queries", "rotating" by
// the kind of method.
inline constexpr engine::Kind kPartKinds[] = {engine::Kind::linear, engine::Kind::query,
                                              engine::Kind::rotating};
[[nodiscard]] const char* part_name(engine::Kind kind);

using Contenders = std::vector<const engine::Method*>;

// Those that `names` select, in the order of the list: "mpr" is mpr/double, "mpr/float" that one, "standard"
// every row of tier standard. No names: of casts exact/double, of queries every method with a row, of
// rotating casts tier certified and the plan. Throws std::runtime_error with one line for a name that selects
// nothing. `others`: methods of engines of others, of the kind, which come after ours; of ours then those that are named.
[[nodiscard]] Contenders chosen_contenders(engine::Kind kind, const std::vector<std::string>& names,
                                           const Contenders& others = {});
// Of ours, by question_name(): nullptr if there is none.
[[nodiscard]] const engine::Method* find_contender(std::string_view name);

// Whether a case is asked of these: of tier exact, pairs of polytopes and rounded ones; of queries,
// bodies that the exact oracles represent; of turning bodies, what the oracle has an answer to; of engines of others,
// what they take.
[[nodiscard]] bool is_question(const Contenders& contenders, const corpus::Case& problem);

}  // namespace graze::tool
