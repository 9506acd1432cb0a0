// The cases that a law must have seen before "it holds" means anything: every outcome, and every family of its kind.
//
// A law that no case of a family ever applied to gives no information about the difficulty of that family. The table in
// reach.cpp lists the cases where it cannot apply, with the reason. A test checks the table, too: an entry that is
// reached all the same has to be removed.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "corpus/families.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

// Names are separated by spaces.
struct OutOfReach {
  std::string_view law;
  std::string_view outcomes;  // that the law cannot see
  std::string_view families;  // that it does not apply to
  std::string_view why;       // one line, ready for the page of the laws
};
[[nodiscard]] std::span<const OutOfReach> out_of_reach();

// A known failure: a broken law, the methods that break it, and the known reason. The tests continue without it and
// fail once it is mended. `graze laws` reports it and fails.
struct KnownBreach {
  std::string_view law;
  std::string_view methods;  // separated by spaces
  std::string_view why;      // one line, ready for the page of the laws
};
[[nodiscard]] std::span<const KnownBreach> known_breaches();
[[nodiscard]] bool is_known_breach(std::string_view law, std::string_view method);

// hit or initially_overlapping: a query beside the cast may have one of the two, or both, depending on its case.
inline constexpr std::string_view kContact = "contact";
// The labels of outcomes that a law of this name must have seen. kContact stands for either.
[[nodiscard]] std::vector<std::string_view> outcomes_to_see(Kind kind, std::string_view law);
// The families over which a law of this kind is run.
[[nodiscard]] std::span<const corpus::Family> families_of(Kind kind);
[[nodiscard]] bool must_reach(std::string_view law, std::string_view family);

}  // namespace graze::law
