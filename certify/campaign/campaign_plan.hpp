// The questions of a campaign: answer number i is the answer of one contender to one case.
//
// A campaign has parts, one after the other. In a part with M contenders, answer i is contender i mod M's
// answer to case i / M. All contenders answer a case before the next case begins, so they share the truth
// computed for it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "certify/campaign/cases.hpp"

namespace graze::tool {

// A method of a third-party engine, as a state records it. A summary may be made where the engine is not
// installed.
struct OtherContender {
  std::string method;    // by question_name()
  std::string query;     // the query it answers, "cast" for casts
  std::string version;   // version of the engine
  double stall_cap = 0;  // the fraction of a family that may be not_converged
  std::string held_to;   // in words
  friend bool operator==(const OtherContender&, const OtherContender&) = default;
};

// The settings that determine the result.
struct PartSettings {
  std::string kind;                   // "casts", "queries", "rotating"
  std::vector<std::string> methods;   // "exact/double", by name() of a contender
  std::vector<std::string> families;  // those asked, in the order of the table
  std::uint64_t count = 0;            // answers
  std::uint64_t oracle_every = 0;     // 0: no sample
  std::uint64_t judge_every = 1;
  std::vector<OtherContender> others = {};  // the methods that belong to third-party engines
  friend bool operator==(const PartSettings&, const PartSettings&) = default;
};

struct CampaignSettings {
  std::vector<PartSettings> parts;
  std::uint64_t seed = 1;
  std::uint64_t block = 0;  // answers
  // Hash of cases of every level and of our answers to them. A build that generates other cases, or answers
  // them differently, has another hash. Third-party engines are not asked for it.
  std::string fingerprint;

  [[nodiscard]] std::uint64_t casts() const;
  [[nodiscard]] std::uint64_t blocks() const { return casts() / block + (casts() % block != 0 ? 1 : 0); }
  friend bool operator==(const CampaignSettings&, const CampaignSettings&) = default;
};

// The first field that differs, such as "seed is 2 here and 1 there". Empty if none differs.
[[nodiscard]] std::string difference(const CampaignSettings& here, const CampaignSettings& there);

// Counts are kept for each cell: a level of a family, asked of a contender.
struct Cell {
  std::string method, family;
  double level = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

class CampaignPlan {
 public:
  struct Part {
    CampaignCases cases;
    std::uint64_t count = 0;
    Sampling sampling;
    std::uint64_t first = 0;     // answer of the campaign
    std::size_t first_cell = 0;  // by slot, then by contender
  };
  struct Place {
    const Part* part = nullptr;
    std::uint64_t number = 0;  // number of the case
    std::size_t contender = 0;

    [[nodiscard]] std::size_t cell(const DrawnCase& drawn) const {
      return part->first_cell + drawn.slot * part->cases.contenders().size() + contender;
    }
  };

  explicit CampaignPlan(std::uint64_t seed) : seed_(seed) {}
  // Versions of third-party engines, by the question_name() of their methods. A campaign with another version
  // is a different campaign.
  void set_versions(std::map<std::string, std::string> versions) { versions_ = std::move(versions); }
  // `count` answers. Families without a question are left out.
  void add(const std::vector<const corpus::Family*>& families, Contenders contenders, std::uint64_t count,
           const Sampling& sampling);
  // As many that each contender is asked `each` cases of each family.
  void add_per_family(const std::vector<const corpus::Family*>& families, Contenders contenders,
                      std::uint64_t each, const Sampling& sampling);

  [[nodiscard]] Place place(std::uint64_t index) const;
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] std::vector<std::string> left_out() const;
  [[nodiscard]] CampaignSettings settings(std::uint64_t block) const;

 private:
  std::uint64_t seed_;
  std::map<std::string, std::string> versions_;
  std::vector<Part> parts_;
  std::vector<Cell> cells_;
};

}  // namespace graze::tool
