#include "properties/laws/reach.hpp"

#include <algorithm>
#include <array>

namespace graze::law {

namespace {

constexpr const char* kRoundRods =
    "one body is an ellipsoid, a cone or a cylinder, whose queries these laws' oracle does not decide";

constexpr const char* kCurvedRods =
    "one body is an ellipsoid, a cone or a cylinder, which tier exact, or this query of it, does not take";

constexpr OutOfReach kOutOfReach[] = {
    {"ray_is_point_cast", "",
     "hulls_rotated target_margin noisy_copy smooth_graze combinators mixed_magnitudes coaxial "
     "rods_and_round smooth_depths round_ties apexes ray_ties",
     "the differences of rotated, noisy, rounded and many vertices, and of nested parts, are not doubles"},
    {"turning", "", "slivers far_own_frame",
     "changes of the last bits, or lengths far out, leave no room for the products of a rational rotation"},
    {"reordering", "", "aligned_boxes ray_ties",
     "these shapes have neither vertices nor parts to put in another order"},
    {"redundant_points", "", "ray_ties", "no shape of it can take another point"},
    {"tiers_nest", "", "rods_and_round", kCurvedRods},
    {"exact_equals_oracle", "", "rods_and_round", kCurvedRods},
    {"exact_queries_agree", "", "rods_and_round ray_ties", kCurvedRods},
    {"query_verdict_is_right", "", "rods_and_round ray_ties", kRoundRods},
    {"query_bracket_is_right", "", "rods_and_round ray_ties", kRoundRods},
    {"query_contact_is_right", "", "rods_and_round ray_ties", kRoundRods},
    {"interrupted_query_is_right", "", "rods_and_round ray_ties", kRoundRods},
    {"query_tolerance_is_kept", "", "rods_and_round ray_ties", kRoundRods},
    {"as_one_stands_still", "hit", "", "bodies that move as one stand still relative to each other: no hit"},
    {"apart_start_has_no_policy", "initially_overlapping", "", "it is about starts that are apart"},
    {"turning_splitting", "initially_overlapping", "", "a step is split before the first contact"},
    {"idle_pivot_is_nothing", "", "both_turn", "in that family every body rotates"},
};

// Empty. An entry would name the law, the methods by full name, and the known reason.
constexpr std::array<KnownBreach, 0> kKnownBreaches = {};

bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

}  // namespace

std::span<const OutOfReach> out_of_reach() { return kOutOfReach; }

std::span<const KnownBreach> known_breaches() { return kKnownBreaches; }

bool is_known_breach(std::string_view law, std::string_view method) {
  return std::any_of(kKnownBreaches.begin(), kKnownBreaches.end(),
                     [&](const KnownBreach& one) { return one.law == law && has_word(one.methods, method); });
}

std::vector<std::string_view> outcomes_to_see(Kind kind, std::string_view law) {
  std::vector<std::string_view> outcomes = {"hit", "miss", "initially_overlapping"};
  if (kind == Kind::query) outcomes = {"miss", kContact};
  std::erase_if(outcomes, [&](std::string_view outcome) {
    return std::any_of(std::begin(kOutOfReach), std::end(kOutOfReach), [&](const OutOfReach& one) {
      return one.law == law && has_word(one.outcomes, outcome);
    });
  });
  return outcomes;
}

std::span<const corpus::Family> families_of(Kind kind) {
  return kind == Kind::rotating ? corpus::rotating_families() : corpus::families();
}

bool must_reach(std::string_view law, std::string_view family) {
  return std::none_of(std::begin(kOutOfReach), std::end(kOutOfReach), [&](const OutOfReach& one) {
    return one.law == law && has_word(one.families, family);
  });
}

}  // namespace graze::law
