// The queries' answers compared with the exact oracle, each method by its guarantee.
#include "properties/judge/judge.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/queries/asked.hpp"
#include "properties/laws/tables.hpp"

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
  if (judgement->within_tolerance) result.labels.push_back("within the limit");
  return result;
}

LawResult query_verdict_is_right(const Case& problem, const Method& method) {
  return judged_by(&Judgement::wrong, problem, method);
}
LawResult query_bracket_is_right(const Case& problem, const Method& method) {
  return judged_by(&Judgement::off, problem, method);
}
LawResult query_contact_is_right(const Case& problem, const Method& method) {
  return judged_by(&Judgement::bad_contact, problem, method);
}

}  // namespace

std::vector<Law> query_oracle_laws() {
  return {
      {"query_verdict_is_right",
       "The verdict of a query is wrong only within kappa u scale in distance, depth or clearance.",
       Needs::oracle, &query_verdict_is_right},
      {"query_bracket_is_right",
       "Distance, depth, and both ends of a line are within kappa u scale, and held by their brackets.",
       Needs::oracle, &query_bracket_is_right},
      {"query_contact_is_right",
       "Normals of queries separate or support, and their points lie on the bodies, within kappa u scale.",
       Needs::oracle, &query_contact_is_right},
  };
}

}  // namespace graze::law
