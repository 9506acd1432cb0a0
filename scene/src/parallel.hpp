// job(i) for every i < count, on a few threads: for scenes, and for the tools beside them. job(i) writes only its own
// data, so that nothing depends on the number of threads. The first exception of a job ends the run and is thrown
// again here.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace graze::scene {

template <class Job>
void for_each_index(std::size_t count, unsigned threads, const Job& job) {
  if (threads <= 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) job(i);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) job(i);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
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
    for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t) others.threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace graze::scene
