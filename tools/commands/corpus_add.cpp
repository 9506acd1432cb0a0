#include "tools/commands/corpus_add.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "corpus/curate/curation.hpp"
#include "corpus/curate/flags.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_io.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/corpus_files.hpp"

namespace graze::tool {
namespace {

using corpus::Case;

// The ids and the questions that are taken.
class Ledger {
 public:
  void enter(const std::vector<Case>& cases) {
    for (const Case& problem : cases) enter(problem);
  }
  void enter(const Case& problem) {
    ids_.insert(problem.id);
    questions_.emplace(corpus::question_of(problem), problem.id);
  }
  // The reasons against adding a case, one line each.
  [[nodiscard]] std::vector<std::string> conflicts(const Case& problem) const {
    std::vector<std::string> lines;
    if (ids_.contains(problem.id)) {
      lines.emplace_back("the corpus has this id already, and ids are never reused; give another with --id");
    }
    const auto same = questions_.find(corpus::question_of(problem));
    if (same != questions_.end()) lines.push_back(same->second + " is the same case");
    return lines;
  }

 private:
  std::set<std::string> ids_;
  std::map<std::string, std::string> questions_;
};

// Every case of the built-in corpus. It must be sound to be added to.
Ledger read_ledger() {
  Ledger ledger;
  const corpus::ReadResult curated = corpus::read_directory(corpus::corpus_directory() / "cases");
  if (!curated.ok()) {
    throw std::runtime_error(curated.errors[0].text() + "; mend the corpus before adding to it");
  }
  ledger.enter(curated.cases);
  const std::string known = known_failures_file();
  if (!std::filesystem::exists(known)) return ledger;
  if (const auto failures = read_sound(known)) {
    ledger.enter(*failures);
    return ledger;
  }
  throw std::runtime_error(known + ": mend it before adding to the corpus");
}

// Applies the command line's values to a case.
void dress(Case& problem, const Addition& addition) {
  if (!addition.id.empty()) problem.id = addition.id;
  if (!addition.comment.empty()) problem.comment = addition.comment;
  if (!addition.source.empty()) problem.source = addition.source;
  for (const std::string& flag : addition.flags) {
    if (std::find(problem.flags.begin(), problem.flags.end(), flag) == problem.flags.end()) {
      problem.flags.push_back(flag);
    }
  }
  const std::string family = problem.id.substr(0, problem.id.find('/'));
  if (family != problem.family) problem.hardness.reset();
  problem.family = family;
}

// The errors of a completed case, one line each.
std::vector<std::string> faults_of(const Case& problem, corpus::Shelf shelf, const corpus::FlagNotes& flags) {
  const corpus::ReadResult again = corpus::read_text(corpus::write_case(problem), problem.id, false);
  std::vector<std::string> lines;
  for (const corpus::ReadError& error : again.errors) lines.push_back(error.field + ": " + error.what);
  for (const std::string& fault : corpus::curation_faults(problem, shelf)) lines.push_back(fault);
  for (const std::string& flag : problem.flags) {
    if (!flags.notes.contains(flag)) {
      lines.push_back(fmt::format("the flag {} has no note; {} are the flags, and a new one is written there",
                                  flag, (corpus::corpus_directory() / "flags.json").string()));
    }
  }
  return lines;
}

std::vector<Case> read_target(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension != ".json" && extension != ".jsonl") {
    throw std::runtime_error(file +
                             ": is no file of cases; its name ends in .jsonl, or in .json for one case");
  }
  if (!std::filesystem::exists(file)) return {};
  auto cases = read_sound(file);
  if (!cases) throw std::runtime_error(file + ": has errors, and was left as it is");
  return std::move(*cases);
}

}  // namespace

int add_cases(const Addition& addition) {
  will_read({addition.input});
  if (!addition.dry_run) require_own_file(addition.known ? known_failures_file() : addition.into);
  CaseFiles given = read_case_files({addition.input});
  if (given.bad) return 2;
  std::vector<Case> findings = std::move(given.files[0].cases);
  if (!addition.id.empty() && findings.size() != 1) {
    throw std::runtime_error(
        fmt::format("--id: {} holds {} cases; give one of them, or leave the option out to keep their ids",
                    addition.input, findings.size()));
  }
  const corpus::FlagNotes flags = corpus::read_flag_notes_file(corpus::corpus_directory() / "flags.json");
  if (!flags.error.empty()) throw std::runtime_error(flags.error);

  const std::string file = addition.known ? known_failures_file() : addition.into;
  std::vector<Case> cases = read_target(file);
  const bool single = std::filesystem::path(file).extension() == ".json";
  if (single && cases.size() + findings.size() > 1) {
    throw std::runtime_error(file + ": a .json file holds one case; name a .jsonl file");
  }
  Ledger ledger = read_ledger();
  ledger.enter(cases);

  bool refused = false;
  for (Case& problem : findings) {
    dress(problem, addition);
    std::vector<std::string> lines = ledger.conflicts(problem);
    const auto faults =
        faults_of(problem, addition.known ? corpus::Shelf::known : corpus::Shelf::cases, flags);
    lines.insert(lines.end(), faults.begin(), faults.end());
    for (const std::string& line : lines) {
      complain(fmt::format("{}: case {}: {}", addition.input, problem.id, line));
    }
    refused = refused || !lines.empty();
    ledger.enter(problem);
  }
  if (refused) return 2;

  for (Case& problem : findings) fill_in(addition.input, problem);
  if (addition.dry_run) {
    for (const Case& problem : findings) fmt::print("{}\n", corpus::write_case(problem));
    return 0;
  }
  cases.insert(cases.end(), findings.begin(), findings.end());
  replace_file(file, cases);
  for (const Case& problem : findings) {
    fmt::print("{} added to {}: {}\n", problem.id, file,
               problem.expect ? corpus::write_expect(*problem.expect) : "no oracle decides it");
  }
  return 0;
}

}  // namespace graze::tool
