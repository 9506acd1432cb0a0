// One cast of a campaign: a case is cast and judged, by its proof first.
#pragma once

#include "corpus/case.hpp"
#include "engines/guarantees.hpp"
#include "engines/method.hpp"
#include "tools/judge.hpp"

namespace graze::tool {

struct CampaignCast {
  engine::Answer answer;
  Judgement judgement;
};

// The method asked for everything, with its proof. The oracle decides what the proof leaves open and, if
// `measure`, the rest as well. Without a row the method is held to kPlainKappa. Does not throw: a judge that
// cannot judge convicts with its reason.
[[nodiscard]] CampaignCast campaign_cast(const corpus::Case& problem, const engine::EngineMethod& method,
                                         const engine::Guarantee* row, bool measure);

}  // namespace graze::tool
