// Runs every mutant against the laws until one breaks.
//
//   driver MUTANTS FOLDER --seconds S --jobs J --linear N --query N --rotating N
//
// A survey with no mutant alive comes first (kept in FOLDER/survey). Then each of the mutants 0 .. MUTANTS-1 runs in a
// process of its own. It runs the trials that execute its place, cheap ones first and others between them. It stops
// when a law breaks, the process dies, a trial takes kSlower times its usual time (an endless loop), or S seconds of
// processor time are over. FOLDER/results gets a line for each, and a second run resumes from there:
//   MUTANT killed|survived|unreached LAW HOW TRIALS SECONDS ASKED ANSWERS COSTS EXECUTED CASE
// separated by tabs. ASKED to EXECUTED are for survivors (compare.hpp). CASE is the hash of the case that showed a
// killed one. FOLDER/first, if it exists, has lines MUTANT LAW CASE with the trial that showed the mutant in an earlier
// run. Those trials come first.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "properties/edit/case.hpp"
#include "properties/mutants/compare.hpp"
#include "properties/mutants/mutants.hpp"
#include "properties/mutants/world.hpp"

namespace {

using namespace graze::mutants;  // the room

// A trial counts as an endless loop after this many times its usual time, and at least this much (s).
constexpr double kSlower = 50;
constexpr double kLeastTime = 3;
// Processor time for comparing the answers of a survivor, over that for its trials.
constexpr double kCompareShare = 0.5;
constexpr std::size_t kMemory = std::size_t{4} << 30;  // bytes

struct Options {
  int mutants = 0, jobs = 1;
  double seconds = 15;
  std::string folder;
  Counts counts;
};

// Progress of the child, in memory that outlives it.
struct Progress {
  std::uint32_t law, problem;
  long trials;
  bool trying, done, broken;
  char how[400];
  Difference difference;
};

double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void allow(double seconds) {
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(seconds) + 1;
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

std::size_t mixed(std::size_t x) { return (x + 1) * 0x9e3779b97f4a7c15u >> 13; }

// The trial that showed a mutant in an earlier run.
struct Shown {
  std::string law;
  std::uint64_t problem = 0;  // hash
};

std::map<int, Shown> shown_before(const std::string& path) {
  std::map<int, Shown> out;
  std::ifstream file(path);
  int mutant = 0;
  for (Shown one; file >> mutant >> one.law >> one.problem;) out[mutant] = one;
  return out;
}

// The trial that showed it before, by itself, or nothing if it no longer exists.
std::vector<const Trial*> first_of(const World& world, const Survey& survey, const Shown& shown, int mutant) {
  for (const Trial& trial : survey.trials) {
    if (trial.reaches(mutant) && world.laws[trial.law].name == shown.law &&
        graze::law::hash_of(world.cases[trial.problem]) == shown.problem)
      return {&trial};
  }
  return {};
}

// The cases whose trials execute the mutant's place, each with those trials. At even turns the cheapest remaining one
// comes next, at odd ones any, so that an expensive kind of case is also met within the budget.
std::vector<std::vector<const Trial*>> agenda_of(const Survey& survey, int mutant) {
  std::map<std::uint32_t, std::vector<const Trial*>> by_case;
  for (const Trial& trial : survey.trials) {
    if (trial.reaches(mutant)) by_case[trial.problem].push_back(&trial);
  }
  struct Entry {
    double seconds;
    std::uint32_t problem;
  };
  std::vector<Entry> cheap;
  for (const auto& [problem, trials] : by_case) {
    double seconds = 0;
    for (const Trial* trial : trials) seconds += trial->seconds;
    cheap.push_back({seconds, problem});
  }
  std::vector<Entry> any = cheap;
  std::sort(cheap.begin(), cheap.end(), [](const Entry& x, const Entry& y) { return x.seconds < y.seconds; });
  std::sort(any.begin(), any.end(),
            [](const Entry& x, const Entry& y) { return mixed(x.problem) < mixed(y.problem); });
  std::vector<std::vector<const Trial*>> out;
  std::set<std::uint32_t> taken;
  for (std::size_t i = 0; i < cheap.size(); ++i) {
    for (const Entry& next : {cheap[i], any[i]}) {
      if (!taken.insert(next.problem).second) continue;
      std::vector<const Trial*> trials = by_case[next.problem];
      std::sort(trials.begin(), trials.end(),
                [](const Trial* x, const Trial* y) { return x->seconds < y->seconds; });
      out.push_back(std::move(trials));
    }
  }
  return out;
}

void compare_all(const World& world, const std::vector<std::vector<const Trial*>>& agenda, int mutant,
                 double seconds, Progress& progress) {
  const double end = processor_seconds() + seconds;
  for (const std::vector<const Trial*>& trials : agenda) {
    std::set<graze::engine::Kind> kinds;
    for (const Trial* trial : trials) kinds.insert(world.laws[trial->law].kind);
    for (const graze::engine::Kind kind : kinds) {
      allow(kLeastTime + 4 * seconds);
      compare(kind, world.cases[trials.front()->problem], mutant, progress.difference);
    }
    if (processor_seconds() > end) return;
  }
}

[[noreturn]] void try_mutant(const World& world, const Survey& survey, int mutant, const Shown& shown,
                             double seconds, Progress& progress) {
  const rlimit memory = {kMemory, kMemory}, core = {0, 0};
  setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CORE, &core);
  auto agenda = agenda_of(survey, mutant);
  if (const auto first = first_of(world, survey, shown, mutant); !first.empty())
    agenda.insert(agenda.begin(), first);
  graze_mutants::active = mutant;
  const double end = processor_seconds() + seconds;
  for (const std::vector<const Trial*>& trials : agenda) {
    for (const Trial* trial : trials) {
      progress.law = trial->law;
      progress.problem = trial->problem;
      ++progress.trials;
      progress.trying = true;
      allow(std::max(kLeastTime, kSlower * static_cast<double>(trial->seconds)));
      const std::string fault = fault_of(world.laws[trial->law], world.cases[trial->problem]);
      progress.trying = false;
      if (fault.empty()) continue;
      std::strncpy(progress.how, fault.c_str(), sizeof progress.how - 1);
      progress.broken = true;
      _exit(0);
    }
    if (processor_seconds() > end) break;
  }
  progress.done = true;
  compare_all(world, agenda, mutant, kCompareShare * seconds, progress);
  const std::string fault = stall_fault(progress.difference);
  std::strncpy(progress.how, fault.c_str(), sizeof progress.how - 1);
  _exit(0);
}

std::string line_of(const World& world, const Progress& progress, int mutant, int status, double seconds) {
  std::string how = progress.how;
  const char* verdict = "survived";
  std::string law = progress.done ? "" : world.laws[progress.law].name;
  if (progress.done && !how.empty()) {
    verdict = "killed";
    law = "the cap of stalls";
  } else if (progress.broken) {
    verdict = "killed";
  } else if (!progress.done) {
    verdict = "killed";
    how = !WIFSIGNALED(status)            ? "left the process"
          : WTERMSIG(status) == SIGVTALRM ? "does not end"
                                          : std::string("crashed: ") + strsignal(WTERMSIG(status));
  } else if (progress.trials == 0) {
    verdict = "unreached";
  }
  std::replace_if(
      how.begin(), how.end(), [](unsigned char c) { return std::isspace(c) != 0; }, ' ');
  std::ostringstream out;
  const Difference& d = progress.difference;
  out << mutant << '\t' << verdict << '\t' << law << '\t' << how << '\t' << progress.trials << '\t' << seconds
      << '\t' << d.asked << '\t' << d.answers << '\t' << d.costs << '\t' << d.executed << '\t'
      << (progress.done ? 0 : graze::law::hash_of(world.cases[progress.problem])) << '\n';
  return out.str();
}

std::set<int> done_before(const std::string& path) {
  std::set<int> out;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) out.insert(std::atoi(line.c_str()));
  return out;
}

