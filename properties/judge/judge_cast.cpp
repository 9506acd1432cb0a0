#include "properties/judge/judge_cast.hpp"

#include <fmt/format.h>

#include "corpus/format/case_io.hpp"
#include "corpus/format/proof_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/linear/proof.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

// The fault of an answer, or empty. Tier certified may leave open a verdict decided by less than its width. No other
// method may fail to converge here.
std::string fault_of(Truth& truth, const Method& method, const Answer& answer, CastJudgement& all,
                     bool ask_oracle) {
  const Judgement judgement = judge(truth, method, answer, Request::everything, ask_oracle);
  all.by_oracle = all.by_oracle || judgement.by_oracle;
  if (judgement.skipped || judgement.faulty()) return judgement.fault();
  if (method.is_certified() && judgement.stalled) return judgement.undecided;
  return answer.outcome == Outcome::invalid_input
             ? ""
             : consistency_fault(truth.problem(), method, answer, Request::everything);
}

}  // namespace

CastJudgement judge_cast(const Case& problem, bool ask_oracle) {
  CastJudgement judgement;
  Truth truth(problem);
  for (const Method& method : engine::methods(engine::Kind::linear)) {
    if (method.in_float()) continue;
    if (!engine::unsupported(engine::Kind::linear, problem).empty()) continue;
    const Answer answer = method.ask(problem, {.request = Request::everything});
    judgement.said.push_back({method.full_name(), answer});
    if (!judgement.fault.empty()) continue;
    const std::string fault = fault_of(truth, method, answer, judgement, ask_oracle);
    if (!fault.empty()) judgement.fault = method.full_name() + ": " + fault;
  }
  return judgement;
}

std::string report(const Case& problem, const CastJudgement& judgement) {
  std::string text = "fault: " + judgement.fault + "\ncase: " + corpus::write_case(problem) + "\nnumbers:";
  for (const double x : scalars(problem)) text += fmt::format(" {:a}", x);
  text += "\n";
  for (const CastJudgement::Said& one : judgement.said) {
    text += fmt::format("{}: {}\n", one.method, describe(one.answer));
    if (!one.answer.proof) continue;
    const Proof& proof = *one.answer.proof;
    const std::string axis = !proof.has_axis  ? "none"
                             : proof.symbolic ? corpus::write_axis(proof)
                                              : decimal(proof.axis);
    text += fmt::format("  proof: toi in [{}, {}], axis {}, portal of {}\n", decimal(proof.toi_lower),
                        decimal(proof.toi_upper), axis, proof.portal_size);
  }
  if (is_linear_question(problem) && has_truth(problem)) {
    const oracle::CaseTruth& truth = truth_of(problem);
    text += fmt::format("oracle: {}, toi in [{}, {}], clearance {}, depth {}, scale {}\n",
                        label_of(truth.outcome()), decimal(truth.toi_lower()), decimal(truth.toi_upper()),
                        truth.clearance().high, truth.depth().high, truth.scale().high);
  }
  return text;
}

}  // namespace graze::law
