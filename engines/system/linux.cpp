#include "engines/system/system.hpp"

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
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
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string_view>

extern char** environ;

namespace graze::system {

// ---- Standard streams. ----

bool is_stderr_a_terminal() { return isatty(STDERR_FILENO) != 0; }

void secure_standard_streams() {
  // Each opened the wrong way round, so that to read or to write it fails as it would have.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) != -1) continue;
    if (open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) std::abort();
  }
  ::signal(SIGPIPE, SIG_IGN);
}

bool is_stdout_closed() {
  pollfd out{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

int end_as_by_sigpipe() {
  ::signal(SIGPIPE, SIG_DFL);
  raise(SIGPIPE);
  return 128 + SIGPIPE;  // reached if the signal is blocked
}

// ---- Requests to stop. ----

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // ns
// A signal within this time of the first belongs to the same request.
constexpr std::int64_t kOneRequest = kSecond;

std::atomic<int> g_signal = 0;
std::atomic<std::int64_t> g_first = 0;  // time of the first signal in ns, 0 before it
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a handler of signals may only use such");
bool g_on_terminal = false;  // stderr is one, where ^C and a line of progress may stand

std::int64_t now() {
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return kSecond * time.tv_sec + time.tv_nsec + 1;
}

void say_on_stderr(std::string_view text) {
  const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(written);  // a failed write is ignored
}

void handle(int number, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

void note_signal(int number) {
  const int error = errno;
  const std::int64_t time = now();
  std::int64_t first = 0;
  if (g_first.compare_exchange_strong(first, time)) {
    g_signal = number;
    if (g_on_terminal) say_on_stderr("\r\033[K");
    say_on_stderr("graze: stopping; what is being judged is finished first. Once more ends at once.\n");
  } else if (time - first >= kOneRequest) {
    handle(number, SIG_DFL);
    raise(number);  // taken once this handler returns
  }
  errno = error;
}

}  // namespace

void accept_stop_requests() {
  g_signal = 0;
  g_first = 0;
  g_on_terminal = is_stderr_a_terminal();
  for (const int number : {SIGINT, SIGTERM}) handle(number, &note_signal);
}

// After a request the handler stays, because its other signals may arrive while the results are written.
void end_stop_requests() {
  if (g_signal != 0) return;
  for (const int number : {SIGINT, SIGTERM}) handle(number, SIG_DFL);
}

int stop_request() { return g_signal; }

// ---- This process. ----

Usage own_usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return {.seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                     1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec),
          .memory = used.ru_maxrss};
}

std::optional<double> load() {
  double out = 0;
  return getloadavg(&out, 1) == 1 ? std::optional(out) : std::nullopt;
}

double thread_ns() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

std::string same_program() { return "/proc/self/exe"; }

std::filesystem::path program() {
  std::error_code none;
  return std::filesystem::read_symlink(same_program(), none);
}

std::string processor_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

// ---- Shared libraries. ----

void* open_library(const std::string& file, std::string& why) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  // dlopen seeks a name without a slash in the library path and not in the current folder.
  if (library == nullptr) library = dlopen(("./" + file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) why = dlerror();
  return library;
}

void* find_function(void* library, const std::string& name) { return dlsym(library, name.c_str()); }

// ---- Child processes. ----

bool run_in(const std::string& folder, const std::string& command_line) {
  std::string quoted;
  for (const char c : folder) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return std::system(("cd '" + quoted + "' && " + command_line + " 2>/dev/null").c_str()) == 0;
}

namespace {

constexpr const char* kMark = "GRAZE_ENGINE_PROCESS=";
// The capacity of a pipe.
constexpr std::size_t kPipeBytes = std::size_t{1} << 16;

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
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/children");
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
  const std::string stat = read_whole("/proc/" + std::to_string(pid) + "/stat");
  const std::size_t name = stat.rfind(')');
  return name != std::string::npos && stat.substr(name).starts_with(") Z");
}

bool is_marked(pid_t pid, const std::string& mark) {
  // Each variable ends with a zero.
  return read_whole("/proc/" + std::to_string(pid) + "/environ").find(mark + '\0') != std::string::npos;
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

std::string signal_text(int signal) {
  const char* const name = sigabbrev_np(signal);
  return name == nullptr ? "signal " + std::to_string(signal) : std::string("SIG") + name;
}

}  // namespace

