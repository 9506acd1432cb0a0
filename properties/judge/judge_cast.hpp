// Runs every linear method in double on one case, judges each answer, and reports it for a person.
//
//   1. Invalid input is refused, and nothing in the domain is.
//   2. Every answer is consistent in itself (properties/laws/linear/proof.hpp).
//   3. Every answer is judged (judge.hpp) by its proof. The oracle is called if that leaves something open, or for
//      every answer of a case that requests it.
#pragma once

#include <string>
#include <vector>

#include "engines/method.hpp"

namespace graze::law {

struct CastJudgement {
  std::string fault;       // the method and its fault, or empty
  bool by_oracle = false;  // the oracle was called
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
