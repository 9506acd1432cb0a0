#include "certify/external/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

namespace graze::external {

using engine::Failure;
using Clock = std::chrono::steady_clock;

namespace {

// A longer line is not a valid answer.
constexpr std::size_t kMostOfALine = std::size_t{1} << 24;
constexpr std::size_t kKeptErrors = 2000;
// The length of standard error that a finding shows: a traceback of a dozen calls.
constexpr std::size_t kShownErrors = 1500;
// A process that ended with so much of its memory in use ended at the limit.
constexpr double kFullMemory = 0.8;
// For a process to end by itself once its input has.
constexpr std::chrono::milliseconds kToFinish{2000};

// True for the messages of allocators and runtimes that cannot get more memory.
bool says_no_memory(std::string_view text) {
  for (const std::string_view words : {"bad_alloc", "out of memory", "Out of memory", "MemoryError",
                                       "Cannot allocate memory", "memory allocation of"}) {
    if (text.find(words) != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const ProcessLimits& limits)
    : limits_(limits), child_(command, limits.memory) {}

void Process::read_errors() { child_.read_errors(errors_, kKeptErrors); }

void Process::write_some() {
  if (!child_.write(to_write_)) to_write_.clear();
}

Line Process::failed(Failure failure, std::string what) {
  read_errors();
  std::string last = errors_.substr(errors_.size() - std::min(errors_.size(), kKeptErrors));
  while (!last.empty() && std::isspace(static_cast<unsigned char>(last.back())) != 0) last.pop_back();
  if (last.size() > kShownErrors) {
    // Keeps whole lines if there are any.
    const std::size_t cut = last.size() - kShownErrors, line = last.find('\n', cut);
    last = "..." + (line == std::string::npos ? " " + last.substr(cut) : last.substr(line));
  }
  if (!last.empty()) what += (last.find('\n') == std::string::npos ? "; it wrote: " : "; it wrote:\n") + last;
  return {.failure = failure, .what = std::move(what)};
}

// Its output has ended: how did it?
Line Process::ended(bool within_line) {
  const auto stop = Clock::now() + limits_.time;
  std::optional<system::Child::End> end;
  while (!(end = child_.take_end()) && Clock::now() < stop)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (!end) {
    child_.kill();
    return failed(within_line ? Failure::half_a_line : Failure::silent,
                  within_line ? "its output ended within a line" : "it closed its output, and went on");
  }
  read_errors();
  // Before exec the memory of the child was ours.
  const bool is_full =
      (end->memory > end->inherited &&
       static_cast<double>(end->memory) * 1024 > kFullMemory * static_cast<double>(limits_.memory)) ||
      says_no_memory(errors_);
  const bool has_failed = !end->signal.empty() || end->code != 0;
  const std::string how = end->signal.empty() ? fmt::format("exit {}", end->code) : end->signal;
  if (is_full && has_failed)
    return failed(Failure::out_of_memory,
                  fmt::format("{}; it had used {} MiB of {}", how, end->memory / 1024, limits_.memory >> 20));
  if (has_failed) return failed(Failure::crashed, how);
  if (within_line) return failed(Failure::half_a_line, "its output ended within a line");
  return failed(Failure::silent, "it ended, and said nothing");
}

// Reads the output that the process wrote before it ended and that is still in the pipe. True at the end of the output.
bool Process::read_rest() {
  auto last = system::Child::Read::end;
  while (read_.size() <= kMostOfALine && (last = child_.read(read_)) == system::Child::Read::some) {
  }
  return last != system::Child::Read::some;
}

Line Process::read_line(std::chrono::milliseconds limit) { return read_reply(limit, 0); }

// Reads a line, or `size` bytes if `size` is not 0.
Line Process::read_reply(std::chrono::milliseconds limit, std::size_t size) {
  if (child_.has_ended()) return {.failure = Failure::silent, .what = "it has ended"};
  bool is_dead = false;  // processes that it left behind may hold its output open
  const auto stop = Clock::now() + limit;
  std::size_t looked = 0;
  for (;;) {
    const std::size_t stops = size == 0              ? read_.find('\n', looked)
                              : read_.size() >= size ? size
                                                     : std::string::npos;
    if (stops != std::string::npos) {
      Line line{.text = read_.substr(0, stops)};
      read_.erase(0, size == 0 ? stops + 1 : stops);
      return line;
    }
    if (is_dead) return ended(!read_.empty());
    looked = read_.size();
    if (looked > kMostOfALine) {
      child_.kill();
      return failed(Failure::garbage, fmt::format("a line of more than {} MiB", kMostOfALine >> 20));
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(stop - Clock::now()).count();
    if (left <= 0) {
      child_.kill();
      read_errors();
      // One that is still dying of it has not hung.
      return failed(says_no_memory(errors_) ? Failure::out_of_memory : Failure::hung,
                    fmt::format("no answer within {} s (is every line flushed?)",
                                static_cast<double>(limit.count()) / 1000));
    }
    const auto ready = child_.wait(std::chrono::milliseconds(left), !to_write_.empty());
    if (ready.failure != nullptr) {
      child_.kill();
      return failed(Failure::crashed, std::string("it cannot be heard: ") + ready.failure);
    }
    if (ready.errors) read_errors();
    // An engine that does not read is one that does not answer: its output says which.
    if (ready.input) write_some();
    if (ready.end) {
      is_dead = read_rest();
      continue;
    }
    if (ready.output && child_.read(read_) == system::Child::Read::end) return ended(!read_.empty());
  }
}

Line Process::ask(const std::string& line) {
  to_write_ += line;
  to_write_ += '\n';
  write_some();
  return read_line(limits_.time);
}

Line Process::exchange(const std::string& bytes, std::size_t size) {
  to_write_ += bytes;
  write_some();
  return read_reply(limits_.time, size);
}

int Process::finish() {
  if (!child_.has_ended()) {
    child_.close_input();
    // The rest of its output is read, so that it does not block on a full pipe.
    const auto stop = Clock::now() + kToFinish;
    while (!child_.take_end() && Clock::now() < stop) {
      read_errors();
      read_.clear();
      read_rest();
      child_.wait_for_end(std::chrono::milliseconds(2));
    }
  }
  return this->stop();
}

int Process::stop() {
  if (!child_.has_ended()) child_.kill();
  return child_.end_left_behind();
}

}  // namespace graze::external
