// The distance of the bodies at toi_lower, as a linear cast states it.
#include <fmt/format.h>

#include <cmath>

#include "properties/judge/linear_faults.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::CaseTruth;

namespace {

// Budgets of support evaluations: few enough to cut most searches short, and enough for a whole search.
constexpr int kDistanceBudgets[] = {3, 9, 256};

// C is rounded by the target distance, so the distance of toi_lower v from C is the excess of the bodies' distance over
// it.
std::string distance_fault(const CaseTruth& truth, const Answer& answer, double bound, double unit_roundoff) {
  if (!(answer.distance >= 0)) return fmt::format("the distance at toi_lower is {}", answer.distance);
  if (std::isinf(answer.distance)) {
    return answer.outcome == Outcome::hit ? "the distance at a hit's toi_lower is not known" : "";
  }
  const double away = truth.distance_at(answer.toi_lower).low;
  // Computed from a few rounded numbers.
  const double stated = answer.distance * (1 + 8 * unit_roundoff);
  if (away <= stated + bound) return "";
  return fmt::format("at toi_lower the bodies are {} apart, {} is stated and {} allowed", away,
                     answer.distance, bound);
}

LawResult distance_is_stated(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  if (const auto open = without_truth(seen)) return *open;
  const CaseTruth& truth = truth_of(seen);
  const double bound = proved_bound_of(method, seen);
  LawResult result = holds({label_of(truth.outcome())});
  for (const int budget : kDistanceBudgets) {
    const Answer answer = method.ask(seen, {.max_iterations = budget});
    if (answer.outcome != Outcome::hit && answer.outcome != Outcome::not_converged) break;
    if (is_beyond_range(answer.toi_lower, answer.toi_upper, method.unit_roundoff)) break;
    const std::string fault = distance_fault(truth, answer, bound, method.unit_roundoff);
    if (!fault.empty())
      return broken(fmt::format("{}; with a budget of {}: {}", fault, budget, describe(answer)));
    if (answer.outcome == Outcome::hit) break;
    result.labels.push_back(std::isinf(answer.distance) ? "interrupted, no distance" : "interrupted");
  }
  return result;
}

}  // namespace

std::vector<Law> linear_distance_laws() {
  return {
      {"distance_is_stated",
       "At toi_lower the bodies' distance exceeds the target distance by no more than the answer says.",
       Needs::oracle, &distance_is_stated},
  };
}

}  // namespace graze::law
