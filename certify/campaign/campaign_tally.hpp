// The results that a campaign keeps: counts by contender, family and level, a digest, and the first findings.
//
// Tallies form a commutative monoid under merge(): the whole does not depend on how the casts were shared out
// to threads, blocks, runs and machines, nor on their order.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/campaign/campaign_cast.hpp"

namespace graze::tool {

// Counts of one level of one family, or of several.
struct CampaignCounts {
  std::uint64_t casts = 0;
  std::uint64_t overlapping = 0, hits = 0, misses = 0, not_converged = 0, refused = 0;  // by outcome
  std::uint64_t proved = 0;     // the proof was accepted and shows the verdict
  std::uint64_t by_oracle = 0;  // judged by the oracle, too
  std::uint64_t sampled = 0;    // judged by the oracle, and chosen before the answer was known
  std::uint64_t undecided = 0;  // judged by the oracle, which could not decide
  // By fault, the first eight: an answer counts as its worst.
  std::uint64_t wrong = 0, late = 0, off = 0, contact_off = 0, proofs_refused = 0, unproved = 0;
  std::uint64_t work = 0;    // more support evaluations than the guarantee
  std::uint64_t failed = 0;  // a third-party engine crashed, hung, or wrote an invalid answer
  std::uint64_t faults = 0;  // answers with any of them
  std::uint64_t stalls = 0;  // not_converged and not within tolerance, capped by the guarantee's fraction
  std::uint64_t within_tolerance = 0;  // decided by less than the guarantee's limit
  std::uint64_t skipped = 0;           // no question was found, not counted in casts
  std::uint64_t most_supports = 0;     // support evaluations of the costliest answer
  double widest = 0;                   // the largest error that the oracle measured, over the limit

  CampaignCounts& operator+=(const CampaignCounts& other);
  friend bool operator==(const CampaignCounts&, const CampaignCounts&) = default;
};

// The fields by name, for readers and writers.
struct CountField {
  const char* name;
  std::uint64_t CampaignCounts::*value;
};
inline constexpr std::array<CountField, 22> kCountFields = {{
    {"casts", &CampaignCounts::casts},
    {"overlapping", &CampaignCounts::overlapping},
    {"hits", &CampaignCounts::hits},
    {"misses", &CampaignCounts::misses},
    {"not_converged", &CampaignCounts::not_converged},
    {"refused", &CampaignCounts::refused},
    {"proved", &CampaignCounts::proved},
    {"by_oracle", &CampaignCounts::by_oracle},
    {"sampled", &CampaignCounts::sampled},
    {"undecided", &CampaignCounts::undecided},
    {"wrong", &CampaignCounts::wrong},
    {"late", &CampaignCounts::late},
    {"off", &CampaignCounts::off},
    {"contact_off", &CampaignCounts::contact_off},
    {"proofs_refused", &CampaignCounts::proofs_refused},
    {"unproved", &CampaignCounts::unproved},
    {"work", &CampaignCounts::work},
    {"failed", &CampaignCounts::failed},
    {"faults", &CampaignCounts::faults},
    {"stalls", &CampaignCounts::stalls},
    {"excused", &CampaignCounts::within_tolerance},
    {"not_asked", &CampaignCounts::skipped},
}};

// An answer that is at fault, did not converge, or that the oracle could not decide. Its case is that of
// (family, level, seed), as the contender is asked it.
struct Finding {
  std::uint64_t index = 0;  // index of the answer in the campaign
  std::string method, family;
  double level = 0;
  std::uint64_t seed = 0;
  std::string reason;

  [[nodiscard]] std::string id() const;
  friend bool operator==(const Finding&, const Finding&) = default;
};

struct CampaignTally {
  // For each contender and family, those with the least index are kept. All are counted.
  static constexpr std::size_t kFindings = 100;

  std::vector<CampaignCounts> counts;  // by cell of the plan
  // The sum, mod 2^64, of a hash of each answer's index, outcome and numbers.
  std::uint64_t digest = 0;
  std::vector<Finding> faults = {}, stalls = {}, undecided = {};  // by index

  explicit CampaignTally(std::size_t cells = 0) : counts(cells) {}
  void add(std::uint64_t index, std::size_t cell, const engine::Method& contender, const DrawnCase& drawn,
           const CampaignCast& cast);
  void add_skipped(std::size_t cell) { ++counts[cell].skipped; }
  void merge(const CampaignTally& other);  // other belongs to the same campaign
  [[nodiscard]] CampaignCounts total() const;
  friend bool operator==(const CampaignTally&, const CampaignTally&) = default;
};

}  // namespace graze::tool
