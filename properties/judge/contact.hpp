// The errors of an answer by the oracle, and the contact of a hit: its normal and its witnesses.
#pragma once

#include "properties/judge/answer.hpp"

namespace graze::tool {

// Keeps the first reason.
inline void convict(std::string& fault, std::string why) {
  if (fault.empty()) fault = std::move(why);
}

// Into judgement.bad_contact: of a hit the normal and the witnesses, as far as requested, to `limit`, a
// length.
void judge_contact(Judgement& judgement, const oracle::CaseTruth& exact, const engine::Answer& answer,
                   const corpus::Case& problem, const Limits& limits, double limit, Request request);

}  // namespace graze::tool
