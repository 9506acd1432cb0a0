#include "certify/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace graze::tool {

void Tally::Worst::take(double candidate, const corpus::Case& problem) {
  if (std::isnan(candidate) || candidate <= value) return;
  value = candidate;
  id = problem.id;
  hardness = problem.hardness;
}

void Tally::Worst::take(const Worst& other) {
  if (!std::isnan(other.value) && !(other.value <= value)) *this = other;
}

void Tally::add(const corpus::Case& problem, const law::Judgement& judgement) {
  if (judgement.skipped && judgement.wrong.empty()) {
    ++(judgement.declined ? declined : skipped);
    return;
  }
  ++cases;
  const auto example = [&](const std::string& why) {
    return Example{.id = problem.id, .reason = why, .problem = method->is_ours() ? corpus::Case{} : problem};
  };
  if (judgement.failure != engine::Failure::none) {
    Failed& failed = failures[static_cast<std::size_t>(judgement.failure)];
    if (failed.count++ == 0) failed.first = example(judgement.failed);
  }
  if (judgement.faulty()) {
    ++at_fault;
    const std::size_t worst = judgement.worst_fault();
    if (faults[worst]++ == 0) first[worst] = example(judgement.told_fault());
  }
  if (judgement.stalled && stalled++ == 0) first_stalled = {.id = problem.id, .reason = judgement.undecided};
  const bool is_open = judgement.stalled || judgement.outcome == Outcome::not_converged;
  if (is_open && left_open++ == 0) first_open = {.id = problem.id};
  within_tolerance += judgement.within_tolerance ? 1 : 0;
  hidden += judgement.hidden ? 1 : 0;
  open += judgement.open ? 1 : 0;
  accepted += judgement.proof == law::ProofState::accepted ? 1 : 0;
  refused += judgement.proof == law::ProofState::refused ? 1 : 0;
  unproved += judgement.proof == law::ProofState::none ? 1 : 0;
  supports.push_back(judgement.supports);
  most_supports.take(judgement.supports, problem);
  if (!judgement.by_oracle) return;
  ++by_oracle;
  const law::Errors& errors = judgement.errors;
  forward.push_back(errors.forward);
  backward.push_back(errors.backward);
  normal.push_back(errors.normal);
  witness.push_back(errors.witness);
  width.take(errors.backward, problem);
  passed.take(errors.passed, problem);
  over_limit.take(errors.over_limit, problem);
  const double least = std::fmax(errors.backward, errors.passed);
  least_relative.take(least, problem);
  least_length.take(least * errors.scale, problem);
}

void Tally::add(const Tally& other) {
  cases += other.cases;
  skipped += other.skipped;
  declined += other.declined;
  at_fault += other.at_fault;
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    if (faults[k] == 0) first[k] = other.first[k];
    faults[k] += other.faults[k];
  }
  if (stalled == 0) first_stalled = other.first_stalled;
  stalled += other.stalled;
  if (left_open == 0) first_open = other.first_open;
  left_open += other.left_open;
  within_tolerance += other.within_tolerance;
  hidden += other.hidden;
  open += other.open;
  accepted += other.accepted;
  refused += other.refused;
  unproved += other.unproved;
  by_oracle += other.by_oracle;
  for (std::vector<double> Tally::*values :
       {&Tally::forward, &Tally::backward, &Tally::normal, &Tally::witness, &Tally::true_backward, &Tally::ns,
        &Tally::supports}) {
    (this->*values).insert((this->*values).end(), (other.*values).begin(), (other.*values).end());
  }
  width.take(other.width);
  passed.take(other.passed);
  over_limit.take(other.over_limit);
  most_supports.take(other.most_supports);
  least_relative.take(other.least_relative);
  least_length.take(other.least_length);
  for (std::size_t k = 0; k < failures.size(); ++k) {
    if (failures[k].count == 0) failures[k].first = other.failures[k].first;
    failures[k].count += other.failures[k].count;
  }
}

std::string declines(const Tally& total) {
  const auto questions = static_cast<double>(total.cases + total.declined);
  const auto part = static_cast<double>(total.declined) / std::max(questions, 1.0);
  if (!(part > kMostDeclined)) return {};
  return fmt::format("{} declines {} of {} questions ({:.0f} %)", total.method->question_name(),
                     total.declined, total.cases + total.declined, 100 * part);
}

bool is_made_of_ties(const std::string& family) {
  // Each has a level at which touching, or a pass by less than the width, is the question.
  constexpr std::array<std::string_view, 18> kFamilies = {"touching",         "sliding",
                                                          "target_margin",    "scaled_scene",
                                                          "smooth_graze",     "mixed_magnitudes",
                                                          "spinning_graze",   "pure_spin",
                                                          "long_arms",        "swung_balls",
                                                          "at_rest",          "wheels",
                                                          "level_tiles",      "rolling",
                                                          "sliding_on_tiles", "flat_plates_turning",
                                                          "smooth_depths",    "rays"};
  return std::find(kFamilies.begin(), kFamilies.end(), family) != kFamilies.end();
}

bool is_above_open_cap(const Tally& tally) {
  const engine::Guarantee* row = tally.method->guarantee;
  if (row == nullptr || !row->open_cap || !tally.is_drawn) return false;
  const double cap = is_made_of_ties(tally.family) ? kOpenOfTies : *row->open_cap;
  return static_cast<double>(tally.left_open) > std::max(1.0, cap * static_cast<double>(tally.cases));
}

bool is_above_stall_cap(const Tally& tally) {
  const engine::Guarantee* row = tally.method->guarantee;
  return row != nullptr &&
         static_cast<double>(tally.stalled) > row->stall_cap * static_cast<double>(tally.cases);
}

std::vector<std::string> breaches(const Tally& tally) {
  std::vector<std::string> lines;
  const engine::Guarantee* row = tally.method->guarantee;
  if (row == nullptr) return lines;
  const auto line = [&](std::size_t count, const std::string& what, const Tally::Example& first) {
    if (count == 0) return;
    lines.push_back(fmt::format("{}, {}: {} {} of {}; the first is {}{}{}", row->name(), tally.family, count,
                                what, tally.cases, first.id, first.reason.empty() ? "" : ": ", first.reason));
  };
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    line(tally.faults[k], law::kFaultKinds[k].sentence, tally.first[k]);
  }
  if (is_above_open_cap(tally)) {
    line(tally.left_open,
         fmt::format("open, ties included, above the cap of {},",
                     is_made_of_ties(tally.family) ? kOpenOfTies : *row->open_cap),
         tally.first_open);
  }
  if (is_above_stall_cap(tally)) {
    line(tally.stalled, fmt::format("not converged, above the cap of {},", row->stall_cap),
         tally.first_stalled);
  }
  return lines;
}

}  // namespace graze::tool
