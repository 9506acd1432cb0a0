// The results of a campaign as text. Nothing in it depends on time, threads or machines.
#pragma once

#include <string>
#include <vector>

#include "certify/campaign/campaign_state.hpp"

namespace graze::tool {

// Settings, a line a family of each method (with `levels`, one of each level), the digest, the findings.
[[nodiscard]] std::string campaign_summary(const CampaignState& state, bool levels = false);

// The failures of the campaign, one line each, or an empty list:
// - every family in which a method has a fault
// - families in which more answers did not converge than the guarantee allows, or any without a guarantee
// - levels in which more did not converge than the guarantee's share, rounded up
// - parts of whose cases the oracle leaves more than kMostUndecided undecided, rounded up to a whole case
inline constexpr double kMostUndecided = 1e-3;
[[nodiscard]] std::vector<std::string> campaign_failures(const CampaignState& state);

// The cases of all faults, of answers that did not converge, and of those that the oracle left undecided.
// They are generated again, in the order of their indices, each once.
[[nodiscard]] std::vector<corpus::Case> found_cases(const CampaignState& state);
[[nodiscard]] std::vector<corpus::Case> undecided_cases(const CampaignState& state);

// Prints the summary, writes the state to `json`, the found cases to `save` and those left undecided to
// `save_undecided` where those are named. Returns the exit code.
struct CampaignOutputs {
  std::string json, save, save_undecided;
  bool levels = false;
};
[[nodiscard]] int hand_out(const CampaignState& state, const CampaignOutputs& outputs);

}  // namespace graze::tool
