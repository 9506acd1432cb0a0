// Does any linear cast answer wrongly?
//
//   1. Decode. One case in a thousand, by the choice, goes to every method and to the exact oracle, which judges all
//      that it can (judge/judge_cast.hpp).
//   2. Otherwise the choice names one method, and it answers everything.
//   3. The answer must be consistent in itself, and the checker must accept its proof. Tier exact is judged by its own
//      proof to the last bit (exact_answer.hpp). Elsewhere a proof as narrow as the method's guarantee settles the
//      answer.
//   4. An answer left open is now and then compared with the tier that proves its answers: exact where it exists,
//      certified elsewhere. If the two disagree, the oracle is called one time in 32, because at a graze two times may
//      both be right and yet far apart.
#include <fmt/format.h>

#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/by_proof.hpp"
#include "properties/judge/exact_answer.hpp"
#include "properties/judge/judge_cast.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/linear/proof.hpp"

namespace graze::fuzz {

namespace {

using corpus::Case;
using engine::Answer;
using engine::Method;

constexpr std::uint64_t kOracleOneIn = 1000, kArbitratedOneIn = 32;
// The proving tiers take ten times as long as other methods where numbers are exact, and a hundred times for curved
// shapes. Called this rarely, they still take about as much time as the others together. Other targets call tier exact
// for every case.
constexpr std::uint64_t kExactOneIn = 12;
struct Seldom {
  std::uint64_t certified, compared;  // one time in so many
};
constexpr Seldom kOfExactQuestions = {64, 8}, kOfOthers = {256, 64};

// A choice is used digit by digit, so that no two decisions are correlated.
class Choice {
 public:
  explicit Choice(std::uint64_t rest) : rest_(rest) {}
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t digit = rest_ % count;
    rest_ /= count;
    return digit;
  }
  bool once_in(std::uint64_t count) { return below(count) == 0; }

 private:
  std::uint64_t rest_;
};

Judged judge_all(const Case& problem) {
  const law::CastJudgement said = law::judge_cast(problem, true);
  Judged judged{.reached = law::is_linear_question(problem), .by_oracle = said.by_oracle, .finding = {}};
  if (said.fault.empty()) return judged;
  const std::size_t colon = said.fault.find(": ");
  judged.finding = {"judge_cast", said.fault.substr(0, colon), said.fault.substr(colon + 2), problem,
                    law::report(problem, said)};
  return judged;
}

// The fault of an answer, found from the answer itself and its proof.
std::string own_fault(const Case& problem, const Method& method, const Answer& answer) {
  std::string fault = law::consistency_fault(problem, method, answer, Request::everything);
  if (!fault.empty()) return fault;
  if (method.is_exact()) return law::judge_exact_by_proof(problem, answer, false).fault;
  return law::proof_fault(problem, answer);
}

bool is_settled(const Case& problem, const Method& method, const Answer& answer) {
  return answer.proof && law::is_settled_by(*answer.proof, method, problem, answer);
}

const Method& method_of(bool exact, const Seldom& seldom, Choice& choice) {
  const char* const standard[] = {"ca", "gjk", "mpr"};
  if (exact && choice.once_in(kExactOneIn)) return *engine::find_method(engine::Kind::linear, "exact");
  if (choice.once_in(seldom.certified)) return *engine::find_method(engine::Kind::linear, "certified");
  return *engine::find_method(engine::Kind::linear, standard[choice.below(std::size(standard))]);
}

Judged judge_one(const Case& problem, Choice choice) {
  Judged judged;
  judged.reached = law::is_linear_question(problem);
  const bool refused = !judged.reached && !law::in_domain(problem);
  if (!judged.reached && !refused) return judged;  // out of range: an answer promises nothing
  const bool exact = judged.reached && engine::is_exact_question(problem);
  const Seldom& seldom = exact ? kOfExactQuestions : kOfOthers;
  const Method& method = method_of(exact, seldom, choice);
  const Answer answer = method.ask(problem, {.request = Request::everything});
  const auto find = [&](const char* name, const Method& blamed, const Answer& said, std::string fault) {
    if (fault.empty() || judged.finding) return;
    judged.finding = {name, blamed.full_name(), std::move(fault), problem,
                      fmt::format("{}: {}\n", blamed.full_name(), law::describe(said))};
  };
  if (refused) {
    judged.reached = true;
    if (answer.outcome != Outcome::invalid_input) {
      find("bad_input_is_refused", method, answer, "bad input is let in");
    }
    return judged;
  }
  find("proof_and_answer", method, answer, own_fault(problem, method, answer));
  if (judged.finding || method.is_exact() || is_settled(problem, method, answer)) return judged;

  const Method& proving = *engine::find_method(engine::Kind::linear, exact ? "exact" : "certified");
  if (method.name == proving.name || !choice.once_in(seldom.compared)) return judged;
  const Answer proved = proving.ask(problem, {.request = Request::everything});
  find("proof_and_answer", proving, proved, own_fault(problem, proving, proved));
  if (judged.finding || law::agree(answer, proved, method.unit_roundoff)) return judged;
  if (!choice.once_in(kArbitratedOneIn) || !law::has_truth(problem)) return judged;
  judged.by_oracle = true;
  find("answers_agree", method, answer, law::any_fault(method, problem, answer));
  find("answers_agree", proving, proved, law::any_fault(proving, problem, proved));
  return judged;
}

Judged judge_linear(const Input& input) {
  const Case problem = as_linear(input.problem);
  Choice choice(input.choice);
  return choice.once_in(kOracleOneIn) ? judge_all(problem) : judge_one(problem, choice);
}

}  // namespace

const Target kTarget = {.name = "linear_cast", .judge = &judge_linear};

}  // namespace graze::fuzz
