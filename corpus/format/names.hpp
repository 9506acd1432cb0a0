// The words of the case format for the enumerations, both ways.
#pragma once

#include <array>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::corpus {

// Indexed by the enumerators' values.
inline constexpr std::array<std::string_view, 5> kOutcomeNames = {"initially_overlapping", "hit", "miss",
                                                                  "not_converged", "invalid_input"};
inline constexpr std::array<std::string_view, 2> kStartPolicyNames = {"report", "pass_over"};
inline constexpr std::array<std::string_view, 7> kQueryNames = {
    "cast", "line", "overlap", "distance", "penetration", "penetration_along", "swept_overlap"};

[[nodiscard]] constexpr std::string_view name_of(Outcome outcome) {
  return kOutcomeNames[static_cast<std::size_t>(outcome)];
}
[[nodiscard]] constexpr std::string_view name_of(StartPolicy policy) {
  return kStartPolicyNames[static_cast<std::size_t>(policy)];
}
[[nodiscard]] constexpr std::string_view name_of(Query query) {
  return kQueryNames[static_cast<std::size_t>(query)];
}

}  // namespace graze::corpus
