#include "properties/laws/law_tally.hpp"

#include <algorithm>

#include "engines/guarantees.hpp"
#include "properties/laws/reach.hpp"

namespace graze::law {

namespace {

bool has(const LawResult& result, std::string_view label) {
  return std::find(result.labels.begin(), result.labels.end(), label) != result.labels.end();
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void LawTally::add(std::size_t method, std::string_view family, const LawResult& result) {
  for (const std::string_view label : result.labels) ++labels_[std::string(label)];
  switch (result.holding) {
    case Holding::not_applicable:
      ++not_applicable_;
      left_open_ += has(result, "undecided");
      return;
    case Holding::broken:
      ++broken_;
      break;
    case Holding::holds:
      break;
  }
  ++applied_;
  ++applied_to_[method];
  if (!family.empty()) families_.emplace(family);
  stalled_[method] += has(result, "not_converged");
}

void LawTally::add(const LawTally& other) {
  applied_ += other.applied_;
  not_applicable_ += other.not_applicable_;
  left_open_ += other.left_open_;
  broken_ += other.broken_;
  for (const auto& [label, count] : other.labels_) labels_[label] += count;
  families_.insert(other.families_.begin(), other.families_.end());
  for (std::size_t m = 0; m < applied_to_.size(); ++m) {
    applied_to_[m] += other.applied_to_[m];
    stalled_[m] += other.stalled_[m];
  }
}

std::size_t LawTally::count(const std::string& label) const {
  const auto found = labels_.find(label);
  return found == labels_.end() ? 0 : found->second;
}

bool LawTally::saw(std::string_view outcome) const {
  if (outcome == kContact) return count("hit") + count("initially_overlapping") > 0;
  return count(std::string(outcome)) > 0;
}

std::string LawTally::shortfall_of_outcomes() const {
  if (applied_ == 0) return law_ + " never applied";
  std::vector<std::string> lacking;
  for (const std::string_view outcome : outcomes_to_see(kind_, law_)) {
    if (!saw(outcome)) lacking.emplace_back(outcome);
  }
  return lacking.empty() ? "" : law_ + " saw no " + listed(lacking);
}

std::string LawTally::shortfall_of_families() const {
  std::vector<std::string> lacking, beyond;
  for (const corpus::Family& family : families_of(kind_)) {
    std::string name(family.name);
    if (must_reach(law_, family.name) == reached(name)) continue;
    (reached(name) ? beyond : lacking).push_back(std::move(name));
  }
  if (!lacking.empty()) {
    return law_ + " never applied to a case of " + listed(lacking) +
           "; where it cannot, properties/laws/reach.cpp says so";
  }
  if (!beyond.empty()) {
    return law_ + " applied to " + listed(beyond) + ", which properties/laws/reach.cpp has out of its reach";
  }
  return "";
}

std::string LawTally::excess_of_stalls() const {
  if (kind_ != Kind::linear) return "";
  for (std::size_t m = 0; m < stalled_.size(); ++m) {
    const engine::Method& method = engine::methods(engine::Kind::linear)[m];
    // The law certified_decides limits the verdicts that tier certified may leave open.
    if (stalled_[m] == 0 || method.is_certified()) continue;
    const engine::Guarantee* row = method.guarantee;
    // A run too short to compare a fraction with its cap may have one answer that did not converge.
    const double allowed = row != nullptr && row->stall_cap > 0
                               ? std::max(1.0, row->stall_cap * static_cast<double>(applied_to_[m]))
                               : 0;
    if (static_cast<double>(stalled_[m]) > allowed) {
      return law_ + ": " + method.full_name() + " did not converge " + std::to_string(stalled_[m]) +
             " times in " + std::to_string(applied_to_[m]);
    }
  }
  return "";
}

std::string LawTally::text() const {
  std::string text = law_ + ":";
  for (const auto& [label, count] : labels_) text += "  " + label + " " + std::to_string(count);
  if (not_applicable_ > 0) text += "  not applicable " + std::to_string(not_applicable_);
  return text;
}

}  // namespace graze::law
