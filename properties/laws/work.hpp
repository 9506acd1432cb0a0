// Laws of work: the support evaluations of one answer, by default and with a tolerance.
#pragma once

#include <fmt/format.h>

#include "properties/judge/linear_faults.hpp"

namespace graze::law {

// `seen`: a question that the method answers.
[[nodiscard]] inline LawResult within_its_work(const corpus::Case& seen, const engine::Method& method) {
  const engine::Answer answer = method.answer(seen);
  Judgement judgement;
  judge_work(judgement, method, seen, answer.counters);
  if (!judgement.work.empty()) return broken(judgement.work + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

// A tolerance ends a search earlier. It changes no verdict, and costs no support. Returns the violation, or empty.
[[nodiscard]] inline std::string moved_by_tolerance(const engine::Answer& full, const engine::Answer& loose,
                                                    double tolerance) {
  std::string what;
  if (loose.outcome != full.outcome && full.outcome != Outcome::not_converged) what = "moves the verdict";
  if (loose.counters.supports > full.counters.supports) what = "costs supports";
  if (what.empty()) return what;
  return fmt::format("the tolerance {} {}: {}; without: {}", decimal(tolerance), what, describe(loose),
                     describe(full));
}

}  // namespace graze::law
