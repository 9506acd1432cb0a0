// The changes that a mutant makes to the methods' answers, whether or not a law notices.
#pragma once

#include <array>
#include <string>

#include "properties/laws/law.hpp"

namespace graze::mutants {

// Answers of one method that end undecided, or that are marked as wide.
struct Stalls {
  long asked = 0, without = 0, with = 0;  // the mutant
};

struct Difference {
  long asked = 0;  // answers compared
  long answers =
      0;  // that differ in a bit of verdict, bracket, distance, normal, witness, or in having a proof
  long costs = 0;                      // that are the same, at another cost (Counters)
  long executed = 0;                   // executions in which the mutated value is not the original's
  std::array<Stalls, 96> stalls = {};  // linear methods, queries, rotating methods
};

// Every method of the kind on the case, with the mutant and without, added to `sum`.
void compare(engine::Kind kind, const corpus::Case& problem, int mutant, Difference& sum);

// The first method that ends undecided more often than its guarantee grants, and more often than without the mutant.
// Empty if none does. The cap is a share of a family's cases, here of those compared.
[[nodiscard]] std::string stall_fault(const Difference& sum);

}  // namespace graze::mutants
