// Which families a command line asks for, and the cases that it draws of them.
#pragma once

#include <string>
#include <vector>

#include "certify/linear.hpp"
#include "corpus/families.hpp"

namespace graze::tool {

// The families by these names; without a name every family, unless files are given instead. Throws
// std::runtime_error with one line to show for a name that is none.
[[nodiscard]] std::vector<const corpus::Family*> wanted_families(const std::vector<std::string>& names,
                                                                 bool files_are_given);

// `count` cases, spread over the levels of hardness: level by level, since a sample of every k-th case of
// levels that alternate would miss levels whenever k and their number have a common factor. The seeds are
// those of cases dealt to the levels in turn, from `seed` on.
[[nodiscard]] Suite drawn_suite(const corpus::Family& family, std::span<const double> levels,
                                std::size_t count, std::uint64_t seed);

}  // namespace graze::tool
