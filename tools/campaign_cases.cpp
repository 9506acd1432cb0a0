#include "tools/campaign_cases.hpp"

#include <fmt/format.h>

#include "corpus/random.hpp"

namespace graze::tool {

CampaignCases::CampaignCases(const std::vector<const corpus::Family*>& families,
                             const engine::EngineMethod& method, std::uint64_t seed,
                             std::uint64_t oracle_every)
    : method_(&method), key_(corpus::Random(seed).bits()), oracle_every_(oracle_every) {
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

bool CampaignCases::is_question(const corpus::Case& problem) const {
  if (!method_->is_exact()) return engine::unsupported(problem).empty();
  // In double a case is seen as it is.
  return method_->scalar == "double" ? engine::is_exact_question(problem)
                                     : engine::is_exact_question(method_->seen(problem));
}

bool CampaignCases::is_asked(const Slot& slot) const {
  int questions = 0;
  for (std::uint64_t seed = 0; seed < kSample; ++seed) {
    if (is_question(slot.family->generate(slot.level, seed))) ++questions;
  }
  return questions * kRareQuestion >= kSample;
}

DrawnCase CampaignCases::draw(std::uint64_t index) const {
  const std::size_t families = first_.size() - 1, family = index % families;
  const std::size_t levels = first_[family + 1] - first_[family];
  DrawnCase drawn{.slot = first_[family] + (index / families) % levels};
  const Slot& slot = slots_[drawn.slot];
  // The generator's seeding mixes keys that are neighbours.
  corpus::Random random(key_ + index);
  drawn.sampled = oracle_every_ > 0 && random.once_in(oracle_every_);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    drawn.seed = random.bits();
    drawn.problem = slot.family->generate(slot.level, drawn.seed);
    if (is_question(drawn.problem)) return drawn;
  }
  drawn.is_question = false;
  return drawn;
}

}  // namespace graze::tool
