// The results of a method on a family: the number of answers with each fault, other counts, the size of the errors, and
// whether the method's guarantee holds there.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"
#include "engines/guarantees.hpp"
#include "properties/judge/judgement.hpp"

namespace graze::tool {

struct Tally {
  const engine::Method* method = nullptr;
  std::string family;
  bool is_drawn = false;               // a generated family, and not cases that were given
  std::size_t cases = 0, skipped = 0;  // those that are no question for the method are no cases of its row
  std::size_t declined = 0;            // asked, and answered with unsupported, not counted as cases
  std::array<std::size_t, law::kFaults> faults = {};  // answers by their worst, one of law::kFaultKinds
  std::size_t at_fault = 0;                           // answers with any
  std::size_t stalled = 0, within_tolerance = 0, hidden = 0, open = 0;
  // Open answers, within the guarantee or not: not_converged, or a bracket that is flagged as wide. `stalled` counts
  // those that the guarantee does not grant.
  std::size_t left_open = 0;
  std::size_t accepted = 0, refused = 0, unproved = 0;  // by their proofs
  std::size_t by_oracle = 0;
  // Over scale, of the cases that the oracle measured.
  std::vector<double> forward = {}, backward = {}, normal = {}, witness = {};
  std::vector<double> true_backward = {};  // the same against the input before rounding to float
  std::vector<double> ns = {};             // times of the timed cases
  std::vector<double> supports = {};

  // The largest value, and its case. NaN if no case was counted.
  struct Worst {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::string id = {};
    std::optional<double> hardness = {};
    void take(double candidate, const corpus::Case& problem);
    void take(const Worst& other);
  };
  Worst width = {};          // errors.backward
  Worst passed = {};         // errors.passed
  Worst over_limit = {};     // errors.over_limit
  Worst most_supports = {};  // support evaluations
  // The least limit with which verdicts and times would have passed: over scale, and as a length.
  Worst least_relative = {}, least_length = {};

  // The first case of each kind, and its reason.
  struct Example {
    std::string id = {}, reason = {};
    corpus::Case problem = {};  // set for third-party engines
  };
  std::array<Example, law::kFaults> first = {};
  // For third-party engines: the failures by kind.
  struct Failed {
    std::size_t count = 0;
    Example first = {};
  };
  std::array<Failed, engine::kFailures> failures = {};
  Example first_stalled = {}, first_open = {};

  void add(const corpus::Case& problem, const law::Judgement& judgement);
  // Adds the tally of the same method on another family. The sum then covers both.
  void add(const Tally& other);
};

// The part of its questions that an engine may decline.
inline constexpr double kMostDeclined = 0.1;
// A message if a method's total declines more than kMostDeclined. Empty otherwise.
[[nodiscard]] std::string declines(const Tally& total);

// The fraction of unconverged answers that is allowed in a generated family of ties, where bodies touch or pass within
// the width. It replaces the guarantee's open_cap. It is well above the 16 % of `sliding` and the 25 % of `pure_spin`
// that are open.
inline constexpr double kOpenOfTies = 0.3;
[[nodiscard]] bool is_made_of_ties(const std::string& family);

// True if more answers are open than the guarantee's caps allow. stall_cap bounds the open answers that the guarantee
// does not grant. open_cap bounds all open answers in a generated family. A single open answer is always allowed.
[[nodiscard]] bool is_above_stall_cap(const Tally& tally);
[[nodiscard]] bool is_above_open_cap(const Tally& tally);

// The parts of the method's guarantee that this tally breaks, one line each: the guarantee, the family, how many, and
// the case. Empty without a guarantee.
[[nodiscard]] std::vector<std::string> breaches(const Tally& tally);

}  // namespace graze::tool
