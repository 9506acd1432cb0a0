// The laws of rotating casts that need the oracle: an answer's errors, each within the method's guarantee
// (judge/judge_rotating.cpp).
#include <fmt/format.h>

#include <algorithm>

#include "engines/method.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::RotatingTruth;

using Error = RotatingError(const RotatingTruth&, const Answer&, const Limits&);

namespace {

LawResult by_truth(const Case& problem, const Method& method, Error* error) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const Answer answer = plain_answer(method, seen);
  const RotatingError found = error(*truth, answer, limits_of(method, seen, scale_of(seen)));
  if (!found.fault.empty()) return broken(found.fault + ": " + describe(answer));
  LawResult result = holds({label_of(answer.outcome)});
  if (truth->outcome() == Outcome::not_converged) result.labels.push_back("undecided");
  return result;
}

LawResult turning_verdict_is_right(const Case& problem, const Method& method) {
  return by_truth(problem, method, &verdict_error);
}
LawResult turning_is_never_late(const Case& problem, const Method& method) {
  return by_truth(problem, method, &late_error);
}
LawResult turning_claims_no_contact_early(const Case& problem, const Method& method) {
  return by_truth(problem, method, &early_error);
}
LawResult turning_bracket_is_narrow(const Case& problem, const Method& method) {
  return by_truth(problem, method, &width_error);
}
LawResult turning_distance_is_stated(const Case& problem, const Method& method) {
  return by_truth(problem, method, &distance_error);
}

// Only tier certified guarantees it. In tier standard, answers that did not converge have a cap
// (docs/reference/guarantees.md).
LawResult turning_certified_decides(const Case& problem, const Method& method) {
  if (!method.is_certified()) return not_applicable("not of tier certified");
  return by_truth(problem, method, &undecided_error);
}

LawResult turning_contact_is_right(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer answer = method.ask(seen, {.request = Request::normal | Request::witnesses});
  if (answer.outcome != Outcome::hit) return holds({label_of(answer.outcome)});
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const Limits row = limits_of(method, seen, scale_of(seen));
  for (const auto error : {&normal_error, &witness_error}) {
    const RotatingError found = error(*truth, answer, row);
    if (!found.fault.empty()) return broken(found.fault + ": " + describe(answer));
  }
  // The witnesses are at most the stated distance apart. A normal that misses support by g is known to the
  // root of 2 g over a ball's radius. So the ball's point is known to sqrt(2 g R) <= 2e-5 of the scale for g
  // <= 2e-10 of it, which is above the rest of the bracket for any guarantee with a kappa. The published
  // slides end at a linear slop, which is the distance that they state.
  const double between_points = (answer.point_b - answer.point_a).norm() - seen.target_distance;
  const double of_balls = std::max(2e-5 * row.scale, std::sqrt(2 * answer.distance * row.scale));
  const double near_enough = answer.distance + of_balls + 2 * row.contact +
                             row.rounding_at(answer.toi_lower) +
                             4 * row.unit_roundoff * (answer.point_a.norm() + answer.point_b.norm());
  if (between_points > near_enough)
    return broken(fmt::format("the witnesses are {} apart: {}", between_points, describe(answer)));
  if (truth->outcome() != Outcome::hit) return holds({label_of(answer.outcome), "no true normal"});
  return holds({label_of(answer.outcome)});
}

LawResult turning_open_answer_is_near(const Case& problem, const Method& method) {
  if (!method.is_certified()) return not_applicable("not of tier certified");
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer answer = method.ask(seen, {.request = Request::normal | Request::witnesses});
  if (answer.outcome != Outcome::not_converged) return holds({label_of(answer.outcome)});
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const RotatingError found = open_error(*truth, seen, answer, limits_of(method, seen, scale_of(seen)));
  if (!found.fault.empty()) return broken(found.fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

}  // namespace

std::vector<Law> rotating_oracle_laws() {
  return {
      {"turning_verdict_is_right", "Contact or no contact is wrong only within the guarantee.", Needs::oracle,
       &turning_verdict_is_right},
      {"turning_is_never_late", "toi_lower is not past the first contact by more than the guaranteed depth.",
       Needs::oracle, &turning_is_never_late},
      {"turning_claims_no_contact_early", "At toi_upper the bodies have met.", Needs::oracle,
       &turning_claims_no_contact_early},
      {"turning_bracket_is_narrow",
       "Either end of a contact's bracket is as near to it as the guarantee says.", Needs::oracle,
       &turning_bracket_is_narrow},
      {"turning_distance_is_stated", "At toi_lower the bodies are no farther apart than the answer says.",
       Needs::oracle, &turning_distance_is_stated},
      {"turning_certified_decides",
       "Tier certified leaves a verdict open only where clearance or depth is below the guaranteed width.",
       Needs::oracle, &turning_certified_decides},
      {"turning_contact_is_right", "A hit's normal separates the bodies, and its witnesses lie in them.",
       Needs::oracle, &turning_contact_is_right},
      {"turning_open_answer_is_near",
       "If tier certified leaves a verdict open, the bodies are within the width of contact at toi_lower. "
       "The answer has a distance of no more, a unit normal and points on the bodies.",
       Needs::oracle, &turning_open_answer_is_near},
  };
}

}  // namespace graze::law
