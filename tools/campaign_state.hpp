// A campaign as far as it has come: its settings, the blocks that are done, their tally. In a file it is both
// what a run goes on from and what it hands in at the end; docs/campaigns.md describes the fields.
#pragma once

#include <boost/icl/interval_set.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campaign_tally.hpp"

namespace graze::tool {

// What the result is a function of.
struct CampaignSettings {
  std::string method;                 // "exact/double"
  std::vector<std::string> families;  // those asked, in the order of the table
  std::uint64_t casts = 0, seed = 1;
  std::uint64_t oracle_every = 0;  // 0: no sample
  std::uint64_t block = 0;         // casts
  // Hash of cases of every level and of the answers to them: of a build that generates other cases, or
  // answers them otherwise, it is another.
  std::string fingerprint;

  [[nodiscard]] std::uint64_t blocks() const { return casts / block + (casts % block != 0 ? 1 : 0); }
  friend bool operator==(const CampaignSettings&, const CampaignSettings&) = default;
};

// "seed is 2 here and 1 there": the first field that differs; empty if none does.
[[nodiscard]] std::string difference(const CampaignSettings& here, const CampaignSettings& there);

[[nodiscard]] std::string fingerprint(const CampaignCases& cases, const engine::EngineMethod& method);

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

// Of block numbers; half-open intervals, joined where they meet.
using BlockSet = boost::icl::interval_set<std::uint64_t, std::less,
                                          boost::icl::right_open_interval<std::uint64_t, std::less>>;
using BlockRange = BlockSet::interval_type;

struct CampaignState {
  CampaignSettings settings;
  Shard shard;
  // The levels of `tally.counts`, and those that were left out.
  std::vector<std::pair<std::string, double>> levels;
  std::vector<std::string> left_out;
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
[[nodiscard]] CampaignState fresh_state(CampaignSettings settings, Shard shard, const CampaignCases& cases);

// JSON, the same text for the same state. Reading throws std::runtime_error with one line that names the file
// and the field. Writing goes beside the file first and then in its place, and throws if it cannot.
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
