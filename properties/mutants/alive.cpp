// Selects the mutant in programs that do not choose it themselves. It is GRAZE_MUTANT, a number, from the environment,
// read before anything else runs. At the end the numbers of the mutants whose place was executed are written to the
// file GRAZE_MUTANT_REACHED, if it is named.
#include <cstdio>
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

[[gnu::destructor(101)]] void report() {
  const char* const name = std::getenv("GRAZE_MUTANT_REACHED");
  std::FILE* const file = name ? std::fopen(name, "w") : nullptr;
  if (!file) return;
  for (int i = 0; i < kMost; ++i) {
    if (reached[i]) std::fprintf(file, "%d\n", i);
  }
  std::fclose(file);
}
}  // namespace

}  // namespace graze_mutants
