// Runs a third-party program in a process of its own: starts it, asks it a line, and ends it, under a limit
// of time and memory, whatever the program does.
// The last part of its standard error is kept.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "engines/method.hpp"
#include "engines/system/system.hpp"

namespace graze::external {

struct ProcessLimits {
  std::chrono::milliseconds time{1000};           // for an answer
  std::chrono::milliseconds start{30000};         // for the first line
  std::uint64_t memory = std::uint64_t{2} << 30;  // bytes of private memory
};

// A line, or the reason for its absence.
struct Line {
  std::string text = {};
  engine::Failure failure = engine::Failure::none;
  std::string what = {};  // the description of a failure
};

class Process {
 public:
  // Starts the program. The first word of `command` is the program, sought in the PATH, and the others are
  // its arguments. Throws std::runtime_error if no process can be made. If the file cannot be run, the first
  // line reports it.
  Process(const std::vector<std::string>& command, const ProcessLimits& limits);

  // The next line of its output, within the time limit. After a failure the process is ended, and later calls
  // fail too.
  Line read_line(std::chrono::milliseconds limit);
  // Writes a line, and reads the next.
  Line ask(const std::string& line);
  // Writes bytes, and reads `size` bytes, which become the text of the returned line.
  Line exchange(const std::string& bytes, std::size_t size);

  // Closes its input, so that it may end by itself, and then ends all that is left of it. Returns the number
  // of processes that it left behind.
  int finish();
  // The same at once.
  int stop();

 private:
  Line read_reply(std::chrono::milliseconds limit, std::size_t size);
  [[nodiscard]] Line failed(engine::Failure failure, std::string what);
  [[nodiscard]] Line ended(bool within_line);
  void write_some();
  bool read_rest();
  void read_errors();

  ProcessLimits limits_;
  std::string to_write_, read_, errors_;
  system::Child child_;  // it ends with the object
};

}  // namespace graze::external
