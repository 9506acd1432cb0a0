// What a campaign keeps of its casts: counts by family and level, a digest, and the first findings.
//
// Tallies form a commutative monoid under merge(): the whole does not depend on how the casts were shared out
// to threads, blocks, runs and machines, nor on their order.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/campaign_cases.hpp"
#include "tools/campaign_cast.hpp"

namespace graze::tool {

// Of one level of one family, or of several.
struct CampaignCounts {
  std::uint64_t casts = 0;
  std::uint64_t overlapping = 0, hits = 0, misses = 0, not_converged = 0, refused = 0;  // by outcome
  std::uint64_t proved = 0;     // the proof was accepted and shows the verdict
  std::uint64_t by_oracle = 0;  // judged by the oracle, too
  std::uint64_t sampled = 0;    // of those, chosen before the answer was known
  std::uint64_t faults = 0;     // wrong, late, off, a bad contact or a false proof
  std::uint64_t stalls = 0;     // not_converged, and not excused; its frequency is capped by the row
  std::uint64_t excused = 0;    // decided by less than the row's limit
  std::uint64_t not_asked = 0;  // no question was found; not among the casts

  CampaignCounts& operator+=(const CampaignCounts& other);
  friend bool operator==(const CampaignCounts&, const CampaignCounts&) = default;
};

// The fields by name, for readers and writers.
struct CountField {
  const char* name;
  std::uint64_t CampaignCounts::*value;
};
inline constexpr std::array<CountField, 13> kCountFields = {{
    {"casts", &CampaignCounts::casts},
    {"overlapping", &CampaignCounts::overlapping},
    {"hits", &CampaignCounts::hits},
    {"misses", &CampaignCounts::misses},
    {"not_converged", &CampaignCounts::not_converged},
    {"refused", &CampaignCounts::refused},
    {"proved", &CampaignCounts::proved},
    {"by_oracle", &CampaignCounts::by_oracle},
    {"sampled", &CampaignCounts::sampled},
    {"faults", &CampaignCounts::faults},
    {"stalls", &CampaignCounts::stalls},
    {"excused", &CampaignCounts::excused},
    {"not_asked", &CampaignCounts::not_asked},
}};

// A cast that was found wanting. Its case is find_family(family)->generate(level, seed).
struct Finding {
  std::uint64_t index = 0;  // of the case in the campaign
  std::string family;
  double level = 0;
  std::uint64_t seed = 0;
  std::string reason;

  [[nodiscard]] std::string id() const;
  friend bool operator==(const Finding&, const Finding&) = default;
};

struct CampaignTally {
  // Those of least index are kept; all are counted.
  static constexpr std::size_t kFindings = 100;

  std::vector<CampaignCounts> counts;  // by slot of the campaign
  // The sum, mod 2^64, of a hash of each cast's index, outcome and bracket.
  std::uint64_t digest = 0;
  std::vector<Finding> faults = {}, stalls = {};  // by index

  explicit CampaignTally(std::size_t slots = 0) : counts(slots) {}
  void add(std::uint64_t index, const DrawnCase& drawn, const CampaignCast& cast);
  void add_not_asked(const DrawnCase& drawn) { ++counts[drawn.slot].not_asked; }
  void merge(const CampaignTally& other);  // of the same campaign
  [[nodiscard]] CampaignCounts total() const;
  friend bool operator==(const CampaignTally&, const CampaignTally&) = default;
};

// Of one cast: its index, its outcome and the bits of its bracket.
[[nodiscard]] std::uint64_t answer_hash(std::uint64_t index, const engine::Answer& answer);

}  // namespace graze::tool
