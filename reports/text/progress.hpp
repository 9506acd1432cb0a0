// Reports the progress of a long command on stderr. A terminal shows one line that is kept up to date, with
// the time left. A log has a line every 20 s, the first once the command has run for 10 s.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace graze::tool {

class Progress {
 public:
  // Shows counts, or the share that is done if the items differ in cost, with a bar.
  enum class Show { counts, percent };

  // `before`: the part of the total that was done before this run.
  Progress(std::string label, std::uint64_t total, std::uint64_t before = 0, Show show = Show::counts);
  ~Progress();  // wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // From any thread: one more is done, or so many are done, with a text to add.
  void step();
  void reach(std::uint64_t done, const std::string& more = {});
  // So many more are done.
  void advance(std::uint64_t by, const std::string& more);
  // Before another line is printed.
  void wipe() const;

 private:
  using Clock = std::chrono::steady_clock;
  void show(const std::string& more);

  [[nodiscard]] std::string text_of_done() const;

  std::string label_;
  Show kind_;
  std::uint64_t total_, before_, done_;
  bool on_terminal_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now(), shown_;
};

// 3 h 12 min, 4 min, 20 s.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace graze::tool
