// One case, asked of every linear method in double, each answer judged; and what a person reads of it.
//
//   1  what must be refused is refused, and nothing in the domain is;
//   2  every answer is consistent in itself (properties/laws/linear/proof.hpp);
//   3  every answer is judged (judge.hpp) by its proof, and by the oracle where that leaves something open,
//      or for every answer of a case that is asked for.
#pragma once

#include <string>
#include <vector>

#include "engines/method.hpp"

namespace graze::law {

struct CastJudgement {
  std::string fault;       // the method and what is wrong; empty: nothing is
  bool by_oracle = false;  // whether the oracle was asked
  struct Said {
    std::string method;
    engine::Answer answer;
  };
  std::vector<Said> said;  // every side's answer
};

[[nodiscard]] CastJudgement judge_cast(const corpus::Case& problem, bool ask_oracle);

// The case as JSON, every number as a hexfloat, every side's answer, and the fault: several lines.
[[nodiscard]] std::string report(const corpus::Case& problem, const CastJudgement& judgement);

}  // namespace graze::law
