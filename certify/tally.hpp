// A method on a family: how many answers have which fault, what is no fault by itself, how large the errors
// were, and whether the method's guarantee holds there.
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
  std::size_t cases = 0, not_asked = 0;  // those that are no question for the method are no cases of its row
  std::array<std::size_t, law::kFaults> faults = {};  // by law::kFaultKinds; an answer may have several
  std::size_t at_fault = 0;                           // answers with any
  std::size_t stalled = 0, excused = 0, hidden = 0, open = 0;
  std::size_t accepted = 0, refused = 0, unproved = 0;  // by their proofs
  std::size_t by_oracle = 0;
  // Over scale, of the cases that the oracle measured.
  std::vector<double> forward = {}, backward = {}, normal = {}, witness = {};
  std::vector<double> true_backward = {};  // the same against the input before rounding to float
  std::vector<double> ns = {};             // of the cases that were timed
  std::vector<double> supports = {};

  // The largest, and the case that has it; NaN where there is none.
  struct Worst {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::string id = {};
    std::optional<double> hardness = {};
    void take(double candidate, const corpus::Case& problem);
    void take(const Worst& other);
  };
  Worst width = {};       // errors.backward
  Worst passed = {};      // errors.passed
  Worst over_limit = {};  // errors.over_limit
  // The least limit with which verdicts and times would have passed: over scale, and as a length.
  Worst least_relative = {}, least_length = {};

  // The first case of each kind, and its reason.
  struct Example {
    std::string id = {}, reason = {};
    corpus::Case problem = {};  // of engines of others
  };
  std::array<Example, law::kFaults> first = {};
  // Of engines of others: by what kept an answer from being one.
  struct Failed {
    std::size_t count = 0;
    Example first = {};
  };
  std::array<Failed, engine::kFailures> failures = {};
  Example first_stalled = {};

  void add(const corpus::Case& problem, const law::Judgement& judgement, const Counters& counters);
  // Of the same method on another family, which it then stands for as well.
  void add(const Tally& other);
};

// What of the method's guarantee does not hold in this tally, a line each: the row, the family, how many, and
// by which case. Without a row nothing is promised and nothing can break.
[[nodiscard]] std::vector<std::string> breaches(const Tally& tally);

}  // namespace graze::tool
