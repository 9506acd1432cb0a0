#include "tools/corpus_command.hpp"

#include <fmt/format.h>
#include <algorithm>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "corpus/case_io.hpp"
#include "corpus/flags.hpp"
#include "corpus/location.hpp"
#include "oracles/derive.hpp"
#include "tools/inputs.hpp"

namespace graze::tool {
namespace {

using Files = std::vector<std::string>;

// The oracle's answer as a case holds it: a miss has no time.
corpus::Expect expectation(const corpus::Case& problem) {
  corpus::Expect expect = oracle::derive_expectation(problem);
  if (expect.outcome == Outcome::miss) {
    expect.toi_lower.reset();
    expect.toi_upper.reset();
    expect.toi_exact.clear();
  }
  return expect;
}

// Reads a file whole, or nothing: a file with an error in it is left as it is.
std::optional<std::vector<corpus::Case>> read_sound(const std::string& name) {
  corpus::ReadResult result = corpus::read_file(name);
  for (const corpus::ReadError& error : result.errors) complain(error.text());
  if (!result.ok()) return std::nullopt;
  return std::move(result.cases);
}

// Beside the file first, then in its place: an interrupted run loses nothing.
void replace_file(const std::string& name, const std::vector<corpus::Case>& cases) {
  const std::string beside = name + ".new";
  const bool lines = std::filesystem::path(name).extension() == ".jsonl";
  {
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    for (const corpus::Case& problem : cases) {
      out << (lines ? corpus::write_case(problem) + "\n" : corpus::write_case_pretty(problem));
    }
    out.close();
    if (!out) throw std::runtime_error(beside + ": could not be written to its end");
  }
  std::filesystem::rename(beside, name);
}

// A case that no oracle answers keeps none, and its file its other answers.
void fill_in(const std::string& file, corpus::Case& problem) {
  try {
    problem.expect = expectation(problem);
  } catch (const oracle::Undecided& why) {
    problem.expect.reset();
    complain(fmt::format("{}: case {}: left without an answer: {}", file, problem.id, why.what()));
  }
}

int rewrite(const Files& files, bool fill) {
  bool bad = false;
  for (const std::string& name : files) {
    std::optional<std::vector<corpus::Case>> cases = read_sound(name);
    bad = bad || !cases;
    if (!cases) continue;
    try {
      for (corpus::Case& problem : *cases) {
        if (fill) fill_in(name, problem);
      }
    } catch (const std::invalid_argument& error) {
      complain(name + ": " + error.what());
      bad = true;
      continue;
    }
    replace_file(name, *cases);
  }
  return bad ? 2 : 0;
}

int validate(const Files& files) {
  std::size_t count = 0;
  bool bad = false;
  for (const std::string& name : files) {
    const corpus::ReadResult result =
        std::filesystem::is_directory(name) ? corpus::read_directory(name) : corpus::read_file(name);
    for (const corpus::ReadError& error : result.errors) complain(error.text());
    bad = bad || !result.ok();
    count += result.cases.size();
  }
  fmt::print("{} valid cases\n", count);
  return bad ? 2 : 0;
}

// What differs between the answer of a case and the oracle's, or "".
std::string difference(const corpus::Case& problem) {
  corpus::Case stored = problem, derived = problem;
  try {
    derived.expect = expectation(problem);
    if (!problem.expect) return "no expected answer, where an oracle has one";
  } catch (const oracle::Undecided& why) {
    return problem.expect ? fmt::format("no oracle decides it: {}", why.what()) : "";
  } catch (const std::invalid_argument& error) {
    return std::string("no oracle decides it: ") + error.what();
  }
  if (corpus::same_case(stored, derived)) return "";
  return "stored " + corpus::write_expect(*stored.expect) + ", derived " +
         corpus::write_expect(*derived.expect);
}

int verify(const std::string& given) {
  const std::filesystem::path directory =
      given.empty() ? corpus::corpus_directory() / "cases" : std::filesystem::path(given);
  const corpus::ReadResult read = corpus::read_directory(directory);
  for (const corpus::ReadError& error : read.errors) complain(error.text());
  std::size_t differences = 0;
  const auto report = [&](const std::string& line) {
    fmt::print("{}\n", line);
    ++differences;
  };
  for (const corpus::Case& problem : read.cases) {
    if (const std::string what = difference(problem); !what.empty()) report(problem.id + ": " + what);
  }
  bool bad = !read.ok();
  if (given.empty()) {
    const corpus::FlagNotes flags = corpus::read_flag_notes_file(corpus::corpus_directory() / "flags.json");
    if (!flags.error.empty()) complain(flags.error);
    bad = bad || !flags.error.empty();
    for (const std::string& line : corpus::flag_mismatches(read.cases, flags)) report(line);
  }
  const auto answered = std::count_if(read.cases.begin(), read.cases.end(),
                                      [](const corpus::Case& problem) { return problem.expect.has_value(); });
  fmt::print("{} cases, {} with an answer, {} differences\n", read.cases.size(), answered, differences);
  return bad ? 2 : differences > 0 ? 1 : 0;
}

CLI::App* add_files_command(CLI::App& parent, const char* name, const char* what,
                            const std::shared_ptr<Files>& files) {
  CLI::App* command = parent.add_subcommand(name, what);
  command->add_option("files", *files, "Files of cases, .json or .jsonl")->required()->type_name("FILE");
  return command;
}

}  // namespace

void add_corpus_command(CLI::App& app, int& exit_code) {
  CLI::App* corpus = app.add_subcommand("corpus", "Fills, formats, validates and verifies files of cases.");
  corpus->require_subcommand(1);
  corpus->footer(
      "  graze corpus validate new.json    says what is wrong with it, or that it is valid\n"
      "  graze corpus fill new.json        writes the oracle's answer into it\n"
      "  graze corpus verify               derives every answer of the built-in corpus again\n\n"
      "Exit codes: 0; 1 if verify finds a difference; 2 for bad input, a file of which is left as it was.");
  const auto files = std::make_shared<Files>();
  const auto directory = std::make_shared<std::string>();

  add_files_command(*corpus, "fill",
                    "Derives the expected answer of every case, and writes it into the file.", files)
      ->callback([files, &exit_code] { exit_code = rewrite(*files, true); });
  add_files_command(*corpus, "format", "Rewrites files in the canonical form.", files)
      ->callback([files, &exit_code] { exit_code = rewrite(*files, false); });
  add_files_command(*corpus, "validate", "Reads files or directories, and changes nothing.", files)
      ->callback([files, &exit_code] { exit_code = validate(*files); });
  CLI::App* check = corpus->add_subcommand(
      "verify", "Derives every expected answer again and reports differences; flags and notes as well.");
  check->add_option("directory", *directory, "A directory of cases; the built-in corpus without one")
      ->type_name("DIR");
  check->callback([directory, &exit_code] { exit_code = verify(*directory); });
}

}  // namespace graze::tool
