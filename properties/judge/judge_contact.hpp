// The contact of a hit by the oracle: its normal and its witnesses.
#pragma once

#include "oracles/truth/case_truth.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {

// Into judgement.bad_contact, for the requested parts. In tier certified the contact may also be off by its width and
// by the cost of rounding its time.
void judge_contact(Judgement& judgement, const oracle::CaseTruth& exact, const engine::Answer& answer,
                   const engine::Method& method, const corpus::Case& problem, const Limits& limits,
                   Request request);

}  // namespace graze::law
