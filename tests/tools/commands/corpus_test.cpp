// graze corpus add and verify, run on a corpus of three cases: what is added, what is kept out, and that a
// planted difference of each kind is reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "corpus/format/case_io.hpp"
#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

constexpr const char* kFlags = R"({
  "Ray": {"breaks": "One body is a point.", "affects": "Ray casts.", "cases": ["ray/ball"]},
  "Touching": {"breaks": "A gap of zero.", "affects": "Resting contact.", "cases": []}
})";
constexpr const char* kBall =
    R"({"schema": "graze.case/1", "id": "ray/ball", "family": "ray", "comment": "A ray at the middle of a ball.", "flags": ["Ray"],)"
    R"( "a": {"shape": {"type": "sphere", "radius": 1}}, "b": {"shape": {"type": "point"}, "position": [0, 0, 4], "displacement": [0, 0, -9]}})";
constexpr const char* kCube =
    R"({"schema": "graze.case/1", "id": "touching/cube", "family": "touching", "comment": "A point that leaves the face of a cube.", "flags": ["Touching", "Ray"],)"
    R"( "a": {"shape": {"type": "box", "half_extents": [1, 1, 1]}}, "b": {"shape": {"type": "point"}, "position": [0, 0, 1], "displacement": [0, 0, 1]}})";
constexpr const char* kKnown =
    R"({"schema": "graze.case/1", "id": "known/rim", "family": "known", "comment": "A cylinder whose rim meets a point.",)"
    R"( "a": {"shape": {"type": "cylinder", "radius": 1, "half_height": 1}}, "b": {"shape": {"type": "point"}, "position": [3, 0, 0], "displacement": [-4, 0, 0]}})";
// The case that a campaign saves: a generated case, unchanged.
constexpr const char* kFinding =
    R"({"schema": "graze.case/1", "id": "grazing/h9/s1", "family": "grazing", "hardness": 9,)"
    R"( "b": {"shape": {"type": "point"}, "position": [0, 0, 3], "displacement": [0, 0, -3]}, "a": {"shape": {"type": "box", "half_extents": [1, 1, 1]}}})";
constexpr const char* kTold = " --comment 'A point that falls on a cube, as it was found.' --flag Ray";

// A corpus that verifies, in the folder in which the command runs.
class CorpusCommand : public testing::Test {
 protected:
  void SetUp() override {
    setenv("GRAZE_CORPUS", "corpus", 1);
    folder_.write("corpus/flags.json", kFlags);
    folder_.write("corpus/cases/all.jsonl", std::string(kBall) + "\n" + kCube + "\n");
    folder_.write("corpus/known_failures.jsonl", std::string(kKnown) + "\n");
    ASSERT_EQ(folder_.graze("corpus fill corpus/cases/all.jsonl corpus/known_failures.jsonl").exit_code, 0);
    folder_.write("finding.json", kFinding);
  }
  void TearDown() override { unsetenv("GRAZE_CORPUS"); }

  [[nodiscard]] std::vector<corpus::Case> cases_of(const std::string& file) const {
    return corpus::read_text(folder_.read(file), file, true).cases;
  }

  // Exit code 2, one line that holds every part, and the corpus as it was.
  void expect_refused(const std::string& arguments, const std::vector<std::string>& parts,
                      const std::string& input = "") const {
    const std::string all = folder_.read("corpus/cases/all.jsonl");
    const std::string known = folder_.read("corpus/known_failures.jsonl");
    const CommandRun run = folder_.graze("corpus add " + arguments, input);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    for (const std::string& part : parts) EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_EQ(folder_.read("corpus/cases/all.jsonl"), all) << arguments;
    EXPECT_EQ(folder_.read("corpus/known_failures.jsonl"), known) << arguments;
    EXPECT_EQ(folder_.read("new.jsonl"), "") << arguments;
  }

  // Verify says `line` after `from` has become `to` in a file.
  void expect_reported(const std::string& file, const std::string& from, const std::string& to,
                       const std::string& line) const {
    const std::string sound = folder_.read(file);
    const std::size_t at = sound.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    folder_.write(file, std::string(sound).replace(at, from.size(), to));
    for (const char* threads : {"1", "3"}) {
      const CommandRun run = folder_.graze(std::string("corpus verify --threads ") + threads);
      EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
      EXPECT_NE(run.out.find(line), std::string::npos) << run.out;
      EXPECT_EQ(run.out.find(" 0 differences"), std::string::npos) << run.out;
    }
    folder_.write(file, sound);
  }

  Folder folder_;
};

