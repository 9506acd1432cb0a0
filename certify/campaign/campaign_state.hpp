// The state of a campaign: its settings, the blocks that are done, and their tally. A run reads its state
// from a file to continue, and writes the same file as its result. docs/howto/campaign.md describes the
// fields.
#pragma once

#include <boost/icl/interval_set.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "certify/campaign/campaign_plan.hpp"
#include "certify/campaign/campaign_tally.hpp"

namespace graze::tool {

// Share i of n, from 1: the blocks [blocks (i - 1) / n, blocks i / n).
struct Shard {
  std::uint64_t index = 1, count = 1;

  [[nodiscard]] std::uint64_t first(std::uint64_t blocks) const { return bound(blocks, index - 1); }
  [[nodiscard]] std::uint64_t end(std::uint64_t blocks) const { return bound(blocks, index); }
  friend bool operator==(const Shard&, const Shard&) = default;

 private:
  // floor(blocks i / n) without overflow.
  [[nodiscard]] std::uint64_t bound(std::uint64_t blocks, std::uint64_t i) const {
    return blocks / count * i + blocks % count * i / count;
  }
};

// A set of block numbers, as half-open intervals that are joined where they meet.
using BlockSet = boost::icl::interval_set<std::uint64_t, std::less,
                                          boost::icl::right_open_interval<std::uint64_t, std::less>>;
using BlockRange = BlockSet::interval_type;

struct CampaignState {
  CampaignSettings settings;
  Shard shard;
  std::vector<Cell> cells;            // the cells of `tally.counts`
  std::vector<std::string> left_out;  // levels and families
  BlockSet done;
  CampaignTally tally;

  [[nodiscard]] std::uint64_t blocks_done() const { return boost::icl::cardinality(done); }
  [[nodiscard]] std::uint64_t casts_done() const;
  [[nodiscard]] BlockRange share() const {
    return {shard.first(settings.blocks()), shard.end(settings.blocks())};
  }
  // Every block of its share is done.
  [[nodiscard]] bool is_complete() const;
};

// Nothing is done yet.
[[nodiscard]] CampaignState fresh_state(const CampaignPlan& plan, std::uint64_t block, Shard shard);

// JSON, the same text for the same state. Reading throws std::runtime_error with a one-line message that
// names the file and the field. Writing creates a new file and then replaces the old one, and throws if it
// cannot.
[[nodiscard]] std::string state_text(const CampaignState& state);
[[nodiscard]] CampaignState parse_state(std::string_view text, const std::string& name);
[[nodiscard]] CampaignState read_state(const std::filesystem::path& file);
void write_state(const CampaignState& state, const std::filesystem::path& file);

// All shards of one campaign, in any order, as the campaign in one piece. Throws std::runtime_error with one
// line if settings differ, blocks are in two of them, or, unless `partial`, blocks are in none.
struct NamedState {
  std::string name;
  CampaignState state;
};
[[nodiscard]] CampaignState merge_states(const std::vector<NamedState>& parts, bool partial);

}  // namespace graze::tool
