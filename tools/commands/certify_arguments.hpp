// The command line of `graze certify`.
#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

#include "certify/built_in.hpp"
#include "tools/commands/judged_options.hpp"

namespace graze::tool {

// Cases that a report holds in full: a page of more takes long to make, and to open.
struct ReportDefaults {
  static constexpr std::size_t kCases = 20, kMost = 1000;
};

struct CertifyArguments : JudgedArguments {
  std::optional<std::size_t> queries;  // default: see counts()
  std::size_t oracle_every = kOracleEvery;
  bool full = false, thorough = false, fail_fast = false;
  std::string json, junit, findings, report;
  std::size_t report_cases = ReportDefaults::kCases;

  // Standard output has one document. If a document goes there, the text goes to stderr.
  [[nodiscard]] std::FILE* screen() const {
    return save == "-" || json == "-" || junit == "-" ? stderr : stdout;
  }
  [[nodiscard]] Counts counts() const {
    const Counts& usual = thorough ? kThorough : kUsual;
    return {count.value_or(usual.linear), rotating.value_or(usual.rotating), queries.value_or(usual.queries)};
  }
};

}  // namespace graze::tool
