// Properties that every option of every command has.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>

namespace graze::tool {

// More cases than a machine judges in a year, and few enough that no sum of them overflows.
inline constexpr std::uint64_t kMostCases = 1'000'000'000;
inline constexpr std::uint64_t kMostThreads = 1024;

// A whole number, in digits, of this range: no sign, no fraction, and nothing too large to be read.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least = 0, std::uint64_t most = kMostCases);
// A number of this range: not "nan", and finite.
[[nodiscard]] CLI::Validator number_from(double least = std::numeric_limits<double>::lowest(),
                                         double most = std::numeric_limits<double>::max());
// Any that a generator of cases begins with.
[[nodiscard]] CLI::Validator seed_number();

// An option that is given an empty value ("--save ''") is an error, and is not taken for one that is not
// given. For the app and every command in it.
void refuse_empty_values(CLI::App& app);

// As a word of a shell's command line, in quotes if needed.
[[nodiscard]] std::string shell_word(const std::string& word);

}  // namespace graze::tool
