// What the laws of rotating casts share: the row that a method is held to, the oracle's answer kept for the
// case at hand, and the faults that an answer may have by it. judge.hpp is the same for linear casts.
//
// Notation   limit = kappa u scale, a length: how deep a contact may be that goes unseen, or how far apart
// the
//            bodies where contact is claimed; 0 in tier certified.
//            wide = the larger of that and the width that the row, or the question, grants a bracket.
// A fault is a printable reason, or empty. Enclosures are compared by the end that favours the method.
#pragma once

#include <optional>

#include "engines/guarantees.hpp"
#include "engines/rotating.hpp"
#include "oracles/rotating_truth.hpp"
#include "properties/law.hpp"

namespace graze::law {

// The scale of DESIGN's meanings, in rounded doubles.
[[nodiscard]] double scale_of(const corpus::Case& problem);
// No point of one body moves faster relative to one of the other (length per unit of t).
[[nodiscard]] double top_speed_of(const corpus::Case& problem);

struct RotatingRow {
  double limit = 0, wide = 0;
  engine::Unseen may_miss = engine::Unseen::nothing, may_be_late = engine::Unseen::nothing;
  // Of a time of the answer, as a length: it is a number of the method's scalar, rounded outward.
  double rounding_at(double t) const { return 2 * unit_roundoff * t * speed; }
  double unit_roundoff = 0, speed = 0;
};
// `tolerance`: as asked, over scale. `slack`: a length that the question itself is off by.
[[nodiscard]] RotatingRow row_of(const engine::RotatingEngineMethod& method, const corpus::Case& seen,
                                 double tolerance = 0, double slack = 0);

// A case whose rotating answer means something: a cast over a finite step, of the domain, by the policy
// report, with no more than 2^30 radians.
[[nodiscard]] bool is_rotating_question(const corpus::Case& seen);
// The method's answer is the plan's: "plan", "certified".
[[nodiscard]] bool follows_plan(const engine::RotatingEngineMethod& method);

// The oracle's answer to a rotating question; nullptr where it refuses the case or decides nothing within
// kTruthBudget slices. The last few are kept.
inline constexpr int kTruthBudget = 1 << 12;
[[nodiscard]] const oracle::RotatingTruth* rotating_truth_of(const corpus::Case& seen);

[[nodiscard]] bool claims_contact(const engine::RotatingAnswer& answer);
[[nodiscard]] std::string describe(const engine::RotatingAnswer& answer);

// Contact or no contact, wrong by more than the row leaves open.
[[nodiscard]] std::string verdict_fault(const oracle::RotatingTruth& truth,
                                        const engine::RotatingAnswer& answer, const RotatingRow& row);
// toi_lower past the first contact.
[[nodiscard]] std::string late_fault(const oracle::RotatingTruth& truth, const engine::RotatingAnswer& answer,
                                     const RotatingRow& row);
// toi_upper where there has been no contact yet.
[[nodiscard]] std::string early_fault(const oracle::RotatingTruth& truth,
                                      const engine::RotatingAnswer& answer, const RotatingRow& row);
// Of a contact: the bodies too far apart at toi_lower, or too deep in each other before toi_upper.
[[nodiscard]] std::string width_fault(const oracle::RotatingTruth& truth,
                                      const engine::RotatingAnswer& answer, const RotatingRow& row);
[[nodiscard]] std::string any_fault(const oracle::RotatingTruth& truth, const engine::RotatingAnswer& answer,
                                    const RotatingRow& row);

// The times that an answer leaves to the first contact: [inf, inf] of a miss.
struct Times {
  double lower = 0, upper = 0;
};
[[nodiscard]] Times times_of(const engine::RotatingAnswer& answer);
[[nodiscard]] bool overlap(const Times& one, const Times& other);
[[nodiscard]] bool same_times(const engine::RotatingAnswer& one, const engine::RotatingAnswer& other);

// Two questions about one contact, with the same times, and what a method said to either.
struct RotatingAsked {
  std::string_view name;
  const corpus::Case& problem;
  const engine::RotatingAnswer& answer;
  double tolerance = 0, slack = 0;
};
// Holds where both leave a common time; of proved brackets (tier certified) it is broken where they leave
// none; else the oracle looks at either, and names the one at fault, if there is one. A method that may be
// late by anything is not held to it.
[[nodiscard]] LawResult compare(const engine::RotatingEngineMethod& method, const RotatingAsked& one,
                                const RotatingAsked& other, std::string_view disagreement);

}  // namespace graze::law
