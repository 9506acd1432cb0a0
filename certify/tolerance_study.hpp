// Error against time: what each digit of a method's tolerance costs, and what it buys.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engines/method.hpp"

namespace graze::tool {

struct ToleranceRow {
  std::string method;
  double tolerance = 0;  // over scale
  std::size_t cases = 0, not_converged = 0;
  std::size_t missed = 0;  // hits that are said to miss: within the tolerance nothing decides a graze
  // Over scale, by the exact oracle: the backward errors of the bracket's lower and of its finite upper ends;
  // NaN where there is no such end. A miss has none, and denies the depth in its place.
  std::vector<double> lower = {}, upper = {};
  std::vector<double> width = {};   // the larger of the two
  std::vector<double> denied = {};  // of a miss: the depth of the path; else NaN
  std::vector<double> ns = {};
};

// 1e-2, 1e-4, ... 1e-14 over scale.
[[nodiscard]] std::vector<double> studied_tolerances();

// One row a method and tolerance over the given hits. `threads` measure; the timing is done by one.
[[nodiscard]] std::vector<ToleranceRow> study_tolerances(const std::vector<const engine::Method*>& methods,
                                                         std::span<const corpus::Case> hits,
                                                         unsigned threads);

[[nodiscard]] std::string tolerance_table(const std::vector<ToleranceRow>& rows);

// Writes error_against_time.dat and .gp into a directory, which is made, and draws error_against_time.svg if
// gnuplot is installed. Returns a line that says what is there; throws std::runtime_error if it cannot write.
std::string draw_tolerances(const std::vector<ToleranceRow>& rows, const std::string& directory);

}  // namespace graze::tool
