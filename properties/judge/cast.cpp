#include "properties/judge/cast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/format/case_io.hpp"
#include "corpus/format/proof_io.hpp"
#include "corpus/support_value.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/exact_answer.hpp"
#include "properties/judge/linear.hpp"
#include "properties/laws/linear/proof.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::EngineMethod;

namespace {

// A lower bound of the scale, without an oracle: the largest extent of a body along an axis of its own,
// halved so that no rounding of a turn matters. Only decides what the oracle need not see, so an
// underestimate costs time and nothing else.
double least_scale(const Case& problem) {
  double scale = 0;
  for (const Body<double>* body : {&problem.a, &problem.b}) {
    const corpus::Bounds box = corpus::bounds(body->shape);
    scale = std::max(scale, (box.high - box.low).maxCoeff() / 2);
  }
  return scale;
}

// Over scale: a bracket of tier certified that is so near the proved one needs no oracle. A quarter of what
// its row allows.
constexpr double kSettledWidth = 0.25e-12;

struct Proved {
  double lower = 0, upper = kInfinity<double>;
};

// Whether the proved bounds say by themselves that the answer is within its row.
bool settled(const Answer& answer, const Proved& proved, double speed, double bound) {
  if (answer.outcome == Outcome::miss) return std::isinf(proved.lower);
  if (answer.outcome == Outcome::initially_overlapping) return proved.upper == 0;
  if (answer.outcome != Outcome::hit) return false;
  const double width = std::max(answer.toi_upper, proved.upper) - std::min(answer.toi_lower, proved.lower);
  return proved.upper < kInfinity<double> && width * speed <= bound;
}

// Of tier certified, which is held to its width, a share of it.
double settled_bound(const Case& problem, const EngineMethod& method) {
  const double kappa_u =
      method.is_certified() ? kSettledWidth : kappa(method, problem) * method.unit_roundoff;
  return kappa_u * least_scale(problem);
}

std::string fault_by_oracle(const Case& problem, const EngineMethod& method, const Answer& answer) {
  return any_fault(method, problem, answer);
}

}  // namespace

bool is_settled_by_proof(const Case& problem, const EngineMethod& method, const Answer& answer) {
  if (!answer.proof) return false;
  const Proved proved{.lower = answer.proof->toi_lower, .upper = answer.proof->toi_upper};
  return settled(answer, proved, velocity(problem).stableNorm(), settled_bound(problem, method));
}

CastJudgement judge_cast(const Case& problem, bool ask_oracle) {
  CastJudgement judgement;
  std::vector<const EngineMethod*> asked;
  for (const EngineMethod& method : engine::methods()) {
    if (method.scalar != "double") continue;
    asked.push_back(&method);
    judgement.said.push_back({method.full_name(), method.cast(problem, {.request = Request::everything})});
  }
  const auto blame = [&](std::size_t i, const std::string& fault) {
    if (!fault.empty() && judgement.fault.empty()) judgement.fault = judgement.said[i].method + ": " + fault;
  };
  if (must_be_refused(problem)) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (judgement.said[i].answer.outcome != Outcome::invalid_input) blame(i, "bad input is let in");
    }
    return judgement;
  }
  if (!is_linear_question(problem)) return judgement;  // outside of the range: an answer promises nothing

  Proved proved;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Answer& answer = judgement.said[i].answer;
    if (!is_question_for(*asked[i], problem)) {
      if (answer.invalid != Invalid::not_exact) blame(i, "tier exact answers what it does not know");
      continue;
    }
    blame(i, consistency_fault(problem, *asked[i], answer, Request::everything));
    blame(i, proof_fault(problem, answer));
    if (!judgement.fault.empty()) return judgement;
    if (answer.proof) {
      proved.lower = std::max(proved.lower, answer.proof->toi_lower);
      proved.upper = std::min(proved.upper, answer.proof->toi_upper);
    }
  }
  const double speed = velocity(problem).stableNorm();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const EngineMethod& method = *asked[i];
    const Answer& answer = judgement.said[i].answer;
    if (!is_question_for(method, problem)) continue;
    if (method.is_exact()) {
      const ExactFinding finding = judge_exact_by_proof(problem, answer, false);
      blame(i, finding.fault);
      if ((finding.settled && !ask_oracle) || !is_exactly_decided(problem)) continue;
      judgement.by_oracle = true;
      blame(i, exact_fault_by_truth(truth_of(problem), answer, false));
      continue;
    }
    if (!ask_oracle && settled(answer, proved, speed, settled_bound(problem, method))) continue;
    if (!has_truth(problem)) continue;
    judgement.by_oracle = true;
    blame(i, fault_by_oracle(problem, method, answer));
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
                                              : hex(proof.axis);
    text += fmt::format("  proof: toi in [{}, {}], axis {}, portal of {}\n", hex(proof.toi_lower),
                        hex(proof.toi_upper), axis, proof.portal_size);
  }
  if (is_linear_question(problem) && has_truth(problem)) {
    const oracle::CaseTruth& truth = truth_of(problem);
    text += fmt::format("oracle: {}, toi in [{}, {}], clearance {}, depth {}, scale {}\n",
                        label_of(truth.outcome()), hex(truth.toi_lower()), hex(truth.toi_upper()),
                        truth.clearance().high, truth.depth().high, truth.scale().high);
  }
  return text;
}

}  // namespace graze::law
