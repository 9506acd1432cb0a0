#include "reports/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>

#include "engines/system/system.hpp"

namespace graze::tool {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr auto kPace = std::chrono::milliseconds(100);
constexpr double kFirstLine = 10, kNextLine = 20;

// The start of the command, and the time after it, in seconds, at which the next line of a log is due.
const Clock::time_point g_start = Clock::now();
std::atomic<double> g_due = kFirstLine;

}  // namespace

std::string duration_text(double seconds) {
  const long long whole = std::llround(seconds);
  if (whole < 100) return fmt::format("{} s", whole);
  const long long minutes = (whole + 30) / 60;
  return minutes < 100 ? fmt::format("{} min", minutes)
                       : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

Progress::Progress(std::string label, std::uint64_t total, std::uint64_t before, Show show)
    : label_(std::move(label)),
      kind_(show),
      total_(total),
      before_(before),
      done_(before),
      on_terminal_(system::is_stderr_a_terminal()) {}

Progress::~Progress() { wipe(); }

void Progress::wipe() const {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::step() {
  const std::lock_guard lock(mutex_);
  ++done_;
  show({});
}

void Progress::reach(std::uint64_t done, const std::string& more) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  show(more);
}

void Progress::advance(std::uint64_t by, const std::string& more) {
  const std::lock_guard lock(mutex_);
  done_ += by;
  show(more);
}

std::string Progress::text_of_done() const {
  if (kind_ == Show::counts) return fmt::format("{}: {} of {}", label_, done_, total_);
  constexpr std::uint64_t kBar = 30;
  const std::uint64_t of = std::max<std::uint64_t>(total_, 1);
  const std::uint64_t full = std::min(kBar, kBar * done_ / of);
  const std::string bar = std::string(full, '#') + std::string(kBar - full, '.');
  return fmt::format("{}: {}{} %", label_, on_terminal_ ? "[" + bar + "] " : "", 100 * done_ / of);
}

void Progress::show(const std::string& more) {
  const auto now = Clock::now();
  if (on_terminal_) {
    if (now - shown_ < kPace) return;
    shown_ = now;
  } else {
    const double ran = Seconds(now - g_start).count();
    double due = g_due;
    if (ran < due || !g_due.compare_exchange_strong(due, ran + kNextLine)) return;
  }
  std::string text = text_of_done();
  if (!more.empty()) text += ", " + more;
  if (const double seconds = Seconds(now - start_).count(); done_ > before_ && seconds > 1) {
    const double rate = static_cast<double>(done_ - before_) / seconds;
    if (kind_ == Show::counts) text += fmt::format(", {:.3g} a second", rate);
    text += fmt::format(", {} left", duration_text(static_cast<double>(total_ - done_) / rate));
  }
  std::fputs((on_terminal_ ? "\r\033[K" + text : "graze: " + text + "\n").c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace graze::tool
