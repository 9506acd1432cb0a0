// A program of others in a process of its own: started, asked a line, and ended, under a limit of time and
// memory, whatever it does.
//
// It leads a process group, and carries a mark in its environment by which whatever it left behind is found
// and ended, also where that has left the group. What it writes on standard error is kept, the last of it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "engines/method.hpp"

namespace graze::external {

struct ProcessLimits {
  std::chrono::milliseconds time{1000};           // for an answer
  std::chrono::milliseconds start{30000};         // for the first line
  std::uint64_t memory = std::uint64_t{2} << 30;  // bytes of private memory
};

// A line, or why there is none.
struct Line {
  std::string text = {};
  engine::Failure failure = engine::Failure::none;
  std::string what = {};  // of a failure
};

class Process {
 public:
  // Starts the program; the words of `command` are its arguments, the first its file, sought in the PATH.
  // Throws std::runtime_error if no process can be made. A file that cannot be run shows in the first line.
  Process(const std::vector<std::string>& command, const ProcessLimits& limits);
  ~Process();  // ends it
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // The next line that it writes, within the limit; a failure is final, and the process is ended.
  Line read_line(std::chrono::milliseconds limit);
  // Writes a line, and reads the next.
  Line ask(const std::string& line);
  // Writes bytes, and reads as many of `size`, which are the text of what comes back.
  Line exchange(const std::string& bytes, std::size_t size);

  // Its input is closed, and it may end by itself; then what is left of it is ended. How many processes it
  // left behind.
  int finish();
  // The same at once.
  int stop();

 private:
  Line read_reply(std::chrono::milliseconds limit, std::size_t size);
  [[nodiscard]] Line failed(engine::Failure failure, std::string what);
  [[nodiscard]] Line ended(bool within_line);
  bool write_some();
  bool read_rest();
  void read_errors();
  void end(int signal);
  void has_ended();
  int end_others() const;

  ProcessLimits limits_;
  std::string mark_;
  pid_t pid_ = -1;
  int in_ = -1, out_ = -1, err_ = -1, life_ = -1;
  long memory_at_start_ = 0;  // kilobytes that were ours, not the engine's
  std::vector<char> buffer_;
  std::string to_write_, read_, errors_;
  bool is_ended_ = false;
};

}  // namespace graze::external
