// Running a law over many cases: counting what was drawn, and keeping what broke.
//
// A run fails when the law breaks, and also when an outcome (hit, miss, initially_overlapping) was never
// reached: a law that saw no hit says nothing about hits. It fails too when more answers were not_converged
// than the method's row allows, and, over the families, when one that the law applies to was never reached.
#pragma once

#include <string>
#include <string_view>

#include "corpus/case.hpp"
#include "properties/laws/law_tally.hpp"

namespace graze::law {

class LawRun {
 public:
  LawRun(Law law, std::string source) : law_(std::move(law)), source_(std::move(source)), tally_(law_) {}

  // Calls every method. True if the law holds or does not apply.
  bool holds_for(const corpus::Case& problem, std::string_view family = {});

  // Makes the broken case small by the law and the method that it broke. The small case may break the law for
  // another reason. At most `budget` calls of the law.
  void minimise(int budget = 3000);

  // The last broken case, saved as files (certify/law_finding.hpp) in GRAZE_FINDINGS_DIR or findings/ of the
  // build. seed: how to draw the first one again.
  [[nodiscard]] std::string report(std::string_view seed) const;

  // Empty, or the outcome that was never drawn, or the method that failed to converge too often.
  [[nodiscard]] std::string shortfall() const;
  // The same, or which family was never reached.
  [[nodiscard]] std::string shortfall_over_families() const;

  void print() const;
  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] const corpus::Case& failing() const { return failing_; }
  [[nodiscard]] const LawTally& tally() const { return tally_; }

 private:
  Law law_;
  std::string source_;
  LawTally tally_;
  std::string reason_;
  corpus::Case failing_, stalled_;
  int known_breaches_ = 0;
  std::size_t broken_method_ = 0;
};

// "graze generate NAME --hardness H --seed S --count 1"
[[nodiscard]] std::string seed_of(std::string_view family, double hardness, std::uint64_t seed);

}  // namespace graze::law