TEST_F(CorpusCommand, AFindingBecomesACaseWithItsAnswer) {
  const CommandRun run = folder_.graze("corpus add finding.json --into corpus/cases/all.jsonl" +
                                       std::string(kTold) + " --id ray/found --source https://example.org/7");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("ray/found added to corpus/cases/all.jsonl"), std::string::npos) << run.out;
  const std::vector<corpus::Case> cases = cases_of("corpus/cases/all.jsonl");
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[2].id, "ray/found");
  EXPECT_EQ(cases[2].family, "ray");
  EXPECT_FALSE(cases[2].hardness.has_value());  // it meant something in the family grazing
  EXPECT_EQ(cases[2].source, "https://example.org/7");
  ASSERT_TRUE(cases[2].expect.has_value());
  EXPECT_EQ(cases[2].expect->toi_exact, "2/3");
  EXPECT_EQ(cases[2].expect->toi_upper, std::nextafter(*cases[2].expect->toi_lower, 1));
  const CommandRun verify = folder_.graze("corpus verify");
  EXPECT_EQ(verify.exit_code, 0) << verify.out << verify.err;
  EXPECT_EQ(verify.out, "4 cases, 4 with an answer, 0 differences\n");
}

TEST_F(CorpusCommand, AGeneratedCaseThatKeepsItsIdKeepsFamilyAndHardness) {
  ASSERT_EQ(
      folder_.graze("corpus add - --into corpus/cases/new.jsonl" + std::string(kTold), kFinding).exit_code,
      0);
  const std::vector<corpus::Case> cases = cases_of("corpus/cases/new.jsonl");
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0].id, "grazing/h9/s1");
  EXPECT_EQ(cases[0].family, "grazing");
  EXPECT_EQ(cases[0].hardness, 9);
  EXPECT_EQ(folder_.graze("corpus verify").exit_code, 0);
  // A link to the file stays one.
  std::filesystem::create_symlink("new.jsonl", folder_.path() / "corpus/cases/link.jsonl");
  ASSERT_EQ(folder_.graze("corpus format corpus/cases/link.jsonl").exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.path() / "corpus/cases/link.jsonl"));
  std::filesystem::remove(folder_.path() / "corpus/cases/link.jsonl");
  // The canonical form: formatting changes nothing.
  const std::string text = folder_.read("corpus/cases/new.jsonl");
  ASSERT_EQ(folder_.graze("corpus format corpus/cases/new.jsonl").exit_code, 0);
  EXPECT_EQ(folder_.read("corpus/cases/new.jsonl"), text);
}

TEST_F(CorpusCommand, AKnownFailureGoesToItsOwnFileAndNeedsNoFlag) {
  const CommandRun run =
      folder_.graze("corpus add finding.json --known --comment 'A point that falls on a cube.'");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<corpus::Case> known = cases_of("corpus/known_failures.jsonl");
  ASSERT_EQ(known.size(), 2U);
  EXPECT_EQ(known[1].id, "grazing/h9/s1");
  EXPECT_TRUE(known[1].expect.has_value());
  EXPECT_EQ(folder_.graze("corpus verify").exit_code, 0);
}

TEST_F(CorpusCommand, ADryRunPrintsTheLineAndWritesNothing) {
  const std::string before = folder_.read("corpus/cases/all.jsonl");
  const std::string arguments = "corpus add finding.json --into corpus/cases/all.jsonl" + std::string(kTold);
  const CommandRun dry = folder_.graze(arguments + " --dry-run");
  ASSERT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_EQ(folder_.read("corpus/cases/all.jsonl"), before);
  ASSERT_EQ(folder_.graze(arguments).exit_code, 0);
  EXPECT_EQ(folder_.read("corpus/cases/all.jsonl"), before + dry.out);
}

TEST_F(CorpusCommand, WhatTheCorpusMustNotHoldIsRefusedWithOneLineAndNothingIsWritten) {
  const std::string told = kTold, into = " --into corpus/cases/all.jsonl";
  expect_refused("finding.json --id ray/ball" + into + told, {"ray/ball", "id already"});
  expect_refused("finding.json --id known/rim" + into + told, {"known/rim", "id already"});
  expect_refused("finding.json --id ray/ball --into new.jsonl" + told, {"ray/ball", "id already"});
  expect_refused("finding.json --flag Rays" + into + told, {"flag Rays", "no note", "flags.json"});
  expect_refused("finding.json --flag Ray" + into, {"grazing/h9/s1", "comment"});
  expect_refused("finding.json --comment 'A point that falls on a cube.'" + into, {"no flag"});
  expect_refused("finding.json --id found" + into + told, {"family/name"});
  expect_refused("finding.json --id 'ray/a b'" + into + told, {"id"});
  expect_refused("finding.json --id reported/x" + into + told, {"https://"});
  std::string again = kBall;
  again.replace(again.find("ray/ball"), 8, "ray/copy");
  expect_refused("-" + into, {"ray/copy", "ray/ball is the same case"}, again);
  expect_refused("- --known", {"ray/copy", "ray/ball is the same case"}, again);
}

