// What the command line of `graze certify` says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "certify/built_in.hpp"
#include "tools/commands/engines.hpp"

namespace graze::tool {

// Cases of each level of a family, for curves of error against hardness: the oracle measures every one, of
// curved shapes in tens of milliseconds.
inline constexpr std::size_t kLevelCases = 40, kRotatingLevelCases = 12;

// Cases that a report holds in full: a page of more takes long to make, and to open.
struct ReportDefaults {
  static constexpr std::size_t kCases = 20, kMost = 1000;
};

struct CertifyArguments {
  std::vector<std::string> files, families, methods, law_names;
  EngineArguments engines;
  std::optional<std::size_t> count, rotating, queries;  // defaults: see above
  std::size_t oracle_every = kOracleEvery;
  bool stability = false, laws = false, full = false, thorough = false, fail_fast = false;
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
  std::string corpus, guarantees, save, plot, json, junit, findings, report;
  std::size_t report_cases = ReportDefaults::kCases;

  // Standard output is one thing's: beside a document that goes there the text goes to stderr.
  [[nodiscard]] std::FILE* screen() const {
    return save == "-" || json == "-" || junit == "-" ? stderr : stdout;
  }
  // All of ours, unless engines of others are to be judged.
  [[nodiscard]] std::vector<std::string> our_methods() const {
    return methods.empty() && engines.commands.empty() ? std::vector<std::string>{"all"} : methods;
  }
  [[nodiscard]] Counts counts() const {
    const Counts& usual = thorough ? kThorough : kUsual;
    return {count.value_or(usual.linear), rotating.value_or(usual.rotating), queries.value_or(usual.queries)};
  }
  [[nodiscard]] bool takes_curated() const { return files.empty() && families.empty(); }
};

}  // namespace graze::tool
