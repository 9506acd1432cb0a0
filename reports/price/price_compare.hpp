// Two runs of graze price: what got slower, what less accurate?
//
// Only ratios to the baseline of the same run, and counts that depend on no clock, are compared: never times,
// which are another machine's or another hour's. A slowdown is said where the ratio grew by more than the
// threshold and the spreads of the two runs do not overlap. Should the baseline itself become slower, all
// ratios fall together: that is said of the table, by the same rule. Work (supports, iterations) and verdicts
// are the same in every run of the same cases, and so is an error but for the last bits, which compilers
// differ in.
#pragma once

#include <string>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

struct CompareSettings {
  double threshold = 0.1;  // a ratio, a mean of supports: by this part of it
  // An error must grow by this factor, and beyond what rounding is, to be said.
  double error_factor = 2;
};

struct Comparison {
  std::vector<std::string> worse, better;  // a line each
  std::vector<std::string> not_compared;   // why
  std::size_t rows = 0;                    // that were compared
};

// Throws std::runtime_error where nothing can be compared: another seed or effort, no table in common.
[[nodiscard]] Comparison compare(const Document& old_run, const Document& new_run,
                                 const CompareSettings& settings = {});

}  // namespace graze::price
