// The judge of the mutants: all laws, on the generated cases that planted defects see too. For each pair of law and
// case it records the mutants whose place it executes, and the cost, measured once with none of them alive.
//
// A mutant then meets only the pairs that execute its place. The rest cannot notice it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "properties/defects/sample.hpp"
#include "properties/laws/law.hpp"

namespace graze::mutants {

struct Counts {
  int linear = 0, query = 0, rotating = 0;  // cases, with as many near-ties as linear
};

struct World {
  std::vector<law::Law> laws;
  std::vector<corpus::Case> cases;  // aimed, linear, near-ties, aimed rotating, rotating
  // Their ends. Casts and the other queries run on the aimed cases and the first of the linear ones.
  std::size_t linear_end = 0, queries_end = 0, flat_end = 0, ties_end = 0;
};

// A law on a case, over all methods.
struct Trial {
  std::uint32_t law = 0, problem = 0;
  float seconds = 0;                        // processor time, the oracle's share included
  std::vector<std::uint64_t> reached = {};  // a bit a mutant
  [[nodiscard]] bool reaches(int mutant) const {
    return (reached[static_cast<std::size_t>(mutant) / 64] >> (mutant % 64) & 1) != 0;
  }
};

struct Survey {
  std::vector<Trial> trials;
  // Trials whose law breaks with no mutant alive, which give no information. "LAW METHOD: reason" and the
  // case, one a trial.
  std::vector<std::string> broken;
};

[[nodiscard]] World make_world(const Counts& counts);
// The first method that breaks the law, and how. Empty if all keep it.
[[nodiscard]] std::string fault_of(const law::Law& law, const corpus::Case& problem);
// Tries everything with no mutant alive. Progress on the standard error.
[[nodiscard]] Survey survey(const World& world, int mutants);

void save(const Survey& survey, const std::string& path, int mutants);
// False if there is no such file, or one of another number of mutants.
[[nodiscard]] bool load(Survey& survey, const std::string& path, int mutants);

}  // namespace graze::mutants
