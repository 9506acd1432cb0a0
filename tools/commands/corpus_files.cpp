#include "tools/commands/corpus_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "corpus/curate/location.hpp"
#include "oracles/truth/derive.hpp"
#include "reports/text/inputs.hpp"

namespace graze::tool {

std::optional<std::vector<corpus::Case>> read_sound(const std::string& name) {
  corpus::Ids ids;
  return read_sound(name, ids);
}

std::optional<std::vector<corpus::Case>> read_sound(const std::string& name, corpus::Ids& ids) {
  corpus::ReadResult result = corpus::read_file(name, ids);
  for (const corpus::ReadError& error : result.errors) complain(error.text());
  if (!result.ok()) return std::nullopt;
  return std::move(result.cases);
}

void replace_file(const std::string& given, const std::vector<corpus::Case>& cases) {
  // A link stays a link: the file that it leads to is replaced.
  std::error_code ignored;
  const std::filesystem::path place = std::filesystem::canonical(given, ignored);
  const std::string name = ignored ? given : place.string();
  const std::string beside = name + ".new";
  require_own_file(beside);
  const bool lines = std::filesystem::path(given).extension() == ".jsonl";
  {
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    if (!out) throw std::runtime_error(name + ": cannot be written; name a file in a folder that can");
    for (const corpus::Case& problem : cases) {
      out << (lines ? corpus::write_case(problem) + "\n" : corpus::write_case_pretty(problem));
    }
    out.close();
    if (!out) throw std::runtime_error(beside + ": could not be written to its end");
  }
  std::error_code failure;
  std::filesystem::rename(beside, name, failure);
  if (failure) throw std::runtime_error(fmt::format("{}: cannot be replaced: {}", name, failure.message()));
}

corpus::Expect expectation(const corpus::Case& problem) {
  corpus::Expect expect = oracle::derive_expectation(problem);
  if (expect.outcome == Outcome::miss) {
    expect.toi_lower.reset();
    expect.toi_upper.reset();
    expect.toi_exact.clear();
  }
  return expect;
}

void fill_in(const std::string& file, corpus::Case& problem) {
  try {
    problem.expect = expectation(problem);
  } catch (const oracle::Undecided& why) {
    problem.expect.reset();
    complain(fmt::format("{}: case {}: left without an answer: {}", file, problem.id, why.what()));
  }
}

std::string known_failures_file() { return (corpus::corpus_directory() / "known_failures.jsonl").string(); }

}  // namespace graze::tool
