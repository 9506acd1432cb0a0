// Which mutant is alive in programs that do not choose it themselves: GRAZE_MUTANT, a number, from the
// environment, before anything else runs.
#include <cstdlib>

#include "properties/mutants/mutants.hpp"

namespace graze_mutants {

int active = -1;
bool comparing = false;
unsigned char reached[kMost] = {};
long differed[kMost] = {};

namespace {
// Before the constructors of everything else.
[[gnu::constructor(101)]] void choose() {
  if (const char* number = std::getenv("GRAZE_MUTANT")) active = std::atoi(number);
}
}  // namespace

}  // namespace graze_mutants
