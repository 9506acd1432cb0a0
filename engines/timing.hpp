// Measures the time of a call: the median over batches, in nanoseconds of processor time. Other work of the machine is
// not counted, although it evicts caches.
#pragma once

#include <algorithm>
#include <vector>

#include "engines/system/system.hpp"

namespace graze::engine {

// Keeps the optimiser from dropping a result that nobody reads.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

// One call's nanoseconds, the median over `repeats` batches of calls.
template <class Call>
double median_ns(const Call& call, int repeats) {
  const auto time_batch = [&](int calls) {
    const double start = system::thread_ns();
    for (int i = 0; i < calls; ++i) keep(call());
    return system::thread_ns() - start;
  };
  // A batch of 50 microseconds or more: reading the clock (a call of the system, about 300 ns) stays below 1
  // part in 100.
  constexpr double kBatchNs = 50e3;
  const double first = std::max(time_batch(2) / 2, 1.0);  // also warms the caches
  const int calls = static_cast<int>(std::clamp(kBatchNs / first, 1.0, 1e4));
  std::vector<double> times(static_cast<std::size_t>(std::max(repeats, 1)));
  for (double& t : times) t = time_batch(calls) / calls;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace graze::engine