Child::Child(const std::vector<std::string>& command, std::uint64_t memory) : buffer_(kPipeBytes) {
  static std::atomic<std::uint64_t> number = 0;
  // Whatever an engine leaves behind becomes a child of ours, and can be waited for.
  static const int kReaper = prctl(PR_SET_CHILD_SUBREAPER, 1);
  (void)kReaper;
  static const auto kIgnored = ::signal(SIGPIPE, SIG_IGN);
  (void)kIgnored;
  mark_ = kMark + std::to_string(getpid()) + "-" + std::to_string(++number);

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
  inherited_ = own_usage().memory;
  {
    const std::lock_guard lock(leaders().mutex);
    pid_ = fork();
    if (pid_ > 0) leaders().pids.insert(pid_);
  }
  if (pid_ == 0) become(words, environment, in.read, out.write, err.write, memory);
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

Child::~Child() {
  if (!has_ended_) kill();
  end_left_behind();
  for (int* one : {&in_, &out_, &err_, &life_}) close_one(*one);
}

Child::Ready Child::wait(std::chrono::milliseconds limit, bool is_to_write) const {
  std::array<pollfd, 4> ends = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0},
                                pollfd{is_to_write ? in_ : -1, POLLOUT, 0}, pollfd{life_, POLLIN, 0}};
  if (poll(ends.data(), ends.size(), static_cast<int>(limit.count())) < 0 && errno != EINTR)
    return {.failure = std::strerror(errno)};
  return {.output = ends[0].revents != 0,
          .errors = ends[1].revents != 0,
          .input = ends[2].revents != 0,
          .end = ends[3].revents != 0};
}

void Child::wait_for_end(std::chrono::milliseconds limit) const {
  pollfd life{life_, POLLIN, 0};
  poll(&life, 1, static_cast<int>(limit.count()));
}

bool Child::write(std::string& text) const {
  while (!text.empty()) {
    const ssize_t n = ::write(in_, text.data(), text.size());
    if (n < 0) return errno == EAGAIN || errno == EINTR;
    text.erase(0, static_cast<std::size_t>(n));
  }
  return true;
}

void Child::close_input() { close_one(in_); }

Child::Read Child::read(std::string& into) {
  const ssize_t n = ::read(out_, buffer_.data(), buffer_.size());
  if (n > 0) into.append(buffer_.data(), static_cast<std::size_t>(n));
  if (n > 0) return Read::some;
  return n < 0 && (errno == EAGAIN || errno == EINTR) ? Read::later : Read::end;
}

void Child::read_errors(std::string& into, std::size_t kept) {
  if (err_ < 0) return;
  ssize_t n = 0;
  while ((n = ::read(err_, buffer_.data(), buffer_.size())) > 0) {
    into.append(buffer_.data(), static_cast<std::size_t>(n));
    if (into.size() > 2 * kept) into.erase(0, into.size() - kept);
  }
  if (n == 0 || (errno != EAGAIN && errno != EINTR)) close_one(err_);
}

std::optional<Child::End> Child::take_end() {
  int status = 0;
  rusage used{};
  if (wait4(pid_, &status, WNOHANG, &used) == 0) return {};
  note_end();
  End out{.memory = used.ru_maxrss, .inherited = inherited_};
  if (WIFSIGNALED(status)) {
    out.signal = signal_text(WTERMSIG(status));
  } else {
    out.code = WEXITSTATUS(status);
  }
  return out;
}

void Child::kill() {
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  note_end();
}

void Child::note_end() {
  has_ended_ = true;
  const std::lock_guard lock(leaders().mutex);
  leaders().pids.erase(pid_);
}

int Child::end_left_behind() const {
  int found = 0;
  // One that is forked while we look is found when we look again.
  for (int round = 0; round < 8; ++round) {
    const std::vector<pid_t> all = candidates();
    bool is_clean = true;
    for (const pid_t pid : all) {
      if (pid == pid_ || !is_marked(pid, mark_)) continue;
      ::kill(pid, SIGKILL);
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

}  // namespace graze::system