void run_all(const World& world, const Survey& survey, const Options& options) {
  const std::string path = options.folder + "/results";
  const std::set<int> done = done_before(path);
  std::map<int, Shown> shown = shown_before(options.folder + "/first");
  const auto slots = static_cast<std::size_t>(options.jobs);
  void* const shared =
      mmap(nullptr, slots * sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) std::abort();
  auto* const progress = static_cast<Progress*>(shared);
  struct Child {
    pid_t pid = 0;
    int mutant = 0;
  };
  std::vector<Child> children(slots);
  int next = 0, finished = 0, survived = 0;
  std::size_t running = 0;
  while (true) {
    for (std::size_t i = 0; i < slots; ++i) {
      while (next < options.mutants && done.count(next)) ++next;
      if (children[i].pid || next == options.mutants) continue;
      progress[i] = {};
      children[i] = {fork(), next++};
      if (children[i].pid < 0) std::abort();
      if (children[i].pid == 0) {
        const int mutant = children[i].mutant;
        try_mutant(world, survey, mutant, shown[mutant], options.seconds, progress[i]);
      }
      ++running;
    }
    if (running == 0) break;
    int status = 0;
    rusage usage = {};
    const pid_t ended = wait4(-1, &status, 0, &usage);
    const auto child =
        std::find_if(children.begin(), children.end(), [&](const Child& c) { return c.pid == ended; });
    if (child == children.end()) continue;
    const Progress& its = progress[child - children.begin()];
    const double seconds =
        static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
    std::ofstream(path, std::ios::app) << line_of(world, its, child->mutant, status, seconds);
    *child = {};
    --running;
    ++finished;
    survived += its.done && its.how[0] == '\0' ? 1 : 0;
    std::fprintf(stderr, "\rmutants: %d of %zu run, %d not noticed ", finished,
                 static_cast<std::size_t>(options.mutants) - done.size(), survived);
  }
  std::fprintf(stderr, "\n");
}

int number_at(const std::vector<std::string>& words, const char* name, int fallback) {
  const auto at = std::find(words.begin(), words.end(), name);
  return at == words.end() || at + 1 == words.end() ? fallback : std::atoi((at + 1)->c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2) {
    std::fprintf(
        stderr,
        "usage: driver MUTANTS FOLDER [--seconds S] [--jobs J] [--linear N] [--query N] [--rotating N]\n");
    return 2;
  }
  Options options;
  options.mutants = std::atoi(words[0].c_str());
  options.folder = words[1];
  options.seconds = number_at(words, "--seconds", 15);
  options.jobs = number_at(words, "--jobs", 1);
  options.counts = {.linear = number_at(words, "--linear", 600),
                    .query = number_at(words, "--query", 300),
                    .rotating = number_at(words, "--rotating", 100)};
  if (options.mutants < 1 || options.mutants > graze_mutants::kMost || options.jobs < 1) {
    std::fprintf(stderr, "driver: 1 to %d mutants, and at least one job\n", graze_mutants::kMost);
    return 2;
  }
  const World world = make_world(options.counts);
  Survey seen;
  if (!load(seen, options.folder + "/survey", options.mutants)) {
    seen = survey(world, options.mutants);
    save(seen, options.folder + "/survey", options.mutants);
    std::ofstream broken(options.folder + "/broken");
    for (const std::string& one : seen.broken) broken << one << '\n';
  }
  run_all(world, seen, options);
  return 0;
}
