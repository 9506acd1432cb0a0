// Does any linear cast answer wrongly?
//
//   1  decode; one case in a thousand, by its tail or a hash of its numbers, goes to every method and to the
//      exact oracle, with all that it can judge (judge_cast.hpp);
//   2  else ask the tier that proves its answer, exact where that exists, certified elsewhere, and one other
//      method, for everything;
//   3  both answers are consistent in themselves, and the checker accepts their proofs; tier exact is judged
//   to
//      the last bit by its own (exact_answer.hpp);
//   4  the other agrees with the proved bracket; where it does not, the oracle is asked one time in eight: at
//      a graze two times may both be right and yet far apart.
#include <fmt/format.h>

#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/case_edit.hpp"
#include "properties/exact_answer.hpp"
#include "properties/judge.hpp"
#include "properties/judge_cast.hpp"
#include "properties/laws_proof.hpp"

namespace graze::fuzz {

namespace {

using corpus::Case;
using engine::Answer;
using engine::EngineMethod;

constexpr std::uint64_t kOracleOneIn = 1000, kArbitratedOneIn = 8;

Judged judge_all(const Case& problem) {
  const law::CastJudgement said = law::judge_cast(problem, true);
  Judged judged{.reached = law::is_linear_question(problem), .by_oracle = said.by_oracle, .finding = {}};
  if (said.fault.empty()) return judged;
  const std::size_t colon = said.fault.find(": ");
  judged.finding = {"judge_cast", said.fault.substr(0, colon), said.fault.substr(colon + 2), problem,
                    law::report(problem, said)};
  return judged;
}

struct Said {
  const EngineMethod* method;
  Answer answer;
};

// What is wrong with an answer, by itself and by its proof.
std::string own_fault(const Case& problem, const Said& said) {
  std::string fault = law::consistency_fault(problem, *said.method, said.answer, Request::everything);
  if (!fault.empty()) return fault;
  if (said.method->is_exact()) return law::judge_exact_by_proof(problem, said.answer, false).fault;
  return law::proof_fault(problem, said.answer);
}

Judged judge_two(const Case& problem, std::uint64_t choice) {
  Judged judged;
  const auto find = [&](const Said& said, const char* name, std::string fault) {
    if (fault.empty() || judged.finding) return;
    judged.finding = {name, said.method->full_name(), std::move(fault), problem,
                      fmt::format("{}: {}\n", said.method->full_name(), law::describe(said.answer))};
  };
  const bool refused = law::must_be_refused(problem);
  judged.reached = law::is_linear_question(problem);
  if (!judged.reached && !refused) return judged;  // out of range: an answer promises nothing
  const EngineMethod& proving =
      *engine::find_method(judged.reached && engine::is_exact_question(problem) ? "exact" : "certified");
  const char* const others[] = {"ca", "gjk", "mpr", "certified"};
  const EngineMethod& other = *engine::find_method(others[choice % std::size(others)]);
  std::vector<Said> said;
  for (const EngineMethod* method : {&proving, &other}) {
    if (!said.empty() && method == said[0].method) continue;
    said.push_back({method, method->cast(problem, {.request = Request::everything})});
    if (!refused) {
      find(said.back(), "proof_and_answer", own_fault(problem, said.back()));
    } else if (said.back().answer.outcome != Outcome::invalid_input) {
      find(said.back(), "bad_input_is_refused", "bad input is let in");
    }
  }
  if (refused || judged.finding || said.size() < 2) return judged;
  if (law::agree(said[0].answer, said[1].answer, other.unit_roundoff)) return judged;
  if (choice / std::size(others) % kArbitratedOneIn != 0 || !law::has_truth(problem)) return judged;
  judged.by_oracle = true;
  for (const Said& one : said) find(one, "answers_agree", law::any_fault(*one.method, problem, one.answer));
  return judged;
}

Judged judge_linear(const Input& input) {
  const Case problem = as_linear(input.problem);
  return input.choice % kOracleOneIn == 0 ? judge_all(problem) : judge_two(problem, input.choice);
}

}  // namespace

const Target kTarget = {.name = "linear_cast", .judge = &judge_linear};

}  // namespace graze::fuzz
