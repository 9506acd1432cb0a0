// Does a plan spare motion that it must not, or simulate motion that it reports as spared?
//
//   1. Decode. The step is finite, and the rotations are moderate.
//   2. Choose a law of the plan, or of rotations that no plan simulates, and a method, by the choice.
//   3. Check it. If it does not apply, try the next laws, each once.
#include <vector>

#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/laws/law.hpp"

namespace graze::fuzz {

namespace {

bool is_of_plans(std::string_view name) {
  for (const std::string_view word : {"plan", "unseen", "as_one", "unturned"}) {
    if (name.find(word) != std::string_view::npos) return true;
  }
  return false;
}

const std::vector<const law::Law*>& plan_laws() {
  static const std::vector<const law::Law*> kLaws = [] {
    std::vector<const law::Law*> out;
    for (const law::Law& one : law::laws(engine::Kind::rotating)) {
      if (is_of_plans(one.name)) out.push_back(&one);
    }
    return out;
  }();
  return kLaws;
}

// The methods whose answer depends on the plan. The others do not use one.
const std::vector<const engine::Method*>& planned_methods() {
  static const std::vector<const engine::Method*> kMethods = [] {
    std::vector<const engine::Method*> out;
    for (const engine::Method& one : engine::methods(engine::Kind::rotating)) {
      if (one.name == "plan" || one.is_certified()) out.push_back(&one);
    }
    return out;
  }();
  return kMethods;
}

Judged judge_plan(const Input& input) {
  const corpus::Case problem = as_turning(input.problem);
  const auto& laws = plan_laws();
  const engine::Method& method = *planned_methods()[input.choice / 256 % planned_methods().size()];
  Judged judged;
  for (std::size_t i = 0; i < laws.size() && !judged.reached; ++i) {
    const law::Law& one = *laws[(input.choice % 256 + i) % laws.size()];
    add(judged, one.name, method.full_name(), one.check(problem, method), problem);
  }
  return judged;
}

}  // namespace

const Target kTarget = {.name = "plans", .judge = &judge_plan};

}  // namespace graze::fuzz
