// Tries every law, over files, families or all that is built in.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/commands/judged_options.hpp"

namespace graze::tool {

struct LawArguments : JudgedArguments {
  std::vector<std::string> laws;  // by name, empty for all
  std::string report;
};

// Cases of a family. For a linear case all laws together take tens of milliseconds. For a rotating case the oracle
// takes between a tenth of a second and several seconds.
inline constexpr std::size_t kLinearLawCases = 40, kRotatingLawCases = 4;

// Returns the exit code: 1 if a law is broken, 2 for bad input or nothing to judge, and 128 plus its number after a
// signal.
[[nodiscard]] int try_laws(const LawArguments& arguments);

}  // namespace graze::tool
