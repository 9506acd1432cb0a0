#include "certify/campaign/cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "corpus/random.hpp"

namespace graze::tool {

namespace {

// Each kind has a word of the seed's own stream.
std::uint64_t key_of(std::uint64_t seed, engine::Kind kind) {
  corpus::Random words(seed);
  for (int i = 0; i < static_cast<int>(kind); ++i) words.bits();
  return words.bits();
}

}  // namespace

CampaignCases::CampaignCases(const std::vector<const corpus::Family*>& families, Contenders contenders,
                             std::uint64_t seed, const Sampling& sampling)
    : contenders_(std::move(contenders)), key_(key_of(seed, contenders_.at(0)->kind)), sampling_(sampling) {
  has_ours_ = std::any_of(contenders_.begin(), contenders_.end(),
                          [](const engine::Method* one) { return one->is_ours(); });
  for (const corpus::Family* family : families) {
    const std::size_t first = slots_.size();
    std::string levels;
    for (const double level : family->levels) {
      const Slot slot{.family = family, .level = level};
      if (is_asked(slot)) {
        slots_.push_back(slot);
      } else {
        levels += fmt::format(" h{}", level);
      }
    }
    const std::string name(family->name);
    if (slots_.size() == first) {
      left_out_.push_back(name);
    } else if (!levels.empty()) {
      left_out_.push_back(name + levels);
    }
    if (slots_.size() > first) first_.push_back(first);
  }
  first_.push_back(slots_.size());
}

std::vector<std::string> CampaignCases::families() const {
  std::vector<std::string> names;
  for (const Slot& slot : slots_) {
    if (names.empty() || names.back() != slot.family->name) names.emplace_back(slot.family->name);
  }
  return names;
}

bool CampaignCases::is_asked(const Slot& slot) const {
  const auto is_one = [&](std::uint64_t seed) {
    return is_question(contenders_, slot.family->generate(slot.level, seed));
  };
  if (!has_ours_) {
    // An engine that knows few shapes is asked about those.
    for (std::uint64_t seed = 0; seed < kRareSample; ++seed) {
      if (is_one(seed)) return true;
    }
    return false;
  }
  int questions = 0;
  for (std::uint64_t seed = 0; seed < kSample; ++seed) questions += is_one(seed) ? 1 : 0;
  return questions * kRareQuestion >= kSample;
}

DrawnCase CampaignCases::draw(std::uint64_t index) const {
  const std::size_t families = first_.size() - 1, family = index % families;
  const std::size_t levels = first_[family + 1] - first_[family];
  DrawnCase drawn{.slot = first_[family] + (index / families) % levels};
  const Slot& slot = slots_[drawn.slot];
  // The generator's seeding mixes keys that are neighbours.
  corpus::Random random(key_ + index);
  drawn.sampled = sampling_.oracle_every > 0 && random.once_in(sampling_.oracle_every);
  // A separate generator, so that the cases do not depend on which of them are judged.
  if (sampling_.judge_every > 1)
    drawn.judged = corpus::Random(~(key_ + index)).once_in(sampling_.judge_every);
  for (int attempt = 0; attempt < (has_ours_ ? kAttempts : kRareAttempts); ++attempt) {
    drawn.seed = random.bits();
    drawn.problem = slot.family->generate(slot.level, drawn.seed);
    if (is_question(contenders_, drawn.problem)) return drawn;
  }
  drawn.is_question = false;
  return drawn;
}

}  // namespace graze::tool
