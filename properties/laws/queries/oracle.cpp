// The queries' answers against the exact oracle, each method by its row.
#include "properties/judge/judge.hpp"
#include "properties/judge/linear.hpp"
#include "properties/laws/queries/asked.hpp"
#include "properties/laws/queries/checks.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

LawResult judged_by(std::string Judgement::*fault, const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  const std::optional<Judgement> judgement = oracle_judgement(method, question->seen, answer);
  if (!judgement) return not_applicable("not decided by the exact oracle");
  if (const std::string& reason = (*judgement).*fault; !reason.empty())
    return broken(reason + ": " + describe(answer));
  LawResult result = holds({label_of(answer.outcome)});
  if (judgement->stalled) result.labels.push_back("not_converged");
  if (judgement->excused) result.labels.push_back("within the limit");
  return result;
}

}  // namespace

LawResult query_verdict_is_right(const Case& problem, const Method& method) {
  return judged_by(&Judgement::wrong, problem, method);
}
LawResult query_bracket_is_right(const Case& problem, const Method& method) {
  return judged_by(&Judgement::off, problem, method);
}
LawResult query_contact_is_right(const Case& problem, const Method& method) {
  return judged_by(&Judgement::bad_contact, problem, method);
}

}  // namespace graze::law
