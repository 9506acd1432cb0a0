#include "certify/campaign/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace graze::tool {
namespace {

void merge_findings(std::vector<Finding>& mine, const std::vector<Finding>& other) {
  if (other.empty()) return;
  const auto middle = static_cast<std::ptrdiff_t>(mine.size());
  mine.insert(mine.end(), other.begin(), other.end());
  std::inplace_merge(mine.begin(), mine.begin() + middle, mine.end(),
                     [](const Finding& l, const Finding& r) { return l.index < r.index; });
  if (mine.size() <= CampaignTally::kFindings) return;
  std::map<std::pair<std::string, std::string>, std::size_t> seen;
  std::vector<Finding> kept;
  for (Finding& finding : mine) {
    if (++seen[{finding.method, finding.family}] <= CampaignTally::kFindings)
      kept.push_back(std::move(finding));
  }
  mine = std::move(kept);
}

}  // namespace

CampaignCounts& CampaignCounts::operator+=(const CampaignCounts& other) {
  for (const CountField& field : kCountFields) this->*field.value += other.*field.value;
  widest = std::max(widest, other.widest);
  return *this;
}

std::string Finding::id() const { return fmt::format("{}/h{}/s{}", family, level, seed); }

void CampaignTally::add(std::uint64_t index, std::size_t cell, const Contender& contender,
                        const DrawnCase& drawn, const CampaignCast& cast) {
  CampaignCounts& count = counts[cell];
  if (cast.not_asked) return add_not_asked(cell);
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
  if (cast.proof == ProofState::accepted) ++count.proved;
  if (cast.by_oracle) ++count.by_oracle;
  if (cast.by_oracle && drawn.sampled) ++count.sampled;
  if (!cast.undecided.empty()) ++count.undecided;
  if (cast.excused) ++count.excused;
  count.widest = std::fmax(count.widest, cast.widest);
  constexpr std::array kByFault = {
      &CampaignCounts::wrong,       &CampaignCounts::late,           &CampaignCounts::off,
      &CampaignCounts::contact_off, &CampaignCounts::proofs_refused, &CampaignCounts::unproved};
  static_assert(kByFault.size() == kFaults);
  for (std::size_t i = 0; i < kFaults; ++i) count.*kByFault[i] += cast.faults[i].empty() ? 0 : 1;
  digest += answer_hash(index, cast.answer);
  const auto note = [&](std::vector<Finding>& findings, std::string reason) {
    merge_findings(findings, {{.index = index,
                               .method = contender.name(),
                               .family = drawn.problem.family,
                               .level = drawn.problem.hardness.value_or(0),
                               .seed = drawn.seed,
                               .reason = std::move(reason)}});
  };
  if (cast.faulty()) ++count.faults, note(faults, cast.reason());
  if (cast.stalled) ++count.stalls, note(stalls, cast.reason());
  if (!cast.undecided.empty()) note(undecided, cast.undecided);
}

void CampaignTally::merge(const CampaignTally& other) {
  for (std::size_t cell = 0; cell < counts.size(); ++cell) counts[cell] += other.counts[cell];
  digest += other.digest;
  merge_findings(faults, other.faults);
  merge_findings(stalls, other.stalls);
  merge_findings(undecided, other.undecided);
}

CampaignCounts CampaignTally::total() const {
  CampaignCounts sum;
  for (const CampaignCounts& count : counts) sum += count;
  return sum;
}

}  // namespace graze::tool
