// What a campaign asks and holds to its row of the guarantees: a method for linear casts, one for another
// query, or one for casts of turning bodies.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engines/guarantees.hpp"

namespace graze::tool {

// A campaign has up to three parts, each with its own cases and contenders.
enum class PartKind { casts, queries, rotating };
inline constexpr std::array<PartKind, 3> kPartKinds = {PartKind::casts, PartKind::queries,
                                                       PartKind::rotating};
[[nodiscard]] const char* name_of(PartKind kind);

struct Contender {
  // By kind of part.
  std::variant<const engine::EngineMethod*, const engine::QueryMethod*, const engine::RotatingEngineMethod*>
      method;
  const engine::Guarantee* row = nullptr;  // the method's, if it has one

  [[nodiscard]] PartKind kind() const { return static_cast<PartKind>(method.index()); }
  // "gjk/double", "distance gjk/double", "rotating plan/double".
  [[nodiscard]] std::string name() const;
};

// With the row of the project's own table.
[[nodiscard]] Contender contender_of(const engine::EngineMethod& method);
[[nodiscard]] Contender contender_of(const engine::QueryMethod& method);
[[nodiscard]] Contender contender_of(const engine::RotatingEngineMethod& method);

// Every method of a kind, in the order of the engine tables.
[[nodiscard]] std::vector<Contender> all_contenders(PartKind kind);
// Those that `names` select, in that order: "mpr" is mpr/double, "mpr/float" that one, "standard" every row
// of tier standard. No names: of casts exact/double, of queries every method with a row, of rotating casts
// tier certified and the plan. Throws std::runtime_error with one line for a name that selects nothing.
[[nodiscard]] std::vector<Contender> chosen_contenders(PartKind kind, const std::vector<std::string>& names);
// By name(): nothing if there is none.
[[nodiscard]] std::optional<Contender> find_contender(std::string_view name);

// Whether a case is asked of these: of tier exact, pairs of polytopes without a target distance; of queries,
// bodies that the exact oracles represent; of turning bodies, what the oracle has an answer to.
[[nodiscard]] bool is_question(const std::vector<Contender>& contenders, const corpus::Case& problem);

}  // namespace graze::tool
