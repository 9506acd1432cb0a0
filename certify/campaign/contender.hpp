// The contenders of a campaign: methods of one kind, which are asked about cases and judged by their guarantees.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engines/guarantees.hpp"

namespace graze::tool {

// A campaign has up to three parts, each with its own cases and contenders. They are called "casts", "queries" and
// "rotating" by the kind of method.
inline constexpr engine::Kind kPartKinds[] = {engine::Kind::linear, engine::Kind::query,
                                              engine::Kind::rotating};
[[nodiscard]] const char* part_name(engine::Kind kind);

using Contenders = std::vector<const engine::Method*>;

// The methods that `names` select, in the order of the list: "mpr" is mpr/double, "mpr/float" is that one, and
// "standard" is every method with a guarantee of tier standard. Without names, casts use exact/double, queries use
// every method with a guarantee, and rotating casts use tier certified and the plan. Throws std::runtime_error with a
// one-line message for a name that selects nothing. `others` are the methods of third-party engines of this kind. They
// come after ours, and ours are then only the named ones.
[[nodiscard]] Contenders chosen_contenders(engine::Kind kind, const std::vector<std::string>& names,
                                           const Contenders& others = {});
// The method of ours with this question_name(), or nullptr.
[[nodiscard]] const engine::Method* find_contender(std::string_view name);

// True if these contenders are asked the case. Tier exact takes pairs of polytopes and rounded polytopes. Queries take
// bodies that the exact oracles represent. Rotating casts take the cases that the oracle can answer. Third-party
// engines take the cases that they support.
[[nodiscard]] bool is_question(const Contenders& contenders, const corpus::Case& problem);

}  // namespace graze::tool
