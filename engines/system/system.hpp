// The operating system, for the command: standard streams, signals, clocks, shared libraries and child processes. A port
// to another system replaces linux.cpp, which holds every call of POSIX and of Linux.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace graze::system {

// ---- Standard streams. ----

// The names by which they are opened as files.
inline constexpr const char* kStandardInput = "/dev/stdin";
inline constexpr const char* kStandardOutput = "/dev/stdout";

[[nodiscard]] bool is_stderr_a_terminal();
// Call this before anything is opened. A file then never receives a descriptor 0, 1 or 2 that the caller closed. A pipe
// that nobody reads becomes a write error.
void secure_standard_streams();
// Has the reader of standard output closed it?
[[nodiscard]] bool is_stdout_closed();
// Ends the process as the signal SIGPIPE ends other tools: silently, and a shell shows 141. Returns that value only if
// the signal is blocked.
[[nodiscard]] int end_as_by_sigpipe();

// ---- Requests to stop, by SIGINT or SIGTERM. reports/text/stop.hpp documents them. ----

void accept_stop_requests();
void end_stop_requests();
// The number of the signal that came, or 0.
[[nodiscard]] int stop_request();

// ---- This process. ----

struct Usage {
  double seconds = 0;  // of processor time
  long memory = 0;     // KiB, at most
};
[[nodiscard]] Usage own_usage();
// Processes that ran or waited for a processor, over the last minute, if the system tells.
[[nodiscard]] std::optional<double> load();
// Nanoseconds of processor time of this thread.
[[nodiscard]] double thread_ns();
// The file that this process runs. Empty if the system does not tell.
[[nodiscard]] std::filesystem::path program();
// A path that runs the same program again, even if its file was replaced since.
[[nodiscard]] std::string same_program();
// The model of the processor, or "unknown".
[[nodiscard]] std::string processor_model();

// ---- Shared libraries. ----

// Returns a null pointer and the reason if the file cannot be opened.
[[nodiscard]] void* open_library(const std::string& file, std::string& why);
// Returns a null pointer if the library has no such function.
[[nodiscard]] void* find_function(void* library, const std::string& name);

// ---- Child processes. ----

// Runs a command line of the shell in a folder, without its error messages. True if it succeeded.
[[nodiscard]] bool run_in(const std::string& folder, const std::string& command_line);

// A program in a process of its own, with pipes to its standard streams. It leads a process group and carries a mark in
// its environment. The mark finds the processes that it left behind, even outside the group.
class Child {
 public:
  struct End {
    int code = 0;             // the exit code, 0 if a signal ended it
    std::string signal = {};  // the name of that signal
    long memory = 0;          // KiB, at most
    long inherited = 0;       // KiB that were ours when it was forked, a part of `memory`
  };
  struct Ready {
    bool output = false, errors = false, input = false, end = false;
    const char* failure = nullptr;  // why it cannot be waited for
  };
  enum class Read { some, later, end };

  // The first word of `command` is the program, sought in the PATH, and the others are its arguments. `memory` limits
  // its private memory, in bytes. Throws std::runtime_error if no process can be made. A program that cannot be run says
  // so on its standard error.
  Child(const std::vector<std::string>& command, std::uint64_t memory);
  ~Child();  // ends it, and what it left behind
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Waits until its streams are ready or it has ended. Its input counts if there is something to write.
  [[nodiscard]] Ready wait(std::chrono::milliseconds limit, bool is_to_write) const;
  void wait_for_end(std::chrono::milliseconds limit) const;
  // Writes what the pipe takes, and removes it from the text. False if its input is closed.
  bool write(std::string& text) const;
  void close_input();
  // Appends what is there, at most what a pipe holds.
  Read read(std::string& into);
  // Appends all that is there, and keeps at least the last `kept` bytes.
  void read_errors(std::string& into, std::size_t kept);

  // How it ended, if it has. Only the first call after the end knows.
  std::optional<End> take_end();
  [[nodiscard]] bool has_ended() const { return has_ended_; }
  void kill();
  // Ends the processes that it left behind, and returns their number.
  int end_left_behind() const;

 private:
  void note_end();

  std::string mark_;
  int pid_ = -1, in_ = -1, out_ = -1, err_ = -1, life_ = -1;
  long inherited_ = 0;
  std::vector<char> buffer_;
  bool has_ended_ = false;
};

}  // namespace graze::system
