// Certification of the rotating casts: each method on the rotating cases, by the bracket oracle and by
// proofs.
#pragma once

#include "certify/linear.hpp"
#include "properties/judge/rotating_answer.hpp"

namespace graze::tool {

// One method on one family.
struct RotatingTally {
  const engine::RotatingEngineMethod* method = nullptr;
  std::string family;
  std::size_t cases = 0, not_asked = 0;
  std::size_t wrong = 0, late = 0, early = 0, wide = 0, bad_contact = 0, undecided = 0, unproved = 0,
              refused = 0;
  std::size_t stalled = 0, excused = 0, hidden = 0, open = 0, accepted = 0;
  // The largest over the family, over scale, and the case that has it; NaN where there is none.
  struct Worst {
    double length = std::numeric_limits<double>::quiet_NaN();
    std::string id = {};
    std::optional<double> hardness = {};
    void take(double candidate, const corpus::Case& problem);
  };
  Worst width = {}, passed = {}, normal = {}, witness = {};
  std::vector<double> supports = {};
  std::vector<double> ns = {};  // of the cases that were timed
  // The first case of each kind, and why.
  Tally::Example first_wrong = {}, first_late = {}, first_early = {}, first_wide = {}, first_bad_contact = {},
                 first_undecided = {}, first_unproved = {}, first_refused = {}, first_stalled = {};

  void add(const corpus::Case& problem, const RotatingJudgement& judgement, const Counters& counters);
};

struct RotatingSettings {
  std::vector<const engine::RotatingEngineMethod*> methods;
  std::span<const engine::Guarantee> guarantees;
  unsigned threads = 1;
};

struct RotatingCertification {
  std::vector<RotatingTally> tallies;        // by method, then by suite
  std::vector<std::string> breaches;         // empty: every method keeps its row
  std::vector<bool> kept;                    // by method
  std::vector<corpus::Case> convicted = {};  // cases on which some method is at fault or stalled, each once
};

[[nodiscard]] RotatingCertification certify_rotating(const std::vector<Suite>& suites,
                                                     const RotatingSettings& settings);

// What of a row does not hold in this tally, a line each; without a row nothing is promised.
[[nodiscard]] std::vector<std::string> breaches(const RotatingTally& tally, const engine::Guarantee* row);

[[nodiscard]] std::string rotating_table(const RotatingCertification& certification);
// Which methods there are, what their rows promise, whether it was kept, and where each was at its worst.
[[nodiscard]] std::string rotating_guarantee_table(const RotatingCertification& certification,
                                                   const RotatingSettings& settings);

}  // namespace graze::tool
