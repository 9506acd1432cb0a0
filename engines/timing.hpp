// How long a call takes: the median over batches, in nanoseconds.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace graze::engine {

// Keeps the optimiser from dropping a result that nobody reads.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

// One call's nanoseconds, the median over `repeats` batches of calls.
template <class Call>
double median_ns(const Call& call, int repeats) {
  using Clock = std::chrono::steady_clock;
  const auto time_batch = [&](int calls) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < calls; ++i) keep(call());
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  };
  // A batch of 20 microseconds or more: reading the clock (about 25 ns) stays below 1 part in 500.
  constexpr double kBatchNs = 20e3;
  const double first = std::max(time_batch(2) / 2, 1.0);  // also warms the caches
  const int calls = static_cast<int>(std::clamp(kBatchNs / first, 1.0, 1e4));
  std::vector<double> times(static_cast<std::size_t>(std::max(repeats, 1)));
  for (double& t : times) t = time_batch(calls) / calls;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace graze::engine