TEST_F(CorpusCommand, AWrongCommandLineOrFileIsOneLineAsWell) {
  const std::string told = kTold, into = " --into corpus/cases/all.jsonl";
  expect_refused("missing.json" + into + told, {"missing.json"});
  expect_refused("finding.json" + told, {"--into", "--known"});
  expect_refused("finding.json --known" + into + told, {"--into", "--known"});
  expect_refused("finding.json --into corpus/cases/all.txt" + told, {"all.txt", ".jsonl"});
  expect_refused("finding.json --into no/folder/new.jsonl" + told, {"no/folder/new.jsonl"});
  expect_refused("-" + into + told, {"standard input"}, "{}");
  folder_.write("one.json", kFinding);
  expect_refused("finding.json --id ray/second --into one.json" + told, {"one.json", ".jsonl"});
}

TEST_F(CorpusCommand, OfSeveralAllAreAddedOrNone) {
  std::string second = kFinding;
  second.replace(second.find("s1"), 2, "s2");
  second.replace(second.find("[0, 0, 3]"), 9, "[0, 0, 5]");
  const std::string both = std::string(kFinding) + "\n" + second + "\n";
  const std::string into = " --into corpus/cases/all.jsonl" + std::string(kTold);
  expect_refused("- --id ray/two" + into, {"--id", "2 cases"}, both);
  expect_refused("-" + into, {"grazing/h9/s1 is the same case"},
                 std::string(kFinding) + "\n" +
                     std::string(kFinding).replace(std::string(kFinding).find("s1"), 2, "s2") + "\n");
  ASSERT_EQ(folder_.graze("corpus add -" + into, both).exit_code, 0);
  EXPECT_EQ(cases_of("corpus/cases/all.jsonl").size(), 4U);
}

TEST_F(CorpusCommand, VerifyReportsAnAnswerThatIsOffByOneUnitInTheLastPlace) {
  const double lower = *cases_of("corpus/cases/all.jsonl")[0].expect->toi_lower;
  ASSERT_EQ(lower, 1.0 / 3);
  expect_reported("corpus/cases/all.jsonl", "\"lower\": 0.3333333333333333,",
                  "\"lower\": 0.33333333333333326,", "ray/ball: stored ");
  expect_reported("corpus/cases/all.jsonl", "\"initially_overlapping\"", "\"hit\"", "touching/cube: stored ");
  expect_reported("corpus/cases/all.jsonl", "\"1/3\"", "\"2/3\"", "ray/ball: stored ");
  expect_reported("corpus/known_failures.jsonl", "\"hit\"", "\"miss\"", "known/rim: stored ");
}

TEST_F(CorpusCommand, VerifyReportsAnAnswerThatIsMissing) {
  folder_.write("corpus/cases/bare.jsonl",
                std::string(kFinding).replace(
                    1, 0, "\"comment\": \"A point that falls on a cube.\", \"flags\": [\"Ray\"], ") +
                    "\n");
  const CommandRun run = folder_.graze("corpus verify");
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find("grazing/h9/s1: no expected answer"), std::string::npos) << run.out;
}

TEST_F(CorpusCommand, VerifyHoldsFlagsAndNotesToEachOtherAndCasesToWhatTheyMustHave) {
  expect_reported("corpus/cases/all.jsonl", "\"Touching\", ", "", "the note on Touching is used by no case");
  expect_reported("corpus/flags.json", "\"Ray\":", "\"Beam\":", "ray/ball: the flag Ray has no note");
  expect_reported("corpus/flags.json", "ray/ball", "ray/cube", "names ray/cube, which does not exist");
  expect_reported("corpus/cases/all.jsonl", "A ray at the middle of a ball.", "A ray.",
                  "ray/ball: the comment");
  expect_reported("corpus/cases/all.jsonl", "\"flags\": [\"Ray\"]", "\"flags\": []", "ray/ball: no flag");
  expect_reported("corpus/cases/all.jsonl", "\"family\": \"touching\"", "\"family\": \"ties\"",
                  "touching/cube: the id does not begin with its family");
  expect_reported("corpus/known_failures.jsonl", "known/rim", "ray/ball", "ray/ball: the id is there twice");
  const std::string line = folder_.read("corpus/cases/all.jsonl");
  const std::string copy = line.substr(0, line.find('\n') + 1);
  folder_.write("corpus/cases/more.jsonl", std::string(copy).replace(copy.find("ray/ball"), 8, "ray/copy"));
  const CommandRun run = folder_.graze("corpus verify");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("ray/copy: is the same case as ray/ball"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace graze
