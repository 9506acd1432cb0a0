// Generated cases aimed at code that the sample of planted defects rarely executes: the harder half of each family's
// levels, which that sample leaves out, and hulls that have a map of directions.
#pragma once

#include <vector>

#include "corpus/case.hpp"

namespace graze::mutants {

// A case of each family a round, and a large hull.
[[nodiscard]] std::vector<corpus::Case> aimed_cases(std::size_t rounds);
[[nodiscard]] std::vector<corpus::Case> aimed_rotating_cases(std::size_t rounds);

}  // namespace graze::mutants
