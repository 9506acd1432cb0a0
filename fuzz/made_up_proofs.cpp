// Does the checker accept a proof that claims too much?
//
//   1. Decode. A case with a spin becomes a rotating cast, any other a linear one.
//   2. Take the proof of a method that the choice names, or none, and spoil it (spoil_proof.hpp).
//   3. A proof that the checker accepts must be true. A method that found another proof is consulted first: a claim
//      that its bracket confirms needs no other judge. The oracle decides the rest.
//   4. An accepted proof stays accepted when it claims less.
#include <fmt/format.h>

#include <cmath>

#include "corpus/format/proof_io.hpp"
#include "fuzz/repair.hpp"
#include "fuzz/spoil_proof.hpp"
#include "fuzz/target.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"

namespace graze::fuzz {

namespace {

using corpus::Case;

// The claim is no stronger than a bracket of tier certified: another proof of the same.
template <class Answer>
bool within(const Answer& certified, double lower, double upper) {
  if (certified.outcome == Outcome::invalid_input) return false;
  return lower <= certified.toi_lower && upper >= certified.toi_upper;
}

// Why the claims are false, or empty. `compare` is the sign of (t - TOI), where it is known, else 0.
template <class Truth>
std::string false_claim(const Truth& truth, double lower, double upper) {
  const bool misses = truth.outcome() == Outcome::miss;
  const bool contact = truth.outcome() == Outcome::hit || truth.outcome() == Outcome::initially_overlapping;
  const bool late = std::isinf(lower) ? contact : lower > 0 && truth.compare(lower) > 0;
  const bool early = upper < kInfinity<double> && (misses || truth.compare(upper) < 0);
  if (!late && !early) return {};
  return fmt::format("accepted: toi in [{}, {}]; true: {}, toi in [{}, {}]", law::decimal(lower),
                     law::decimal(upper), law::label_of(truth.outcome()), law::decimal(truth.toi_lower()),
                     law::decimal(truth.toi_upper()));
}

Finding finding(const char* name, std::string fault, const Case& problem, corpus::ProofRecord record) {
  record.problem = problem;
  record.method = "made_up";
  record.scalar = "double";
  record.outcome = Outcome::not_converged;
  return {name, "checker", std::move(fault), problem, "proof: " + corpus::write_proof(record) + "\n"};
}

Judged judge_linear(const Case& problem, corpus::Random& random) {
  Judged judged;
  judged.reached = law::is_linear_question(problem);
  if (!judged.reached) return judged;
  Proof proof;
  if (!random.once_in(8)) {
    const auto methods = engine::methods(engine::Kind::linear);
    const engine::Method& method = methods[random.below(methods.size())];
    // A proof in float is about the case in float. Here it is one more way to be wrong.
    proof = method.ask(problem, {.request = Request::proof}).proof.value_or(Proof());
  }
  spoil(proof, problem, random);
  if (!oracle::check_proof(problem, proof).accepted()) return judged;

  const double lower = proof.toi_lower, upper = proof.toi_upper;
  const auto add_finding = [&](const char* name, std::string fault, const Proof& of) {
    corpus::ProofRecord record;
    record.proof = of;
    judged.finding = finding(name, std::move(fault), problem, std::move(record));
  };
  const engine::Answer certified = engine::find_method(engine::Kind::linear, "certified")->ask(problem, {});
  if (!within(certified, lower, upper) && law::has_truth(problem)) {
    judged.by_oracle = true;
    std::string fault = false_claim(law::truth_of(problem), lower, upper);
    if (!fault.empty()) add_finding("false_proof_is_refused", std::move(fault), proof);
  }
  const Proof less = claiming_less(proof, problem, random);
  if (!judged.finding) {
    const oracle::Verdict verdict = oracle::check_proof(problem, less);
    if (!verdict.accepted()) {
      add_finding("claiming_less_is_accepted",
                  fmt::format("{}: {}", oracle::to_string(verdict.refusal), verdict.detail), less);
    }
  }
  return judged;
}

Judged judge_turning(const Case& problem, corpus::Random& random) {
  Judged judged;
  judged.reached = law::is_rotating_question(problem);
  if (!judged.reached) return judged;
  const engine::Answer certified =
      engine::find_method(engine::Kind::rotating, "certified")->ask(problem, {.request = Request::proof});
  RotatingProof proof =
      random.once_in(8) ? RotatingProof() : certified.rotating_proof.value_or(RotatingProof());
  spoil(proof, problem, random);
  if (!oracle::check_rotating_proof(problem, proof).accepted()) return judged;
  if (within(certified, proof.toi_lower, proof.toi_upper)) return judged;
  const oracle::RotatingTruth* truth = law::rotating_truth_of(problem);
  if (truth == nullptr) return judged;
  judged.by_oracle = true;
  std::string fault = false_claim(*truth, proof.toi_lower, proof.toi_upper);
  if (fault.empty()) return judged;
  corpus::ProofRecord record;
  record.rotating = proof;
  judged.finding = finding("false_turning_proof_is_refused", std::move(fault), problem, std::move(record));
  return judged;
}

Judged judge_made_up(const Input& input) {
  corpus::Random random(input.choice);
  if (law::has_spin(input.problem)) return judge_turning(as_turning(input.problem), random);
  return judge_linear(as_linear(input.problem), random);
}

}  // namespace

const Target kTarget = {.name = "made_up_proofs", .judge = &judge_made_up};

}  // namespace graze::fuzz
