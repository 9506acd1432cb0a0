// One case, all methods in double, judged by proofs; the exact oracle settles what the proofs leave open.
//
//   1  what must be refused is refused, and nothing in the domain is;
//   2  every answer is consistent in itself (laws_proof.hpp);
//   3  every proof is accepted by the exact checker, so L = the largest lower bound of any of them and U =
//   the
//      least upper bound hold for the true TOI, whatever method found them;
//   4  an answer that lies within [L, U], where L and U are a few roundings apart, is right;
//   5  an answer of tier exact is judged to the last bit (exact_answer.hpp), where that tier answers at all;
//   6  any other answer goes to the oracle, as does every answer of a case that is asked for (a sample), if
//   it
//      decides the case (judge.hpp).
#pragma once

#include <string>
#include <vector>

#include "properties/laws/law.hpp"

namespace graze::law {

struct CastJudgement {
  std::string fault;       // empty: nothing is wrong
  bool by_oracle = false;  // whether the oracle was asked
  struct Said {
    std::string method;
    engine::Answer answer;
  };
  std::vector<Said> said;  // every side's answer
};

// Whether the answer's own proof shows it to be within its method's row: a verdict proved, or a bracket that,
// joined with the proved one, is no wider than the row grants. The checker has accepted the proof.
[[nodiscard]] bool is_settled_by_proof(const corpus::Case& problem, const engine::EngineMethod& method,
                                       const engine::Answer& answer);

[[nodiscard]] CastJudgement judge_cast(const corpus::Case& problem, bool ask_oracle);

// The case as JSON, every number as a hexfloat, every side's answer, and the fault: several lines.
[[nodiscard]] std::string report(const corpus::Case& problem, const CastJudgement& judgement);

}  // namespace graze::law
