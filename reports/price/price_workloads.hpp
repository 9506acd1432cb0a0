// Measures the cost of the steps of simulations. The three tiers that a simulator chooses among are asked
// each workload (corpus/workloads.hpp). Their answers are counted and their casts are timed one by one.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engines/method.hpp"
#include "reports/price/document.hpp"

namespace graze::price {

// A method's results on one workload at one place.
struct WorkloadRow {
  std::string workload, place, method;
  std::size_t hits = 0, misses = 0, overlapping = 0, not_converged = 0, refused = 0;
  // Over the casts that were answered: nanoseconds of processor time, each cast the least of a few.
  double median_ns = kNone, p99_ns = kNone, p999_ns = kNone;
  int most_supports = 0;
  std::string worst = {};  // the case of most_supports

  [[nodiscard]] std::size_t casts() const { return hits + misses + overlapping + not_converged + refused; }
};

struct WorkloadSettings {
  std::uint64_t casts = 1000;  // for each workload at each place
  std::uint64_t seed = 1;
  std::vector<std::string> only = {};  // workloads by name, empty for all
  std::function<bool()> stop = [] { return false; };
};

// Rows by workload, place and method. A stopped run returns the rows that were finished.
[[nodiscard]] std::vector<WorkloadRow> measure_workloads(const WorkloadSettings& settings);

// A table as text, and docs/reports/workloads.md, whole.
[[nodiscard]] std::string workload_table(const std::vector<WorkloadRow>& rows);
[[nodiscard]] std::string workload_page(const std::vector<WorkloadRow>& rows,
                                        const WorkloadSettings& settings, const Machine& machine);

}  // namespace graze::price
