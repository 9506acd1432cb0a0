// The cases of a part of a campaign: number i is a pure function of the seed, i and the families that are
// asked.
//
// Families in turn, and the levels of each in turn. Only what is a question for every contender is drawn. A
// level is left out if fewer than 1 in kRareQuestion of a sample of it are questions; elsewhere case i is the
// first question among the cases that the generator of i draws.
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

// Which answers are judged, and how: a pure function of the seed and the case's number.
struct Sampling {
  std::uint64_t oracle_every = 0;  // the oracle measures one case in so many besides; 0 for none
  std::uint64_t judge_every = 1;   // of other cases than one in so many the outcomes are counted
};

struct DrawnCase {
  corpus::Case problem = {};
  std::size_t slot = 0;     // index into CampaignCases::slots()
  std::uint64_t seed = 0;   // of the generator: problem = family->generate(level, seed)
  bool sampled = false;     // the oracle measures it, whatever its proof says
  bool judged = true;       // if not, its outcomes are counted, and only what is no answer is judged
  bool is_question = true;  // false if kAttempts cases were none; never seen
};

class CampaignCases {
 public:
  static constexpr int kSample = 64;         // cases of a level that decide whether it is asked
  static constexpr int kRareQuestion = 4;    // asked if 1 in so many is a question
  static constexpr int kAttempts = 1 << 12;  // at 1 in 8, all of them fail once in 10^237

  // Of engines of others alone: asked if one of so many is a question, and then looked for among so many; where none is
  // found, the case is counted as not asked.
  static constexpr int kRareSample = 1 << 10, kRareAttempts = 1 << 14;

  // The contenders are of one kind, each of which has its own stream of seeds.
  CampaignCases(const std::vector<const corpus::Family*>& families, Contenders contenders, std::uint64_t seed,
                const Sampling& sampling);

  [[nodiscard]] DrawnCase draw(std::uint64_t index) const;
  [[nodiscard]] const Contenders& contenders() const { return contenders_; }
  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }
  // Of those that are asked, in the order of the table.
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
  std::vector<std::size_t> first_;  // of each family asked, its first slot; and the end
  std::vector<std::string> left_out_;
};

}  // namespace graze::tool
