// Does a law notice a planted defect? Runs laws over generated cases until one breaks.
//
//   driver LAW CASES    exit 0: the law held on all of them; 1: it broke, and the reason is printed; 2: no
//   such
//                       law
//   driver --all CASES  one line a law of linear casts that breaks; exit 1 if one does
//   driver --all-turning CASES  the same of rotating casts
//   driver --laws       the names of both
//
// The methods come from the translation units that it is linked with: run.sh compiles one or both against
// patched headers of core, and leaves everything else as it is.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "corpus/case_io.hpp"
#include "corpus/families.hpp"
#include "properties/case_edit.hpp"
#include "properties/draw_case.hpp"
#include "properties/draw_rotating.hpp"
#include "properties/judge.hpp"
#include "properties/law.hpp"
#include "properties/laws_rotating.hpp"

namespace {

using graze::corpus::Case;

// Half drawn, half from the easier levels of the families: the same cases in every run. Laws that judge by
// proof, in microseconds, get near-ties as well, ten times as many.
std::vector<Case> sample(int count) {
  std::vector<Case> all;
  graze::corpus::Random random(20260117);
  for (int seed = 0; static_cast<int>(all.size()) < count; ++seed) {
    for (const graze::corpus::Family& family : graze::corpus::families()) {
      const std::size_t level = static_cast<std::size_t>(seed) % ((family.levels.size() + 1) / 2);
      all.push_back(family.generate(family.levels[level], static_cast<std::uint64_t>(seed)));
      all.push_back(graze::law::draw_case(random, seed % 100));
    }
  }
  return all;
}

// The bracket oracle takes milliseconds for a case, several times what all laws else take: the laws that need
// an oracle see one in kBracketShare of the cases that go to it, chosen by their own numbers.
constexpr std::uint64_t kBracketShare = 4;
bool is_left_out(const graze::law::Law& law, const Case& problem) {
  return law.needs == graze::law::Needs::oracle && !graze::law::is_exactly_decided(problem) &&
         graze::law::hash_of(problem) % kBracketShare != 0;
}

std::vector<Case> near_ties(int count) {
  std::vector<Case> all;
  all.reserve(static_cast<std::size_t>(count));
  graze::corpus::Random random(20261122);
  for (int i = 0; i < count; ++i) all.push_back(graze::law::draw_near_tie(random));
  return all;
}

// The number of cases before the law broke, or -1.
int first_broken(const graze::law::Law& law, const std::vector<Case>& cases, bool print) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (is_left_out(law, cases[i])) continue;
    for (const graze::engine::EngineMethod& method : graze::engine::methods()) {
      const graze::law::LawResult result = law.check(cases[i], method);
      if (result.holding != graze::law::Holding::broken) continue;
      if (print) {
        std::printf("%s: %s\n%s\n", method.full_name().c_str(), result.reason.c_str(),
                    graze::corpus::write_case(cases[i]).c_str());
      }
      return static_cast<int>(i);
    }
  }
  return -1;
}

int first_broken(const graze::law::Law& law, const std::vector<Case>& cases, const std::vector<Case>& ties,
                 bool print) {
  const int first = first_broken(law, cases, print);
  if (first >= 0 || law.needs != graze::law::Needs::proof) return first;
  const int tie = first_broken(law, ties, print);
  return tie < 0 ? tie : static_cast<int>(cases.size()) + tie;
}

// Drawn, and every eighth from the rotating families: the same cases in every run.
std::vector<Case> turning_sample(int count) {
  std::vector<Case> all;
  graze::corpus::Random random(20261121);
  const auto families = graze::corpus::rotating_families();
  for (int i = 0; static_cast<int>(all.size()) < count; ++i) {
    if (i % 8 != 7) {
      all.push_back(graze::law::draw_rotating(random, i % 100));
      continue;
    }
    const std::size_t turn = static_cast<std::size_t>(i) / 8;
    const graze::corpus::Family& family = families[turn % families.size()];
    const std::size_t level = turn / families.size() % ((family.levels.size() + 1) / 2);
    all.push_back(family.generate(family.levels[level], turn));
  }
  return all;
}

int first_broken(const graze::law::RotatingLaw& law, const std::vector<Case>& cases, bool print) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const graze::engine::RotatingEngineMethod& method : graze::engine::rotating_methods()) {
      const graze::law::LawResult result = law.check(cases[i], method);
      if (result.holding != graze::law::Holding::broken) continue;
      if (print) {
        std::printf("%s: %s\n%s\n", method.full_name().c_str(), result.reason.c_str(),
                    graze::corpus::write_case(cases[i]).c_str());
      }
      return static_cast<int>(i);
    }
  }
  return -1;
}

int every_turning_law(int count) {
  const std::vector<Case> cases = turning_sample(count);
  bool broken = false;
  for (const graze::law::RotatingLaw& law : graze::law::rotating_laws()) {
    const int first = first_broken(law, cases, false);
    broken = broken || first >= 0;
    if (first >= 0) std::printf("  %-32s broken by case %d\n", std::string(law.name).c_str(), first);
  }
  return broken ? 1 : 0;
}

int said(const char* law, int first, std::size_t cases) {
  if (first < 0) {
    std::printf("%s holds on %zu cases\n", law, cases);
    return 0;
  }
  std::printf("%s is broken by case %d\n", law, first);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--laws") == 0) {
    for (const graze::law::Law& law : graze::law::laws()) std::printf("%s\n", std::string(law.name).c_str());
    for (const graze::law::RotatingLaw& law : graze::law::rotating_laws())
      std::printf("%s\n", std::string(law.name).c_str());
    return 0;
  }
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s LAW|--all|--all-turning CASES, or --laws\n", argv[0]);
    return 2;
  }
  const int count = std::atoi(argv[2]);
  if (std::strcmp(argv[1], "--all-turning") == 0) return every_turning_law(count);
  if (const graze::law::RotatingLaw* turning = graze::law::find_rotating_law(argv[1])) {
    return said(argv[1], first_broken(*turning, turning_sample(count), true),
                static_cast<std::size_t>(count));
  }
  const std::vector<Case> cases = sample(count), ties = near_ties(10 * count);
  if (std::strcmp(argv[1], "--all") == 0) {
    bool broken = false;
    for (const graze::law::Law& law : graze::law::laws()) {
      const int first = first_broken(law, cases, ties, false);
      broken = broken || first >= 0;
      if (first >= 0) std::printf("  %-22s broken by case %d\n", std::string(law.name).c_str(), first);
    }
    return broken ? 1 : 0;
  }
  const graze::law::Law* law = graze::law::find_law(argv[1]);
  if (!law) {
    std::fprintf(stderr, "no law %s\n", argv[1]);
    return 2;
  }
  return said(argv[1], first_broken(*law, cases, ties, true), cases.size());
}
