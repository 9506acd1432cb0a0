// Does the checker accept a changed proof that is false?
//
//   1. Decode. A case with a spin becomes a rotating cast, any other a linear one.
//   2. Take the proof of a method that the choice names.
//   3. Change it, the case under it and the claim, a few times (properties/attack/mutant.hpp).
//   4. The oracles must not contradict an accepted proof, however it was made.
//
// made_up_proofs does the same with spoilt proofs of the unchanged case.
#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/attack/attack.hpp"
#include "properties/edit/case.hpp"

namespace graze::fuzz {

namespace {

// The program covers bulk. Here mostly the case changes.
constexpr attack::Settings kFew = {.edited_cases = 2, .mutants_each = 3};

Judged judge_mutants(const Input& input) {
  const bool turning = law::has_spin(input.problem);
  const corpus::Case problem = turning ? as_turning(input.problem) : as_linear(input.problem);
  corpus::Random random(input.choice);
  attack::Tally tally;
  const std::vector<attack::Finding> found = attack::attack(problem, random, kFew, tally);
  Judged judged;
  judged.reached = tally.bases > 0;
  judged.by_oracle = tally.all.agreed + tally.all.undecided > 0;
  if (found.empty()) return judged;
  const attack::Finding& first = found.front();
  judged.finding = {"accepted_mutant_is_true", "checker", first.fault, first.record.problem,
                    "proof: " + attack::text_of(first) + "\n"};
  return judged;
}

}  // namespace

const Target kTarget = {.name = "proof_attack", .judge = &judge_mutants};

}  // namespace graze::fuzz
