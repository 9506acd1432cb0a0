// Does any rotating cast answer wrongly?
//
//   1. Decode. The step is finite, and the rotations are moderate.
//   2. Choose a method by the choice.
//   3. Judge its answer by itself and by its proof.
//   4. One case in kOneIn goes to the bracket oracle, which judges all of the answer.
#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/laws/law.hpp"

namespace graze::fuzz {

namespace {

// The oracle takes some ten times as long as what comes before it.
constexpr std::uint64_t kOneIn = 64;

Judged judge_turning(const Input& input) {
  const corpus::Case problem = as_turning(input.problem);
  const auto methods = engine::methods(engine::Kind::rotating);
  const engine::Method& method = methods[input.choice / kOneIn % methods.size()];
  Judged judged;
  judged.by_oracle = input.choice % kOneIn == 0;
  for (const law::Law& one : law::laws(engine::Kind::rotating)) {
    if (judged.finding) break;
    const bool asked = one.needs == law::Needs::proof || one.name == "turning_answer_is_consistent" ||
                       (one.needs == law::Needs::oracle && judged.by_oracle);
    if (asked) add(judged, one.name, method.full_name(), one.check(problem, method), problem);
  }
  return judged;
}

}  // namespace

const Target kTarget = {.name = "rotating_cast", .judge = &judge_turning};

}  // namespace graze::fuzz
