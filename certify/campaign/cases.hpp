// The cases of a part of a campaign: number i is a pure function of the seed, i and the families that are
// asked.
//
// The families take turns, and so do the levels of each family. Every drawn case is a question for every contender. A
// level is left out if fewer than 1 in kRareQuestion of a sample of it are questions. Otherwise case i is the first
// question among the cases that generator i draws.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "certify/campaign/contender.hpp"
#include "corpus/families.hpp"

namespace graze::tool {

// One level of one family.
struct Slot {
  const corpus::Family* family = nullptr;
  double level = 0;
};

// The choice of answers to judge, and how. It is a pure function of the seed and the case's number.
struct Sampling {
  std::uint64_t oracle_every = 0;  // the oracle also measures one case in so many, 0 for none
  std::uint64_t judge_every = 1;   // one case in so many is judged, the outcomes of the others are counted
};

struct DrawnCase {
  corpus::Case problem = {};
  std::size_t slot = 0;     // index into CampaignCases::slots()
  std::uint64_t seed = 0;   // seed of the generator: problem = family->generate(level, seed)
  bool sampled = false;     // the oracle measures it, whether or not it has a proof
  bool judged = true;       // if false, outcomes are counted and only invalid answers are judged
  bool is_question = true;  // false if no case in kAttempts was a question, never observed
};

class CampaignCases {
 public:
  static constexpr int kSample = 64;         // cases of a level that decide whether it is asked
  static constexpr int kRareQuestion = 4;    // asked if 1 case in this number is a question
  static constexpr int kAttempts = 1 << 12;  // at 1 in 8, all of them fail once in 10^237

  // For third-party engines alone. A level is asked if one case in kRareSample is a question, and up to kRareAttempts
  // cases are drawn to find one. If none is found, the case is counted as not asked.
  static constexpr int kRareSample = 1 << 10, kRareAttempts = 1 << 14;

  // The contenders are of one kind, each of which has its own stream of seeds.
  CampaignCases(const std::vector<const corpus::Family*>& families, Contenders contenders, std::uint64_t seed,
                const Sampling& sampling);

  [[nodiscard]] DrawnCase draw(std::uint64_t index) const;
  [[nodiscard]] const Contenders& contenders() const { return contenders_; }
  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }
  // The families that are asked, in the order of the table.
  [[nodiscard]] std::vector<std::string> families() const;
  // The levels left out, a family each: "curved", if it is all of them, or "combinators h4 h5".
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  [[nodiscard]] bool is_asked(const Slot& slot) const;

  Contenders contenders_;
  std::uint64_t key_;
  Sampling sampling_;
  bool has_ours_ = true;
  std::vector<Slot> slots_;         // by family, then by level
  std::vector<std::size_t> first_;  // first slot of each family asked, then the end
  std::vector<std::string> left_out_;
};

}  // namespace graze::tool
