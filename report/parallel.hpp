// Runs a job for every index on a few threads. Each index is one job's own, so that the results, stored by
// index, do not depend on how many threads there were.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace graze::tool {

// job(i) for every i < count. The first exception of a job ends the run and is thrown again here.
template <class Job>
void for_each_index(std::size_t count, unsigned threads, const Job& job) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    // std::jthread would do, but libc++ 16 lacks it.
    struct Joined {
      std::vector<std::thread> threads;
      ~Joined() {
        for (std::thread& t : threads) t.join();
      }
    } others;
    for (unsigned t = 1; t < threads; ++t) others.threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace graze::tool
