// Does an exact edit of a case change what a method answers?
//
//   1. Decode.
//   2. Choose a law that needs the method alone, and a method that takes the case, by the choice.
//   3. Check it. If it does not apply, try the next laws, kTries at most.
#include <vector>

#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::fuzz {

namespace {

// Nearly every question has a law of eight in a row that applies (an exact translation, a power of two).
constexpr std::size_t kTries = 8;

const std::vector<const law::Law*>& metamorphic_laws() {
  static const std::vector<const law::Law*> kLaws = [] {
    std::vector<const law::Law*> out;
    for (const law::Law& one : law::laws(engine::Kind::linear)) {
      // Poisons every number of the case in turn: hundreds of casts, all refused alike.
      if (one.needs == law::Needs::metamorphic && one.name != "bad_input_is_refused") out.push_back(&one);
    }
    return out;
  }();
  return kLaws;
}

Judged judge_edits(const Input& input) {
  const corpus::Case problem = as_linear(input.problem);
  const auto& laws = metamorphic_laws();
  const auto& methods = engine::methods(engine::Kind::linear);
  std::size_t chosen = input.choice / 256 % methods.size();
  // Tier exact takes few cases. Every case has a method that takes it.
  for (std::size_t i = 0;
       i < methods.size() && !law::is_question_for(methods[chosen], methods[chosen].seen(problem)); ++i) {
    chosen = (chosen + 1) % methods.size();
  }
  const engine::Method& method = methods[chosen];
  Judged judged;
  for (std::size_t i = 0; i < kTries && !judged.reached; ++i) {
    const law::Law& one = *laws[(input.choice % 256 + i) % laws.size()];
    add(judged, one.name, method.full_name(), one.check(problem, method), problem);
  }
  return judged;
}

}  // namespace

const Target kTarget = {.name = "metamorphic", .judge = &judge_edits};

}  // namespace graze::fuzz
