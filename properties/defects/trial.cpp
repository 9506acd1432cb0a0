#include "properties/defects/trial.hpp"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {

using corpus::Case;

namespace {

// The first method that breaks the law, and how. Empty if all keep it.
std::string fault_of(const Law& law, const Case& problem) {
  for (const Method& method : law.methods()) {
    const LawResult result = law.check(problem, method);
    if (result.holding == Holding::broken) return method.question_name() + ": " + result.reason;
  }
  return "";
}

// The bracket oracle takes milliseconds for a case, several times the cost of all other laws. The laws that need an
// oracle therefore get one in kBracketShare of the cases that go to it, chosen by their own numbers.
constexpr std::uint64_t kBracketShare = 4;
bool is_left_out(const Law& law, const Case& problem) {
  return law.kind != Kind::rotating && law.needs == Needs::oracle && !is_exactly_decided(problem) &&
         hash_of(problem) % kBracketShare != 0;
}

// Progress of the process that tries the laws, in memory that outlives it.
struct Progress {
  static constexpr std::size_t kMostLaws = 256;
  std::size_t at = 0;   // the case, counted over `all` and then `ties`
  std::size_t law = 0;  // the law being tried on it
  bool trying = false;
  bool broken[kMostLaws] = {};
};

// Seconds of processor time that one law may take on one case. The slowest without a defect take 0.5.
constexpr int kSecondsForOne = 20;

void let_it_run(int seconds) {
  const itimerval timer = {{0, 0}, {seconds, 0}};
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

const Case& case_at(const Sample& sample, std::size_t at) {
  return at < sample.all.size() ? sample.all[at] : sample.ties[at - sample.all.size()];
}

void say(const Law& law, const char* what, std::size_t number) {
  std::printf("%s %s %zu\n", law.name.c_str(), what, number);
  std::fflush(stdout);
}

bool applies(const Law& law, const Sample& sample, std::size_t at) {
  if (at >= sample.all.size()) return law.needs == Needs::proof;
  return !is_left_out(law, sample.all[at]);
}

// Case by case, so that the laws share the oracle's answer for it.
void run(const std::vector<Law>& laws, const Sample& sample, Progress& progress, bool with_reasons) {
  const std::size_t cases = sample.all.size() + sample.ties.size();
  for (; progress.at < cases; ++progress.at) {
    const Case& problem = case_at(sample, progress.at);
    for (; progress.law < laws.size(); ++progress.law) {
      const Law& law = laws[progress.law];
      if (progress.broken[progress.law] || !applies(law, sample, progress.at)) continue;
      let_it_run(kSecondsForOne);
      progress.trying = true;
      const std::string fault = fault_of(law, problem);
      progress.trying = false;
      if (fault.empty()) continue;
      progress.broken[progress.law] = true;
      say(law, "broken", progress.at);
      if (with_reasons) std::fprintf(stderr, "%s\n%s\n", fault.c_str(), corpus::write_case(problem).c_str());
    }
    progress.law = 0;
    if (std::all_of(progress.broken, progress.broken + laws.size(), [](bool one) { return one; })) return;
  }
}

}  // namespace

std::vector<Law> laws_of(Kind kind) {
  const std::span<const Law> of_kind = laws(kind);
  std::vector<Law> out(of_kind.begin(), of_kind.end());
  std::stable_sort(out.begin(), out.end(), [](const Law& x, const Law& y) { return x.needs < y.needs; });
  return out;
}

bool try_laws(const std::vector<Law>& laws, const Sample& sample, bool with_reasons) {
  void* const shared =
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED || laws.size() > Progress::kMostLaws) std::abort();
  Progress& progress = *new (shared) Progress;
  while (true) {
    const pid_t child = fork();
    if (child < 0) std::abort();
    if (child == 0) {
      run(laws, sample, progress, with_reasons);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    // A law died of the methods' defect on this case. The others continue. Anything else is our own fault.
    if (!progress.trying || (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)) std::abort();
    const bool hangs = WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM;
    say(laws[progress.law], hangs ? "hangs" : "crashed", progress.at);
    progress.broken[progress.law] = true;
    progress.trying = false;
  }
  bool any = false;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    any = any || progress.broken[i];
    if (!progress.broken[i]) say(laws[i], "holds", sample.all.size());
  }
  return any;
}

}  // namespace graze::law
