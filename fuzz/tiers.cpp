// Do tiers, methods and scalars contradict each other?
//
//   1. Decode. Half of the cases are rounded to float, so that both scalars get one question.
//   2. Call every method of both scalars for its verdict.
//   3. Brackets of tiers certified and exact hold without condition: any two for one question have a time in common.
//   4. Every other answer agrees with the proved one for its question, or the oracle finds each within its guarantee.
//   5. The two scalars' answers of one method agree likewise.
#include <fmt/format.h>

#include "engines/convert.hpp"
#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::fuzz {

namespace {

using corpus::Case;
using engine::Answer;
using engine::Method;

struct Said {
  const Method* method;
  const Case* seen;  // as the method saw it
  Answer answer;
  [[nodiscard]] bool proved() const { return method->is_exact() || method->is_certified(); }
};

class Comparison {
 public:
  explicit Comparison(const Case& problem)
      : problem_(problem),
        in_float_(engine::rounded_case<float>(problem)),
        one_question_(law::same_input(problem, in_float_)) {
    for (const Method& method : engine::methods(engine::Kind::linear)) {
      const Case& seen = method.scalar == "float" && !one_question_ ? in_float_ : problem_;
      if (law::is_question_for(method, seen)) said_.push_back({&method, &seen, method.ask(seen, {})});
    }
    judged_.reached = said_.size() >= 2;
  }

  Judged judge() {
    for (std::size_t i = 0; i < said_.size(); ++i) {
      for (std::size_t j = i + 1; j < said_.size(); ++j) {
        if (judged_.finding) return judged_;
        compare(said_[i], said_[j]);
      }
    }
    return judged_;
  }

 private:
  void compare(const Said& one, const Said& other) {
    if (one.seen != other.seen) return;
    if (one.proved() && other.proved()) {
      const double lower = std::max(one.answer.toi_lower, other.answer.toi_lower);
      const double upper = std::min(one.answer.toi_upper, other.answer.toi_upper);
      if (lower <= upper) return;
      find("proved_brackets_meet", one, other, "two proved brackets have no time in common");
      return;
    }
    const double u = std::max(one.method->unit_roundoff, other.method->unit_roundoff);
    const bool comparable = one.proved() || other.proved() || one.method->name == other.method->name;
    if (!comparable || law::agree(one.answer, other.answer, u) || !law::has_truth(*one.seen)) return;
    judged_.by_oracle = true;
    for (const Said* blamed : {&one, &other}) {
      const std::string fault = law::any_fault(*blamed->method, *blamed->seen, blamed->answer);
      if (fault.empty()) continue;
      find("tiers_agree", *blamed, blamed == &one ? other : one, fault);
      return;
    }
  }

  void find(const char* name, const Said& blamed, const Said& other, const std::string& fault) {
    std::string sides;
    for (const Said& one : said_) {
      sides += fmt::format("{}: {}\n", one.method->full_name(), law::describe(one.answer));
    }
    judged_.finding = {name, blamed.method->full_name(),
                       fmt::format("against {}: {}", other.method->full_name(), fault), *blamed.seen, sides};
  }

  const Case& problem_;
  const Case in_float_;
  const bool one_question_;
  std::vector<Said> said_;
  Judged judged_;
};

Judged judge_tiers(const Input& input) {
  Case problem = as_linear(input.problem);
  if (input.choice % 2 == 0) problem = engine::rounded_case<float>(problem);
  return Comparison(problem).judge();
}

}  // namespace

const Target kTarget = {.name = "tiers", .judge = &judge_tiers};

}  // namespace graze::fuzz
