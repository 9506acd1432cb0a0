// Compares two runs of graze price: slower times and less accurate answers.
//
// Only two things are compared: ratios to the baseline of the same run, and counts that depend on no clock.
// Times are not compared, because they belong to another machine or another hour. A slowdown is reported if
// the ratio grew by more than the threshold and the spreads of the two runs do not overlap. If the baseline
// itself becomes slower, all ratios fall together, and the same rule reports this for the table. Work
// (supports, iterations) and verdicts are equal in every run of the same cases. Errors are equal except for
// the last bits, in which compilers differ.
#pragma once

#include <string>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

struct CompareSettings {
  double threshold = 0.1;  // a ratio, a mean of supports: by this part of it
  // An error is reported if it grew by this factor, and beyond rounding.
  double error_factor = 2;
};

struct Comparison {
  std::vector<std::string> worse, better;  // a line each
  std::vector<std::string> not_compared;   // why
  std::size_t rows = 0;                    // compared rows
};

// Throws std::runtime_error if nothing can be compared: another seed or effort, or no table in common.
[[nodiscard]] Comparison compare(const Document& old_run, const Document& new_run,
                                 const CompareSettings& settings = {});

}  // namespace graze::price
