// What a campaign came to, as text. Nothing in it depends on time, threads or machines.
#pragma once

#include <string>
#include <vector>

#include "certify/campaign/campaign_state.hpp"

namespace graze::tool {

// Settings, a line a family of each method (with `levels`, one of each level), the digest, the findings.
[[nodiscard]] std::string campaign_summary(const CampaignState& state, bool levels = false);

// What the campaign found wanting, a line each: every family of a method with a fault; those that stall more
// often than the method's row allows (without a row, at all), and levels that do, by more than the row's
// share rounded up; and a part of which the oracle leaves more than kMostUndecided undecided. Empty: nothing.
inline constexpr double kMostUndecided = 1e-3;
[[nodiscard]] std::vector<std::string> campaign_failures(const CampaignState& state);

// The cases of the faults and stalls, generated again, in the order of their indices, each once; and those
// that the oracle left undecided.
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
