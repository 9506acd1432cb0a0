// How much `graze certify` judges when it is given no number of its own, and the suites that are drawn for it.
#pragma once

#include <cstdint>
#include <span>

#include "certify/intake.hpp"

namespace graze::tool {

// The numbers of generated cases: of a family of linear casts, of a family of rotating casts, and of a family whose
// bodies are asked the other queries. A cast is judged by its proof, in microseconds. A query takes the exact oracle
// milliseconds, and a rotating cast takes the bracket oracle tens of milliseconds. The defaults give a verdict in a
// minute, and the second set is for --thorough.
struct Counts {
  std::size_t linear, rotating, queries;
};
inline constexpr Counts kUsual = {512, 12, 20}, kThorough = {4000, 60, 100};

// The exact oracle measures one generated linear cast in this number, in addition to those that it must decide.
inline constexpr std::size_t kOracleEvery = 20;

// A suite of each family, after those that are there.
void take_families(Intake& intake, std::span<const corpus::Family* const> families, const Counts& counts,
                   std::uint64_t seed, std::size_t oracle_every);
// Adds one more suite for each suite of linear casts, in which its bodies are asked the other queries.
void take_queries(Intake& intake, const Counts& counts);

}  // namespace graze::tool
