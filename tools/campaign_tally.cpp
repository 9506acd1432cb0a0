#include "tools/campaign_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "corpus/random.hpp"

namespace graze::tool {
namespace {

void merge_findings(std::vector<Finding>& mine, const std::vector<Finding>& other) {
  if (other.empty()) return;
  const auto middle = static_cast<std::ptrdiff_t>(mine.size());
  mine.insert(mine.end(), other.begin(), other.end());
  std::inplace_merge(mine.begin(), mine.begin() + middle, mine.end(),
                     [](const Finding& l, const Finding& r) { return l.index < r.index; });
  if (mine.size() > CampaignTally::kFindings) mine.resize(CampaignTally::kFindings);
}

std::string reason_of(const Judgement& judgement) {
  for (const std::string* why :
       {&judgement.wrong, &judgement.late, &judgement.off, &judgement.bad_contact, &judgement.false_proof}) {
    if (!why->empty()) return *why;
  }
  return "did not converge";
}

}  // namespace

CampaignCounts& CampaignCounts::operator+=(const CampaignCounts& other) {
  for (const CountField& field : kCountFields) this->*field.value += other.*field.value;
  return *this;
}

std::string Finding::id() const { return fmt::format("{}/h{}/s{}", family, level, seed); }

std::uint64_t answer_hash(std::uint64_t index, const engine::Answer& answer) {
  // A NaN has many patterns of bits and is one answer.
  const auto bits = [](double t) { return t == t ? std::bit_cast<std::uint64_t>(t) : ~std::uint64_t{0}; };
  std::uint64_t hash = corpus::Random(index).bits();
  for (const std::uint64_t word :
       {static_cast<std::uint64_t>(answer.outcome), bits(answer.toi_lower), bits(answer.toi_upper)}) {
    hash = corpus::Random(hash ^ word).bits();
  }
  return hash;
}

void CampaignTally::add(std::uint64_t index, const DrawnCase& drawn, const CampaignCast& cast) {
  CampaignCounts& count = counts[drawn.slot];
  const Judgement& judgement = cast.judgement;
  ++count.casts;
  switch (cast.answer.outcome) {
    case Outcome::initially_overlapping:
      ++count.overlapping;
      break;
    case Outcome::hit:
      ++count.hits;
      break;
    case Outcome::miss:
      ++count.misses;
      break;
    case Outcome::not_converged:
      ++count.not_converged;
      break;
    case Outcome::invalid_input:
      ++count.refused;
      break;
  }
  if (judgement.proof == ProofState::accepted) ++count.proved;
  if (judgement.by_oracle) ++count.by_oracle;
  if (judgement.by_oracle && drawn.sampled) ++count.sampled;
  if (judgement.excused) ++count.excused;
  digest += answer_hash(index, cast.answer);
  if (!judgement.faulty() && !judgement.stalled) return;
  // Of tier exact a stall is a fault; it is counted once.
  ++(judgement.faulty() ? count.faults : count.stalls);
  const Finding finding{.index = index,
                        .family = drawn.problem.family,
                        .level = drawn.problem.hardness.value_or(0),
                        .seed = drawn.seed,
                        .reason = reason_of(judgement)};
  merge_findings(judgement.faulty() ? faults : stalls, {finding});
}

void CampaignTally::merge(const CampaignTally& other) {
  for (std::size_t slot = 0; slot < counts.size(); ++slot) counts[slot] += other.counts[slot];
  digest += other.digest;
  merge_findings(faults, other.faults);
  merge_findings(stalls, other.stalls);
}

CampaignCounts CampaignTally::total() const {
  CampaignCounts sum;
  for (const CampaignCounts& count : counts) sum += count;
  return sum;
}

}  // namespace graze::tool
