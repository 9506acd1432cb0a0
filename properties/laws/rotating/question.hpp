// Shared by the laws of rotating casts: the cases that they cover, the oracle's answer kept for the current case, and
// the treatment of two answers that should be the same contact.
#pragma once

#include <initializer_list>

#include "properties/judge/rotating_errors.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

// A case with a meaningful rotating answer: a cast over a finite step, in the domain, with the policy report and no
// more than 2^30 radians.
[[nodiscard]] bool is_rotating_question(const corpus::Case& seen);
// Over a finite step bodies rotate by no more than the validation allows, 2^30 radians.
[[nodiscard]] bool turns_within_range(const corpus::Case& seen);
[[nodiscard]] LawResult no_rotating_question();  // not applicable
// The numbers of an edited case survive the rounding to the method's scalar.
[[nodiscard]] bool fits(const corpus::Case& edited, const engine::Method& method);
// The method's answer is the plan's: "plan", "certified".
[[nodiscard]] bool follows_plan(const engine::Method& method);
// Misses no contact. Steps and spheres may miss contacts between two steps, and the published form may miss any. They
// are judged by the oracle's laws alone.
[[nodiscard]] bool is_safe(const engine::Method& method);

// The oracle's answer to a rotating question. nullptr if it refuses the case or decides nothing within kTruthBudget
// slices. The last few are kept.
inline constexpr int kTruthBudget = 1 << 12;
[[nodiscard]] const oracle::RotatingTruth* rotating_truth_of(const corpus::Case& seen);

// The method's answer to a rotating question if only the verdict is requested. The last one of every method is kept,
// because most laws begin with it.
[[nodiscard]] engine::Answer plain_answer(const engine::Method& method, const corpus::Case& seen);

[[nodiscard]] std::string pair_of(const engine::Answer& one, const engine::Answer& other);
[[nodiscard]] LawResult labelled(LawResult result, std::initializer_list<std::string_view> labels);

// The times that an answer leaves to the first contact: [inf, inf] for a miss.
struct Times {
  double lower = 0, upper = 0;
};
[[nodiscard]] Times times_of(const engine::Answer& answer);
[[nodiscard]] bool overlap(const Times& one, const Times& other);
[[nodiscard]] bool same_times(const engine::Answer& one, const engine::Answer& other);
// The part of outcome, times, counts and reasons that is not the same to the bit, or empty.
[[nodiscard]] std::string difference(const engine::Answer& one, const engine::Answer& other);

// Two questions about one contact, and a method's answer to either.
struct RotatingAsked {
  std::string_view name;
  const corpus::Case& problem;
  const engine::Answer& answer;
  double tolerance = 0, slack = 0;
};
// Two answers that cannot both be right. Proved brackets (tier certified, no slack) are broken at once. Otherwise the
// oracle judges either, and names the one at fault, if there is one. A method without a limit on late times is not
// judged by them.
[[nodiscard]] LawResult arbitrate(const engine::Method& method, const RotatingAsked& one,
                                  const RotatingAsked& other, std::string_view disagreement);
// Two questions with the same times: holds where both leave a common time, else as above.
[[nodiscard]] LawResult compare(const engine::Method& method, const RotatingAsked& one,
                                const RotatingAsked& other, std::string_view disagreement);

}  // namespace graze::law
