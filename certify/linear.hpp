// Certification: suites of cases, every method judged on each, tallied. Pure but for the clock.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "certify/tally.hpp"
#include "engines/guarantees.hpp"
#include "properties/judge/answer.hpp"

namespace graze::tool {

// Linear casts: given ones, or as many as wanted, each drawn when it is asked for.
struct Suite {
  std::string family;
  std::vector<corpus::Case> cases = {};
  std::size_t drawn = 0;
  std::function<corpus::Case(std::size_t)> draw = {};
  std::size_t oracle_every =
      1;  // the exact oracle measures every so many of them, beside what it must decide

  [[nodiscard]] std::size_t size() const { return cases.size() + drawn; }
  [[nodiscard]] corpus::Case at(std::size_t i) const {
    return i < cases.size() ? cases[i] : draw(i - cases.size());
  }
};

struct Settings {
  std::vector<const engine::EngineMethod*> methods;
  std::span<const engine::Guarantee> guarantees;
  unsigned threads = 1;
};

struct Certification {
  std::vector<Tally> tallies;                // by method, then by suite
  std::vector<std::string> breaches;         // empty: every method keeps its row
  std::vector<bool> kept;                    // by method
  std::vector<corpus::Case> convicted = {};  // cases on which some method is at fault or stalled, each once
  std::vector<std::unique_ptr<Truth>> hits;  // measured cases that are hits, for the study of tolerances
  std::size_t oracle_cases = 0;              // distinct cases for which an exact answer was made
};

[[nodiscard]] Certification certify(const std::vector<Suite>& suites, const Settings& settings);

// What the exact tier's casts come to: how many, how many wrong or stalled, and the rate of failures that so
// many without one allow at 95 %; empty without a method of that tier.
[[nodiscard]] std::string exact_summary(const Certification& certification, const Settings& settings);

// Which methods there are, what their rows promise, and whether it was kept.
[[nodiscard]] std::string guarantee_table(const Certification& certification, const Settings& settings);

}  // namespace graze::tool
