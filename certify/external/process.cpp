#include "certify/external/process.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace graze::external {

using engine::Failure;
using Clock = std::chrono::steady_clock;

namespace {

constexpr const char* kMark = "GRAZE_ENGINE_PROCESS=";
// A longer line is not a valid answer.
constexpr std::size_t kMostOfALine = std::size_t{1} << 24;
constexpr std::size_t kKeptErrors = 2000;
// The length of standard error that a finding shows: a traceback of a dozen calls.
constexpr std::size_t kShownErrors = 1500;
// The capacity of a pipe.
constexpr std::size_t kPipeBytes = std::size_t{1} << 16;
// A process that ended with so much of its memory in use ended at the limit.
constexpr double kFullMemory = 0.8;
// For a process to end by itself once its input has.
constexpr std::chrono::milliseconds kToFinish{2000};

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(std::string("no pipe for an engine: ") + std::strerror(errno));
    read = ends[0];
    write = ends[1];
  }
};

void close_one(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

void do_not_block(int descriptor) { fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK); }

// In the child, between fork and exec: nothing but calls that are safe there.
[[noreturn]] void become(const std::vector<char*>& words, const std::vector<char*>& environment, int in,
                         int out, int err, std::uint64_t memory) {
  setpgid(0, 0);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0U, 0);  // nothing that is ours is the engine's
  const rlimit data{.rlim_cur = memory, .rlim_max = memory}, core{.rlim_cur = 0, .rlim_max = 0};
  setrlimit(RLIMIT_DATA, &data);
  setrlimit(RLIMIT_CORE, &core);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execvpe(words.front(), words.data(), environment.data());
  const char* const why = std::strerror(errno);
  constexpr const char* kText = "cannot be run: ";
  (void)!write(STDERR_FILENO, kText, std::strlen(kText));
  (void)!write(STDERR_FILENO, why, std::strlen(why));
  _exit(127);
}

std::string read_whole(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool is_number(std::string_view name) {
  return name.find_first_not_of("0123456789") == std::string_view::npos;
}

std::vector<pid_t> numbers_in(const char* directory) {
  std::vector<pid_t> found;
  DIR* const all = opendir(directory);
  if (all == nullptr) return found;
  while (const dirent* const entry = readdir(all)) {
    if (is_number(entry->d_name)) found.push_back(std::stoi(entry->d_name));
  }
  closedir(all);
  return found;
}

// Our children: engines, and the processes they left behind, since we are their reaper. If the kernel keeps no list of
// children, every process.
std::vector<pid_t> candidates() {
  std::vector<pid_t> found;
  for (const pid_t thread : numbers_in("/proc/self/task")) {
    std::ifstream file(fmt::format("/proc/self/task/{}/children", thread));
    if (!file) {
      if (thread == getpid()) return numbers_in("/proc");
      continue;  // a thread that has ended
    }
    for (pid_t pid = 0; file >> pid;) found.push_back(pid);
  }
  return found;
}

// Z in /proc/PID/stat, whose second field is a name in brackets that may hold anything.
bool is_zombie(pid_t pid) {
  const std::string stat = read_whole(fmt::format("/proc/{}/stat", pid));
  const std::size_t name = stat.rfind(')');
  return name != std::string::npos && stat.substr(name).starts_with(") Z");
}

bool is_marked(pid_t pid, const std::string& mark) {
  // Each variable ends with a zero.
  return read_whole(fmt::format("/proc/{}/environ", pid)).find(mark + '\0') != std::string::npos;
}

// The processes that are ours to wait for by name. Whatever else ends as a child of ours in a group that is not ours
// was left behind by an engine.
struct Leaders {
  std::mutex mutex = {};
  std::set<pid_t> pids = {};
};
Leaders& leaders() {
  static Leaders all;
  return all;
}

void reap_orphans(const std::vector<pid_t>& children) {
  const std::lock_guard lock(leaders().mutex);
  for (const pid_t pid : children) {
    if (!leaders().pids.contains(pid) && is_zombie(pid) && getpgid(pid) != getpgrp())
      waitpid(pid, nullptr, WNOHANG);
  }
}

// Kilobytes that this process has had in memory at most. An engine's own count begins there, since it is forked.
long own_memory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

// True for the messages of allocators and runtimes that cannot get more memory.
bool says_no_memory(std::string_view text) {
  for (const std::string_view words : {"bad_alloc", "out of memory", "Out of memory", "MemoryError",
                                       "Cannot allocate memory", "memory allocation of"}) {
    if (text.find(words) != std::string_view::npos) return true;
  }
  return false;
}

std::string signal_text(int signal) {
  const char* const name = sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const ProcessLimits& limits)
    : limits_(limits), buffer_(kPipeBytes) {
  static std::atomic<std::uint64_t> number = 0;
  // Whatever an engine leaves behind becomes a child of ours, and can be waited for.
  static const int kReaper = prctl(PR_SET_CHILD_SUBREAPER, 1);
  (void)kReaper;
  static const auto kIgnored = ::signal(SIGPIPE, SIG_IGN);
  (void)kIgnored;
  mark_ = fmt::format("{}{}-{}", kMark, getpid(), ++number);

  std::vector<char*> words, environment;
  std::transform(command.begin(), command.end(), std::back_inserter(words),
                 [](const std::string& word) { return const_cast<char*>(word.c_str()); });
  words.push_back(nullptr);
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (std::strncmp(*variable, kMark, std::strlen(kMark)) != 0) environment.push_back(*variable);
  }
  environment.push_back(mark_.data());
  environment.push_back(nullptr);

  Pipe in, out, err;
  memory_at_start_ = own_memory();
  {
    const std::lock_guard lock(leaders().mutex);
    pid_ = fork();
    if (pid_ > 0) leaders().pids.insert(pid_);
  }
  if (pid_ == 0) become(words, environment, in.read, out.write, err.write, limits.memory);
  const int why = errno;
  for (int* end : {&in.read, &out.write, &err.write}) close_one(*end);
  if (pid_ < 0) {
    for (int* end : {&in.write, &out.read, &err.read}) close_one(*end);
    throw std::runtime_error(std::string("no process for an engine: ") + std::strerror(why));
  }
  setpgid(pid_, pid_);  // both do it, so that it is done whoever is first
  in_ = in.write;
  out_ = out.read;
  err_ = err.read;
  for (const int end : {in_, out_, err_}) do_not_block(end);
  life_ = static_cast<int>(
      syscall(SYS_pidfd_open, pid_, 0));  // the C library of Debian 12 has no working name for it
}

