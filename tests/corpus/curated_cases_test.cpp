// The curated cases: all read, flags and notes in both directions, what every case must have, and the reports
// that they come from.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "corpus/curate/curation.hpp"
#include "corpus/curate/flags.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_io.hpp"

namespace graze::corpus {
namespace {

const ReadResult& curated() {
  static const ReadResult result = read_directory(corpus_directory() / "cases");
  return result;
}

TEST(CuratedCases, AllRead) {
  for (const ReadError& error : curated().errors) ADD_FAILURE() << error.text();
  EXPECT_GE(curated().cases.size(), 420u);
}

TEST(CuratedCases, IdsAreUnique) {
  std::set<std::string> ids;
  for (const Case& problem : curated().cases) EXPECT_TRUE(ids.insert(problem.id).second) << problem.id;
}

TEST(CuratedCases, SayWhyTheyAreHard) {
  for (const Case& problem : curated().cases) {
    for (const std::string& fault : curation_faults(problem, Shelf::cases)) {
      ADD_FAILURE() << problem.id << ": " << fault;
    }
  }
}

TEST(CuratedCases, WhatIsMissingIsNoticed) {
  const Case sound = curated().cases.front();
  const auto faults = [](Case problem, const auto& edit) {
    edit(problem);
    return curation_faults(problem, Shelf::cases).size();
  };
  EXPECT_EQ(faults(sound, [](Case&) {}), 0u);
  EXPECT_EQ(faults(sound, [](Case& c) { c.id = "noslash"; }), 1u);
  EXPECT_EQ(faults(sound, [](Case& c) { c.family += "x"; }), 1u);
  EXPECT_EQ(faults(sound, [](Case& c) { c.comment = "A short one."; }), 1u);
  EXPECT_EQ(faults(sound, [](Case& c) { c.flags.clear(); }), 1u);
  EXPECT_EQ(faults(sound,
                   [](Case& c) {
                     c.id = "reported/x";
                     c.family = "reported";
                     c.source = "a forum";
                   }),
            1u);
  Case bare = sound;
  bare.flags.clear();
  EXPECT_TRUE(curation_faults(bare, Shelf::known).empty());
}

TEST(CuratedCases, AskNoQuestionTwice) {
  std::map<std::string, std::string> asked;
  for (const Case& problem : curated().cases) {
    const auto [first, is_new] = asked.emplace(question_of(problem), problem.id);
    EXPECT_TRUE(is_new) << problem.id << " asks what " << first->second << " asks";
  }
}

// A row of corpus/reported.md.
struct Report {
  std::string name, numbers;
  std::size_t cases = 0;
};

std::vector<Report> reports() {
  std::vector<Report> rows;
  std::ifstream page(corpus_directory() / "reported.md");
  const std::regex row(R"(\| \[([^\]]+)\]\(https://[^)]+\) \| [A-L] \| (all|some) \| (\d+) \| [^|]+ \|)");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| [")) continue;
    std::smatch parts;
    if (!std::regex_match(line, parts, row)) {
      ADD_FAILURE() << "no row of the table: " << line;
      continue;
    }
    rows.push_back({parts[1], parts[2], std::stoul(parts[3])});
  }
  return rows;
}

TEST(CuratedCases, HoldEveryReportThatThePageNamesAndNoOther) {
  const std::vector<Report> rows = reports();
  std::set<std::string> claimed;
  for (const Report& report : rows) {
    const std::string id = "reported/" + report.name;
    std::size_t count = 0;
    for (const Case& problem : curated().cases) {
      if (problem.id != id && !problem.id.starts_with(id + "-")) continue;
      EXPECT_TRUE(claimed.insert(problem.id).second) << problem.id << " is of two reports";
      ++count;
    }
    EXPECT_EQ(count, report.cases) << report.name;
    EXPECT_GT(count, 0u) << report.name;
  }
  for (const Case& problem : curated().cases) {
    EXPECT_EQ(claimed.contains(problem.id), problem.family == "reported") << problem.id;
  }
  // The trackers surveyed hold 61 reports with every number on these shapes, and a preset without a report.
  const auto full =
      std::count_if(rows.begin(), rows.end(), [](const Report& r) { return r.numbers == "all"; });
  EXPECT_EQ(full, 62);
}

TEST(CuratedCases, EveryFlagHasANoteAndEveryNoteIsUsed) {
  const FlagNotes flags = read_flag_notes_file(corpus_directory() / "flags.json");
  ASSERT_EQ(flags.error, "");
  for (const std::string& line : flag_mismatches(curated().cases, flags)) ADD_FAILURE() << line;
}

TEST(CuratedCases, AMissingNoteAnUnusedNoteAndAWrongCaseAreNoticed) {
  FlagNotes flags = read_flag_notes_file(corpus_directory() / "flags.json");
  flags.notes.erase("Ray");
  flags.notes["Unused"] = {"x", "y", {}};
  flags.notes["Graze"].cases = {"no/such-case", "touching/resting-cubes"};
  const std::vector<std::string> lines = flag_mismatches(curated().cases, flags);
  const auto says = [&](const std::string& part) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(says("the flag Ray has no note"));
  EXPECT_TRUE(says("the note on Unused is used by no case"));
  EXPECT_TRUE(says("names no/such-case, which does not exist"));
  EXPECT_TRUE(says("names touching/resting-cubes, which lacks the flag"));
}

TEST(CuratedCases, ReadBackAsTheyWereWritten) {
  for (const Case& problem : curated().cases) {
    const ReadResult again = read_text(write_case(problem), problem.id, false);
    ASSERT_TRUE(again.ok()) << again.errors[0].text();
    EXPECT_TRUE(same_case(again.cases[0], problem)) << problem.id;
  }
}

// `graze corpus verify`, a test of its own, checks that the answers are the oracles'.
TEST(CuratedCases, ReachEveryOutcomeAndAreMostlyAnswered) {
  std::map<Outcome, std::size_t> outcomes;
  std::size_t unanswered = 0;
  for (const Case& problem : curated().cases) {
    if (problem.expect) {
      ++outcomes[problem.expect->outcome.value()];
    } else {
      ++unanswered;
    }
  }
  EXPECT_GT(outcomes[Outcome::hit], 150u);
  EXPECT_GT(outcomes[Outcome::miss], 100u);
  EXPECT_GT(outcomes[Outcome::initially_overlapping], 80u);
  EXPECT_LT(unanswered, curated().cases.size() / 20);
}

}  // namespace
}  // namespace graze::corpus
