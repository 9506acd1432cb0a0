// Runs `graze certify` on a planted defect. It asks the methods of a kind every question of a run, and judges the
// answers that differ from those without the defect (certify/answers.hpp).
//
//   certify keep KIND COUNTS FILE    judges every answer and keeps the results: without a defect.
//   certify differ KIND COUNTS FILE  judges the answers that differ from the kept ones: for a defect in methods.
//   certify whole KIND COUNTS        judges every answer: for a defect in a judge.
//
// KIND: linear, query, rotating. COUNTS: default or thorough, as the command counts them, or three numbers: the cases
// of a linear family, those of a rotating one, and the bodies for queries, as in 40,1,2.
//
// The standard output has "broken: ROW" for each guarantee that breaks. Before it, `differ` prints "differing N of M".
// The exit code is 1 if a guarantee breaks, 2 for a wrong call. A method that takes more than twenty times the
// processor time of the kept run is killed by SIGXCPU. One that takes gigabytes of memory is stopped by its own
// allocation.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/answers.hpp"
#include "certify/built_in.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_io.hpp"

namespace {

using namespace graze::tool;  // the room that is tried
namespace engine = graze::engine;
namespace corpus = graze::corpus;

constexpr std::array kKinds = {engine::Kind::linear, engine::Kind::query, engine::Kind::rotating};

// A run without a defect is measured while others share the machine, and a short one in hundredths of a second.
constexpr double kTimesSlower = 20, kSecondsMore = 30;
constexpr rlim_t kMostMemory = rlim_t{4} << 30;

int usage(const char* what) {
  std::fprintf(stderr,
               "%s\nusage: certify keep|differ linear|query|rotating default|thorough|L,R,Q FILE, or "
               "certify whole KIND COUNTS\n",
               what);
  return 2;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void limit(int resource, rlim_t most) {
  rlimit both = {};
  getrlimit(static_cast<__rlimit_resource>(resource), &both);
  both.rlim_cur = std::min(most, both.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

std::optional<Counts> counts_of(const std::string& text) {
  if (text == "default") return kUsual;
  if (text == "thorough") return kThorough;
  Counts counts = {};
  char rest = 0;
  if (std::sscanf(text.c_str(), "%zu,%zu,%zu%c", &counts.linear, &counts.rotating, &counts.queries, &rest) !=
      3)
    return {};
  return counts;
}

// The suites of a kind in a run of `graze certify` without arguments but --thorough.
std::vector<Suite> suites_of(engine::Kind kind, Counts counts,
                             const std::vector<const engine::Method*>& methods) {
  if (kind == engine::Kind::rotating) counts.linear = 0;
  if (kind != engine::Kind::rotating) counts.rotating = 0;
  const corpus::ReadResult curated = corpus::read_directory(corpus::corpus_directory() / "cases");
  if (!curated.ok()) throw std::runtime_error(curated.errors.front().text());
  Intake intake;
  intake.take("curated", curated.cases, true);
  take_families(intake, wanted_families({}, false), counts, 1, kOracleEvery);
  if (kind == engine::Kind::query) take_queries(intake, counts);
  intake.leave_out(methods, {});
  return intake.suites;
}

std::size_t count_of(const std::vector<std::vector<bool>>& cases, bool value) {
  std::size_t count = 0;
  for (const std::vector<bool>& suite : cases) {
    count += static_cast<std::size_t>(std::count(suite.begin(), suite.end(), value));
  }
  return count;
}

struct Kept {
  double seconds = 0;  // that the methods took to answer
  KeptAnswers answers;
};
Kept read_kept(const std::string& name) {
  std::ifstream file(name);
  double seconds = 0;
  if (!(file >> seconds)) throw std::runtime_error(name + ": no kept answers");
  return {seconds, KeptAnswers::read(file)};
}

int run(const std::string& how, engine::Kind kind, Counts counts, const std::string& name) {
  Settings settings;
  for (const engine::Method& method : engine::methods(kind)) settings.methods.push_back(&method);
  const std::vector<Suite> suites = suites_of(kind, counts, settings.methods);
  std::optional<Kept> kept;
  if (how == "differ") {
    kept = read_kept(name);
    limit(RLIMIT_CPU, static_cast<rlim_t>(processor_seconds() + kSecondsMore + kTimesSlower * kept->seconds));
    limit(RLIMIT_AS, kMostMemory);
  }
  const double before = processor_seconds();
  KeptAnswers answers(suites, settings.methods, settings.threads);
  const double seconds = processor_seconds() - before;
  std::vector<std::string> broken;
  if (how == "keep") {
    broken = judge_all(suites, settings, answers);
    std::ofstream file(name);
    file << seconds << '\n';
    answers.write(file);
    if (!file.flush()) throw std::runtime_error(name + ": cannot be written");
  } else {
    std::vector<std::vector<bool>> differing;
    if (kept) {
      limit(RLIMIT_CPU, RLIM_INFINITY);
      differing = answers.differ_from(kept->answers);
      std::printf("differing %zu of %zu\n", count_of(differing, true),
                  count_of(differing, true) + count_of(differing, false));
      std::fflush(stdout);
    } else {
      for (const Suite& suite : suites) differing.emplace_back(suite.size(), true);
    }
    broken = judge_differing(suites, settings, kept ? kept->answers : answers, differing);
  }
  for (const std::string& line : broken) std::printf("broken: %s\n", line.c_str());
  return broken.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 3) return usage("too few words");
  const bool takes_file = words[0] == "keep" || words[0] == "differ";
  if (!takes_file && words[0] != "whole") return usage("no such way");
  if (words.size() != (takes_file ? 4 : 3))
    return usage("a file where one is written or read, and only there");
  const auto kind =
      std::find_if(kKinds.begin(), kKinds.end(), [&](auto one) { return to_text(one) == words[1]; });
  if (kind == kKinds.end()) return usage("no such kind of methods");
  const std::optional<Counts> counts = counts_of(words[2]);
  if (!counts) return usage("no such counts");
  try {
    return run(words[0], *kind, *counts, takes_file ? words[3] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
