// graze certify --stability: measures the families one by one, prints what it finds, draws the curves.
#pragma once

#include "certify/stability.hpp"

namespace graze::tool {

struct StabilityRun {
  StabilitySettings settings;
  std::vector<const corpus::Family*> families;
  bool by_level = false;  // also print each family's curves
  std::string plot;       // the folder of the pictures; empty for none
  std::string save;       // the file of the cases at fault; empty for none
};

// The exit code: 1 if a method breaks its row, 2 if there is nothing to measure; of a stop by signal 128 and its number.
int run_stability(const StabilityRun& run);

}  // namespace graze::tool