Process::~Process() {
  if (pid_ > 0) stop();
  for (int* one : {&in_, &out_, &err_, &life_}) close_one(*one);
}

void Process::read_errors() {
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; err_ >= 0 && (n = read(err_, buffer.data(), buffer.size())) > 0;) {
    errors_.append(buffer.data(), static_cast<std::size_t>(n));
    if (errors_.size() > 2 * kKeptErrors) errors_.erase(0, errors_.size() - kKeptErrors);
  }
}

bool Process::write_some() {
  while (!to_write_.empty()) {
    const ssize_t n = write(in_, to_write_.data(), to_write_.size());
    if (n < 0) return errno == EAGAIN || errno == EINTR;
    to_write_.erase(0, static_cast<std::size_t>(n));
  }
  return true;
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

void Process::end(int signal) {
  kill(-pid_, signal);
  kill(pid_, signal);
  waitpid(pid_, nullptr, 0);
  has_ended();
}

void Process::has_ended() {
  is_ended_ = true;
  const std::lock_guard lock(leaders().mutex);
  leaders().pids.erase(pid_);
}

int Process::end_others() const {
  int found = 0;
  // One that is forked while we look is found when we look again.
  for (int round = 0; round < 8; ++round) {
    const std::vector<pid_t> all = candidates();
    bool is_clean = true;
    for (const pid_t pid : all) {
      if (pid == pid_ || !is_marked(pid, mark_)) continue;
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
      ++found;
      is_clean = false;
    }
    if (is_clean) {
      reap_orphans(all);
      break;
    }
  }
  return found;
}

// Its output has ended: how did it?
Line Process::ended(bool within_line) {
  int status = 0;
  rusage used{};
  const auto stop = Clock::now() + limits_.time;
  pid_t done = 0;
  while ((done = wait4(pid_, &status, WNOHANG, &used)) == 0 && Clock::now() < stop)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (done == 0) {
    end(SIGKILL);
    return failed(within_line ? Failure::half_a_line : Failure::silent,
                  within_line ? "its output ended within a line" : "it closed its output, and went on");
  }
  has_ended();
  read_errors();
  // Before exec the memory of the child was ours.
  const bool is_full =
      (used.ru_maxrss > memory_at_start_ &&
       static_cast<double>(used.ru_maxrss) * 1024 > kFullMemory * static_cast<double>(limits_.memory)) ||
      says_no_memory(errors_);
  const std::string memory =
      fmt::format("; it had used {} MiB of {}", used.ru_maxrss / 1024, limits_.memory >> 20);
  const bool by_signal = WIFSIGNALED(status);
  if (is_full && (by_signal || WEXITSTATUS(status) != 0))
    return failed(
        Failure::out_of_memory,
        (by_signal ? signal_text(WTERMSIG(status)) : fmt::format("exit {}", WEXITSTATUS(status))) + memory);
  if (by_signal) return failed(Failure::crashed, signal_text(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) return failed(Failure::crashed, fmt::format("exit {}", WEXITSTATUS(status)));
  if (within_line) return failed(Failure::half_a_line, "its output ended within a line");
  return failed(Failure::silent, "it ended, and said nothing");
}

// Reads the output that the process wrote before it ended and that is still in the pipe. True at the end of the output.
bool Process::read_rest() {
  ssize_t n = 0;
  while (read_.size() <= kMostOfALine && (n = read(out_, buffer_.data(), buffer_.size())) > 0)
    read_.append(buffer_.data(), static_cast<std::size_t>(n));
  return n <= 0;
}

Line Process::read_line(std::chrono::milliseconds limit) { return read_reply(limit, 0); }

// Reads a line, or `size` bytes if `size` is not 0.
Line Process::read_reply(std::chrono::milliseconds limit, std::size_t size) {
  if (is_ended_) return {.failure = Failure::silent, .what = "it has ended"};
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
      end(SIGKILL);
      return failed(Failure::garbage, fmt::format("a line of more than {} MiB", kMostOfALine >> 20));
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(stop - Clock::now()).count();
    if (left <= 0) {
      end(SIGKILL);
      read_errors();
      // One that is still dying of it has not hung.
      return failed(says_no_memory(errors_) ? Failure::out_of_memory : Failure::hung,
                    fmt::format("no answer within {} s (is every line flushed?)",
                                static_cast<double>(limit.count()) / 1000));
    }
    std::array<pollfd, 4> ends = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0},
                                  pollfd{to_write_.empty() ? -1 : in_, POLLOUT, 0}, pollfd{life_, POLLIN, 0}};
    if (poll(ends.data(), ends.size(), static_cast<int>(left)) < 0 && errno != EINTR) {
      end(SIGKILL);
      return failed(Failure::crashed, std::string("it cannot be heard: ") + std::strerror(errno));
    }
    if (ends[1].revents != 0) {
      read_errors();
      if ((ends[1].revents & POLLIN) == 0) close_one(err_);
    }
    // An engine that does not read is one that does not answer: its output says which.
    if (ends[2].revents != 0 && !write_some()) to_write_.clear();
    if (ends[3].revents != 0) {
      is_dead = read_rest();
      continue;
    }
    if (ends[0].revents == 0) continue;
    const ssize_t n = read(out_, buffer_.data(), buffer_.size());
    if (n > 0) {
      read_.append(buffer_.data(), static_cast<std::size_t>(n));
    } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
      return ended(!read_.empty());
    }
  }
}

Line Process::ask(const std::string& line) {
  to_write_ += line;
  to_write_ += '\n';
  if (!write_some()) to_write_.clear();
  return read_line(limits_.time);
}

Line Process::exchange(const std::string& bytes, std::size_t size) {
  to_write_ += bytes;
  if (!write_some()) to_write_.clear();
  return read_reply(limits_.time, size);
}

int Process::finish() {
  if (!is_ended_) {
    close_one(in_);
    // The rest of its output is read, so that it does not block on a full pipe.
    const auto stop = Clock::now() + kToFinish;
    pid_t done = 0;
    while ((done = waitpid(pid_, nullptr, WNOHANG)) == 0 && Clock::now() < stop) {
      read_errors();
      read_.clear();
      read_rest();
      pollfd life{life_, POLLIN, 0};
      poll(&life, 1, 2);
    }
    if (done == 0) {
      end(SIGKILL);
    } else {
      has_ended();
    }
  }
  return end_others();
}

int Process::stop() {
  if (!is_ended_) end(SIGKILL);
  return end_others();
}

}  // namespace graze::external
