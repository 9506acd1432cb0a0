#include "certify/campaign/campaign_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "certify/campaign/campaign_cast.hpp"
#include "certify/engine_report.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "corpus/random.hpp"

namespace graze::tool {
namespace {

// The number of cases per level in the fingerprint, for linear casts, which take microseconds. Other kinds
// have one.
constexpr std::uint64_t kFingerprintCases = 4;

std::string list(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ",")); }

std::string difference(const PartSettings& here, const PartSettings& there) {
  const auto say = [](const std::string& field, const auto& l, const auto& r) {
    return fmt::format("{} is {} here and {} there", field, l, r);
  };
  if (here.kind != there.kind) return say("the kind of a part", here.kind, there.kind);
  if (here.methods != there.methods)
    return say("the list of methods", list(here.methods), list(there.methods));
  if (here.count != there.count) return say("the number of " + here.kind, here.count, there.count);
  if (here.oracle_every != there.oracle_every)
    return say("oracle-every", here.oracle_every, there.oracle_every);
  if (here.judge_every != there.judge_every) return say("judge-every", here.judge_every, there.judge_every);
  if (here.others != there.others) return "the third-party engines are not the same, or their bounds differ";
  if (here.families != there.families)
    return say("the list of families", list(here.families), list(there.families));
  return {};
}

std::string fingerprint(const CampaignPlan& plan) {
  std::uint64_t sum = 0, number = 0;
  for (const CampaignPlan::Part& part : plan.parts()) {
    const bool fast = part.cases.contenders()[0]->kind == engine::Kind::linear;
    for (const Slot& slot : part.cases.slots()) {
      for (std::uint64_t seed = 0; seed < (fast ? kFingerprintCases : 1); ++seed) {
        const DrawnCase drawn{.problem = slot.family->generate(slot.level, seed), .seed = seed};
        const std::uint64_t text = corpus::fnv1a(corpus::write_case(drawn.problem));
        for (const engine::Method* contender : part.cases.contenders())
          sum += contender->is_ours() ? answer_hash(text + number++, *contender, drawn)
                                      : corpus::Random(text + number++).bits();
      }
    }
  }
  return fmt::format("{:016x}", sum);
}

}  // namespace

std::uint64_t CampaignSettings::casts() const {
  std::uint64_t sum = 0;
  for (const PartSettings& part : parts) sum += part.count;
  return sum;
}

std::string difference(const CampaignSettings& here, const CampaignSettings& there) {
  const auto say = [](const char* field, const auto& l, const auto& r) {
    return fmt::format("{} is {} here and {} there", field, l, r);
  };
  if (here.parts.size() != there.parts.size())
    return say("the number of parts", here.parts.size(), there.parts.size());
  for (std::size_t i = 0; i < here.parts.size(); ++i) {
    if (std::string what = difference(here.parts[i], there.parts[i]); !what.empty()) return what;
  }
  if (here.seed != there.seed) return say("the seed", here.seed, there.seed);
  if (here.block != there.block) return say("the block", here.block, there.block);
  if (here.fingerprint != there.fingerprint)
    return "they were made by builds whose cases or answers are not the same";
  return {};
}

void CampaignPlan::add(const std::vector<const corpus::Family*>& families, Contenders contenders,
                       std::uint64_t count, const Sampling& sampling) {
  Part part{.cases = CampaignCases(families, std::move(contenders), seed_, sampling),
            .count = count,
            .sampling = sampling,
            .first = parts_.empty() ? 0 : parts_.back().first + parts_.back().count,
            .first_cell = cells_.size()};
  if (part.cases.slots().empty()) {
    throw std::runtime_error(
        fmt::format("--family: hardly a case of these is a question for {}; name another family, or a method "
                    "of another tier",
                    part.cases.contenders()[0]->question_name()));
  }
  for (const Slot& slot : part.cases.slots()) {
    for (const engine::Method* contender : part.cases.contenders())
      cells_.push_back({contender->question_name(), std::string(slot.family->name), slot.level});
  }
  parts_.push_back(std::move(part));
}

void CampaignPlan::add_per_family(const std::vector<const corpus::Family*>& families, Contenders contenders,
                                  std::uint64_t each, const Sampling& sampling) {
  const std::uint64_t methods = contenders.size();
  add(families, std::move(contenders), 0, sampling);
  parts_.back().count = each * methods * parts_.back().cases.families().size();
}

CampaignPlan::Place CampaignPlan::place(std::uint64_t index) const {
  const auto after = std::upper_bound(parts_.begin(), parts_.end(), index,
                                      [](std::uint64_t i, const Part& part) { return i < part.first; });
  const Part& part = *std::prev(after);
  const std::uint64_t contenders = part.cases.contenders().size();
  return {.part = &part,
          .number = (index - part.first) / contenders,
          .contender = static_cast<std::size_t>((index - part.first) % contenders)};
}

std::vector<std::string> CampaignPlan::left_out() const {
  std::vector<std::string> all;
  for (const Part& part : parts_) {
    for (const std::string& name : part.cases.left_out()) {
      const engine::Kind kind = part.cases.contenders()[0]->kind;
      all.push_back(parts_.size() == 1 ? name : fmt::format("{} ({})", name, part_name(kind)));
    }
  }
  return all;
}

CampaignSettings CampaignPlan::settings(std::uint64_t block) const {
  CampaignSettings settings{.parts = {}, .seed = seed_, .block = block, .fingerprint = fingerprint(*this)};
  for (const Part& part : parts_) {
    PartSettings& one = settings.parts.emplace_back();
    one.kind = part_name(part.cases.contenders()[0]->kind);
    for (const engine::Method* contender : part.cases.contenders()) {
      one.methods.push_back(contender->question_name());
      if (contender->is_ours()) continue;
      one.others.push_back(
          {.method = one.methods.back(),
           .query = std::string(corpus::name_of(contender->query)),
           .version = versions_.contains(one.methods.back()) ? versions_.at(one.methods.back()) : "",
           .stall_cap = contender->guarantee->stall_cap,
           .held_to = limit_text(*contender->guarantee)});
    }
    one.families = part.cases.families();
    one.count = part.count;
    one.oracle_every = part.sampling.oracle_every;
    one.judge_every = part.sampling.judge_every;
  }
  return settings;
}

}  // namespace graze::tool
