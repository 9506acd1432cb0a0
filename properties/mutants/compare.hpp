// What a mutant changes in the methods' answers, whether or not a law notices.
#pragma once

#include "properties/any_law.hpp"

namespace graze::mutants {

struct Difference {
  long asked = 0;  // answers compared
  long answers =
      0;  // that differ in a bit of verdict, bracket, distance, normal, witness, or in having a proof
  long costs = 0;     // that are the same, at another cost (Counters)
  long executed = 0;  // executions in which the mutated value is not the original's
};

// Every method of the kind on the case, with the mutant and without, added to `sum`.
void compare(law::Kind kind, const corpus::Case& problem, int mutant, Difference& sum);

}  // namespace graze::mutants
