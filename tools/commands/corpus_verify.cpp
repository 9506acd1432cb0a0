#include "tools/commands/corpus_verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "corpus/curate/curation.hpp"
#include "corpus/curate/flags.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_io.hpp"
#include "oracles/truth/derive.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/progress.hpp"
#include "scene/src/parallel.hpp"
#include "tools/commands/corpus_files.hpp"

namespace graze::tool {
namespace {

using corpus::Case;

// The difference between the answer of a case and the oracle's, or "".
std::string difference(const Case& problem) {
  Case derived = problem;
  try {
    derived.expect = expectation(problem);
    if (!problem.expect) return "no expected answer, where an oracle has one";
  } catch (const oracle::Undecided& why) {
    return problem.expect ? fmt::format("no oracle decides it: {}", why.what()) : "";
  } catch (const std::invalid_argument& error) {
    return std::string("no oracle decides it: ") + error.what();
  }
  // A graze.case/1 does not say how far the path is from another answer.
  if (!problem.expect->has_measures()) {
    for (std::optional<double> corpus::Expect::*measure :
         {&corpus::Expect::clearance, &corpus::Expect::path_depth, &corpus::Expect::scale}) {
      ((*derived.expect).*measure).reset();
    }
  }
  if (corpus::same_case(problem, derived)) return "";
  return "stored " + corpus::write_expect(*problem.expect) + ", derived " +
         corpus::write_expect(*derived.expect);
}

std::vector<std::string> differences_of(const std::vector<Case>& cases, unsigned threads) {
  std::vector<std::string> found(cases.size());
  Progress progress("answers derived", cases.size());
  scene::for_each_index(cases.size(), threads, [&](std::size_t i) {
    found[i] = difference(cases[i]);
    progress.step();
  });
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!found[i].empty()) lines.push_back(cases[i].id + ": " + found[i]);
  }
  return lines;
}

// The cases of corpus/cases come first, the known failures after them.
struct BuiltIn {
  std::vector<Case> cases;
  std::size_t curated = 0;
  bool bad = false;
};

void take(corpus::ReadResult read, BuiltIn& all) {
  for (const corpus::ReadError& error : read.errors) complain(error.text());
  all.bad = all.bad || !read.ok();
  all.cases.insert(all.cases.end(), read.cases.begin(), read.cases.end());
}

// Ids, comments, flags, sources, and questions that are asked twice.
std::vector<std::string> curation_of(const BuiltIn& all) {
  std::vector<std::string> lines;
  std::map<std::string, std::string> asked, ids;
  for (std::size_t i = 0; i < all.cases.size(); ++i) {
    const Case& problem = all.cases[i];
    const corpus::Shelf shelf = i < all.curated ? corpus::Shelf::cases : corpus::Shelf::known;
    for (const std::string& fault : corpus::curation_faults(problem, shelf)) {
      lines.push_back(problem.id + ": " + fault);
    }
    if (!ids.emplace(problem.id, problem.id).second) lines.push_back(problem.id + ": the id is there twice");
    const auto [first, is_new] = asked.emplace(corpus::question_of(problem), problem.id);
    if (!is_new) lines.push_back(problem.id + ": is the same case as " + first->second);
  }
  return lines;
}

}  // namespace

int verify_corpus(const std::string& directory, unsigned threads) {
  BuiltIn all;
  std::vector<std::string> lines;
  if (!directory.empty()) {
    take(corpus::read_directory(directory), all);
  } else {
    take(corpus::read_directory(corpus::corpus_directory() / "cases"), all);
    all.curated = all.cases.size();
    const std::string known = known_failures_file();
    if (std::filesystem::exists(known)) take(corpus::read_file(known), all);
    const corpus::FlagNotes flags = corpus::read_flag_notes_file(corpus::corpus_directory() / "flags.json");
    if (!flags.error.empty()) complain(flags.error);
    all.bad = all.bad || !flags.error.empty();
    lines = corpus::flag_mismatches(all.cases, flags);
    const std::vector<std::string> curation = curation_of(all);
    lines.insert(lines.end(), curation.begin(), curation.end());
  }
  const std::vector<std::string> differences = differences_of(all.cases, threads);
  lines.insert(lines.end(), differences.begin(), differences.end());
  for (const std::string& line : lines) fmt::print("{}\n", line);
  const auto answered = std::count_if(all.cases.begin(), all.cases.end(),
                                      [](const Case& problem) { return problem.expect.has_value(); });
  fmt::print("{}, {} with an answer, {}\n", counted(all.cases.size(), "case"), answered,
             counted(lines.size(), "difference"));
  if (all.bad) return 2;
  return lines.empty() ? 0 : 1;
}

}  // namespace graze::tool
