// What a guarantee says of work, as a law: support evaluations of one answer, asked for as by default.
#pragma once

#include "properties/judge/linear.hpp"

namespace graze::law {

// `seen`: a question that the method answers.
[[nodiscard]] inline LawResult within_its_work(const corpus::Case& seen, const engine::Method& method) {
  const engine::Answer answer = method.answer(seen);
  Judgement judgement;
  judge_work(judgement, method, answer.counters);
  if (!judgement.work.empty()) return broken(judgement.work + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

}  // namespace graze::law
