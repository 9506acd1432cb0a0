// Runs the blocks of a campaign that are not done yet.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>

#include "certify/campaign/campaign_state.hpp"

namespace graze::tool {

struct CampaignJob {
  const CampaignPlan* plan = nullptr;
  unsigned threads = 1;
  std::filesystem::path state_file = {};  // empty: none is written
  std::chrono::steady_clock::duration save_every = std::chrono::seconds(30);
  // Called by every thread before a block. If it returns true, the run ends when the blocks in progress are
  // done.
  std::function<bool()> stop = [] { return false; };
};

// The tally of one block: answers [block size, (block + 1) size) of the campaign.
void run_block(const CampaignJob& job, const CampaignSettings& settings, std::uint64_t block,
               CampaignTally& tally);

// Runs every block of the state's share that is not done, and adds each to the state. The first exception of
// a thread ends the run and is rethrown here.
void run_campaign(const CampaignJob& job, CampaignState& state);

}  // namespace graze::tool
