// What a campaign came to, as text. Nothing in it depends on time, threads or machines.
#pragma once

#include <string>
#include <vector>

#include "engines/guarantees.hpp"
#include "tools/campaign_state.hpp"

namespace graze::tool {

// Settings, a line a family, the digest, the findings.
[[nodiscard]] std::string campaign_summary(const CampaignState& state, const engine::Guarantee* row);

// What the campaign found wanting, a line each: every family with a fault, and those that stall more often
// than the method's row allows (without a row, at all). Empty: nothing.
[[nodiscard]] std::vector<std::string> campaign_failures(const CampaignState& state,
                                                         const engine::Guarantee* row);

// The cases of the findings, generated again, in the order of their indices.
[[nodiscard]] std::vector<corpus::Case> found_cases(const CampaignState& state);

// Prints the summary, writes the state to `json` and the found cases to `save` where those are named. Returns
// the exit code.
struct CampaignOutputs {
  std::string json, save;
};
[[nodiscard]] int hand_out(const CampaignState& state, const CampaignOutputs& outputs);

}  // namespace graze::tool
