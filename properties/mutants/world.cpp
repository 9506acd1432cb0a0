#include "properties/mutants/world.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>

#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/mutants/aimed.hpp"
#include "properties/mutants/mutants.hpp"

namespace graze::mutants {

using engine::Kind;
using law::Law;
using law::Needs;

namespace {

double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// One case in four of those that go to the bracket oracle, which takes milliseconds: as for planted defects.
constexpr std::uint64_t kBracketShare = 4;

// One aimed case of each family for so many of the sample.
constexpr std::size_t kAimedShare = 60, kAimedRotatingShare = 20;

bool applies(const World& world, const Law& law, std::size_t problem) {
  if (problem >= world.ties_end) return law.kind == Kind::rotating;
  if (law.kind == Kind::rotating) return false;
  if (problem >= world.flat_end) return law.kind == Kind::linear && law.needs == Needs::proof;
  if (problem >= (law.kind == Kind::query ? world.queries_end : world.linear_end)) return false;
  const corpus::Case& one = world.cases[problem];
  return law.needs != Needs::oracle || law::is_exactly_decided(one) || law::hash_of(one) % kBracketShare == 0;
}

void append(std::vector<corpus::Case>& all, const std::vector<corpus::Case>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

template <class T>
void write(std::ofstream& file, const T& x) {
  file.write(reinterpret_cast<const char*>(&x), sizeof x);
}
template <class T>
bool read(std::ifstream& file, T& x) {
  return static_cast<bool>(file.read(reinterpret_cast<char*>(&x), sizeof x));
}

}  // namespace

World make_world(const Counts& counts) {
  World world;
  world.laws.assign(law::laws().begin(), law::laws().end());
  const int flat = std::max(counts.linear, counts.query);
  if (flat > 0) {
    law::Sample linear = law::sample_for(Kind::linear, flat);
    linear.all.resize(std::min(linear.all.size(), static_cast<std::size_t>(flat)));
    linear.ties.resize(std::min(linear.ties.size(), static_cast<std::size_t>(counts.linear)));
    append(world.cases, aimed_cases(static_cast<std::size_t>(flat) / kAimedShare));
    const std::size_t aimed = world.cases.size();
    append(world.cases, linear.all);
    world.linear_end = aimed + static_cast<std::size_t>(counts.linear);
    world.queries_end = aimed + static_cast<std::size_t>(counts.query);
    world.flat_end = world.cases.size();
    append(world.cases, linear.ties);
    world.ties_end = world.cases.size();
  }
  if (counts.rotating > 0) {
    append(world.cases,
           aimed_rotating_cases(static_cast<std::size_t>(counts.rotating) / kAimedRotatingShare));
    append(world.cases, law::sample_for(Kind::rotating, counts.rotating).all);
  }
  return world;
}

std::string fault_of(const Law& law, const corpus::Case& problem) {
  for (const engine::Method& method : law.methods()) {
    const law::LawResult result = law.check(problem, method);
    if (result.holding == law::Holding::broken) return method.question_name() + ": " + result.reason;
  }
  return "";
}

Survey survey(const World& world, int mutants) {
  Survey out;
  const std::size_t words = (static_cast<std::size_t>(mutants) + 63) / 64;
  graze_mutants::active = -1;
  for (std::size_t problem = 0; problem < world.cases.size(); ++problem) {
    if (problem % 20 == 0) std::fprintf(stderr, "\rsurvey: case %zu of %zu ", problem, world.cases.size());
    for (std::size_t i = 0; i < world.laws.size(); ++i) {
      const Law& law = world.laws[i];
      if (!applies(world, law, problem)) continue;
      std::fill_n(graze_mutants::reached, graze_mutants::kMost, static_cast<unsigned char>(0));
      const double before = processor_seconds();
      const std::string fault = fault_of(law, world.cases[problem]);
      Trial trial = {.law = static_cast<std::uint32_t>(i), .problem = static_cast<std::uint32_t>(problem)};
      trial.seconds = static_cast<float>(processor_seconds() - before);
      trial.reached.assign(words, 0);
      for (int m = 0; m < mutants; ++m) {
        if (graze_mutants::reached[m])
          trial.reached[static_cast<std::size_t>(m) / 64] |= std::uint64_t{1} << (m % 64);
      }
      if (!fault.empty()) {
        out.broken.push_back(law.name + " " + fault + "\n" + corpus::write_case(world.cases[problem]));
      } else if (std::any_of(trial.reached.begin(), trial.reached.end(), [](auto w) { return w != 0; })) {
        out.trials.push_back(std::move(trial));
      }
    }
  }
  std::fprintf(stderr, "\rsurvey: %zu trials on %zu cases, %zu broken without a mutant\n", out.trials.size(),
               world.cases.size(), out.broken.size());
  return out;
}

void save(const Survey& survey, const std::string& path, int mutants) {
  std::ofstream file(path, std::ios::binary);
  write(file, mutants);
  write(file, survey.trials.size());
  for (const Trial& trial : survey.trials) {
    write(file, trial.law);
    write(file, trial.problem);
    write(file, trial.seconds);
    for (const std::uint64_t word : trial.reached) write(file, word);
  }
}

bool load(Survey& survey, const std::string& path, int mutants) {
  std::ifstream file(path, std::ios::binary);
  int held = 0;
  std::size_t count = 0;
  if (!file || !read(file, held) || held != mutants || !read(file, count)) return false;
  survey.trials.assign(count, {});
  for (Trial& trial : survey.trials) {
    trial.reached.assign((static_cast<std::size_t>(mutants) + 63) / 64, 0);
    if (!read(file, trial.law) || !read(file, trial.problem) || !read(file, trial.seconds)) return false;
    for (std::uint64_t& word : trial.reached) {
      if (!read(file, word)) return false;
    }
  }
  return true;
}

}  // namespace graze::mutants
