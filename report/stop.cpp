#include "report/stop.hpp"

#include <atomic>
#include <csignal>

namespace graze::tool {
namespace {

std::atomic<int> g_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a handler of signals may only use such");

void note_signal(int number) { g_signal = number; }

void handle(int number, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

}  // namespace

StopBySignal::StopBySignal() {
  g_signal = 0;
  for (const int number : {SIGINT, SIGTERM}) handle(number, &note_signal);
}

StopBySignal::~StopBySignal() {
  for (const int number : {SIGINT, SIGTERM}) handle(number, SIG_DFL);
}

int StopBySignal::received() { return g_signal; }

}  // namespace graze::tool
