// Median and worst of measured values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace graze::tool {

// The median of the values that are not NaN, the upper of the two middle values. NaN if there are no values.
[[nodiscard]] inline double median(std::vector<double> values) {
  std::erase_if(values, [](double x) { return std::isnan(x); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The largest value that is not NaN. NaN if there are no values.
[[nodiscard]] inline double worst(const std::vector<double>& values) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (const double x : values) most = std::fmax(most, x);
  return most;
}

}  // namespace graze::tool
