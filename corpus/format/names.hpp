// The words of the case format for the enumerations, both ways.
#pragma once

#include <array>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::corpus {

// The text of the first kCount enumerators: where core has the word, the format has the same.
template <class Enum, std::size_t kCount>
[[nodiscard]] consteval std::array<std::string_view, kCount> core_names() {
  std::array<std::string_view, kCount> names;
  for (std::size_t k = 0; k < kCount; ++k) names[k] = to_text(static_cast<Enum>(k));
  return names;
}

// The names of the schema in a case.
inline constexpr std::string_view kCaseSchema = "graze.case/1", kSecondCaseSchema = "graze.case/2";

inline constexpr std::array<std::string_view, 2> kCaseSchemas = {kCaseSchema, kSecondCaseSchema};

// Indexed by the enumerators' values.
inline constexpr auto kOutcomeNames = core_names<Outcome, 5>();
inline constexpr auto kStartPolicyNames = core_names<StartPolicy, 2>();
inline constexpr auto kTierNames = core_names<Tier, 3>();
inline constexpr std::array<std::string_view, 7> kQueryNames = {
    "cast", "line", "overlap", "distance", "penetration", "penetration_along", "swept_overlap"};

[[nodiscard]] constexpr std::string_view name_of(Outcome outcome) { return to_text(outcome); }
[[nodiscard]] constexpr std::string_view name_of(StartPolicy policy) { return to_text(policy); }
[[nodiscard]] constexpr std::string_view name_of(Query query) {
  return kQueryNames[static_cast<std::size_t>(query)];
}

}  // namespace graze::corpus
