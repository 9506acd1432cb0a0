#include "certify/campaign/campaign_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
  most_supports = std::max(most_supports, other.most_supports);
  return *this;
}

std::string Finding::id() const { return fmt::format("{}/h{}/s{}", family, level, seed); }

void CampaignTally::add(std::uint64_t index, std::size_t cell, const engine::Method& contender,
                        const DrawnCase& drawn, const CampaignCast& cast) {
  CampaignCounts& count = counts[cell];
  const law::Judgement& judgement = cast.judgement;
  if (judgement.skipped) return add_skipped(cell);
  ++count.casts;
  if (judgement.failed.empty()) switch (cast.answer.outcome) {
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
  const auto one_if = [](bool is_so) { return static_cast<std::uint64_t>(is_so); };
  count.proved += one_if(judgement.proof == law::ProofState::accepted);
  count.by_oracle += one_if(judgement.by_oracle);
  count.sampled += one_if(judgement.by_oracle && drawn.sampled);
  count.undecided += one_if(!cast.undecided.empty());
  count.within_tolerance += one_if(judgement.within_tolerance);
  count.widest = std::fmax(count.widest, judgement.errors.over_limit);
  count.most_supports = std::max(count.most_supports, static_cast<std::uint64_t>(judgement.supports));
  if (judgement.faulty()) {
    using J = law::Judgement;
    const auto why = law::kFaultKinds[judgement.worst_fault()].why;
    for (const auto& [kind, field] : {std::pair{&J::wrong, &CampaignCounts::wrong},
                                      {&J::late, &CampaignCounts::late},
                                      {&J::early, &CampaignCounts::off},
                                      {&J::off, &CampaignCounts::off},
                                      {&J::bad_contact, &CampaignCounts::contact_off},
                                      {&J::false_proof, &CampaignCounts::proofs_refused},
                                      {&J::unproved, &CampaignCounts::unproved},
                                      {&J::work, &CampaignCounts::work},
                                      {&J::failed, &CampaignCounts::failed}}) {
      count.*field += one_if(kind == why);
    }
  }
  digest += answer_hash(index, cast.answer);
  const auto note = [&](std::vector<Finding>& findings, std::string reason) {
    merge_findings(findings, {{.index = index,
                               .method = contender.question_name(),
                               .family = drawn.problem.family,
                               .level = drawn.problem.hardness.value_or(0),
                               .seed = drawn.seed,
                               .reason = std::move(reason)}});
  };
  if (judgement.faulty()) ++count.faults, note(faults, cast.reason());
  if (judgement.stalled) ++count.stalls, note(stalls, cast.reason());
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
