#include "reports/text/stop.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

namespace graze::tool {
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

StopBySignal::StopBySignal() {
  g_signal = 0;
  g_first = 0;
  g_on_terminal = isatty(STDERR_FILENO) != 0;
  for (const int number : {SIGINT, SIGTERM}) handle(number, &note_signal);
}

// After a request the handler stays, because its other signals may arrive while the results are written.
StopBySignal::~StopBySignal() {
  if (g_signal != 0) return;
  for (const int number : {SIGINT, SIGTERM}) handle(number, SIG_DFL);
}

int StopBySignal::received() { return g_signal; }

}  // namespace graze::tool
