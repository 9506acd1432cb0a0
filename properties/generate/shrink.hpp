// Making a failing case small: fewer parts and vertices, simpler poses, integers near zero.
#pragma once

#include <functional>
#include <vector>

#include "corpus/case.hpp"

namespace graze::law {

// Cases simpler than this one, the boldest first. Each has a smaller measure (parts, vertices, the bits of
// its numbers), so any chain of them ends.
[[nodiscard]] std::vector<corpus::Case> simpler(const corpus::Case& problem);

// Greedy descent: while one of simpler() still fails, it takes its place. At most `budget` calls of `fails`.
[[nodiscard]] corpus::Case minimised(corpus::Case problem,
                                     const std::function<bool(const corpus::Case&)>& fails,
                                     int budget = 20000);

}  // namespace graze::law
