// Options of the command graze that say nothing, too much, or another kind of file than they want.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

constexpr const char* kHit = R"({"schema": "graze.case/1", "id": "test/hit", "family": "test",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 0.1]}},
 "b": {"shape": {"type": "sphere", "radius": 0.3}, "position": [0.1, 0.2, 1.4], "displacement": [0.1, 0, -10]}}
)";

// One short line names `part`, and nothing is judged or written before.
void expect_one_complaint(const CommandRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
  EXPECT_LT(run.err.size(), 200U) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(Options, AnEmptyValueIsNoneAndIsNotPassedOver) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string option : {"--proof", "--method", "--tier", "--scalar", "--tolerance"}) {
    expect_one_complaint(folder.graze("cast x.json " + option + " ''"), option);
  }
  for (const std::string option : {"--save", "--guarantees", "--corpus", "--family", "--method"}) {
    expect_one_complaint(folder.graze("certify x.json " + option + " ''"), option);
  }
  for (const std::string option : {"laws --law", "laws --report", "stability --plot", "stability --save"})
    expect_one_complaint(folder.graze(option + " ''"), option.substr(option.find(' ') + 1));
  expect_one_complaint(folder.graze("price --only nothing"), "--only: nothing is no table");
  expect_one_complaint(folder.graze("price --continue"), "--continue: needs --json");
  expect_one_complaint(folder.graze("price --quick --thorough"), "a run is one of the two");
  expect_one_complaint(folder.graze("draw x.json --out ''"), "--out");
  expect_one_complaint(folder.graze("draw --families ''"), "--families");
  expect_one_complaint(folder.graze("cast ''"), "files");
}

TEST(Options, ANumberThatIsNoCountIsRefusedInAShortLine) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string count : {"-1", "1.5", "nan", "inf", "1e3", "x", "99999999999999999999",
                                  "18446744073709551615", "1000000001", "+1", "0x10"}) {
    for (const std::string option : {"--count", "--queries", "--rotating", "--oracle-every", "--threads"}) {
      SCOPED_TRACE(option + "=" + count);
      expect_one_complaint(folder.graze("certify --family random " + option + "=" + count), option);
    }
    expect_one_complaint(folder.graze("generate random --count=" + count), "--count");
  }
  expect_one_complaint(folder.graze("certify x.json --threads 100000"), "--threads");
  expect_one_complaint(folder.graze("certify x.json --oracle-every 0"), "--oracle-every");
  expect_one_complaint(folder.graze("generate random --seed 18446744073709551616"), "--seed");
  EXPECT_EQ(folder.graze("generate random --count 1 --seed 18446744073709551615").exit_code, 0);
}

TEST(Options, NanAndOtherRangesAreRefusedInAShortLine) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("answers.jsonl", "");
  for (const std::string number : {"nan", "inf", "-1", "abc", "1x"}) {
    SCOPED_TRACE(number);
    for (const std::string line :
         {"judge answers.jsonl --tolerance", "judge answers.jsonl --relative-tolerance",
          "judge answers.jsonl --kappa", "compare x.json x.json --threshold",
          "compare x.json x.json --error-factor", "check x.json --kappa", "cast x.json --tolerance",
          "certify x.json --engine e --tolerance", "certify x.json --engine e --time-limit"}) {
      const std::string option = line.substr(line.rfind(' ') + 1);
      expect_one_complaint(folder.graze(line + "=" + number), option + ": " + number + " is no number ");
    }
    for (const std::string option :
         {"--casts", "--per-family", "--rotating", "--rotating-per-family", "--queries", "--seed",
          "--oracle-every", "--judge-every", "--threads", "--block"}) {
      expect_one_complaint(folder.graze("campaign " + option + "=" + number),
                           option + ": " + number + " is no whole number from ");
    }
  }
  expect_one_complaint(folder.graze("generate random --hardness abc"), "--hardness: abc is no finite number");
  expect_one_complaint(folder.graze("compare x.json x.json --threshold 101"), "from 0 to 100");
  expect_one_complaint(folder.graze("compare x.json x.json --error-factor 0.5"), "from 1 to ");
  expect_one_complaint(folder.graze("certify x.json --engine e --time-limit 0"),
                       "--time-limit: 0 is no number");
  for (const std::string command : {"certify", "campaign", "judge answers.jsonl", "price"})
    expect_one_complaint(folder.graze(command + " --threads 0"), "--threads: 0 is no whole number from 1 to");
}

TEST(Options, WhatIsSaidOfAnEngineWantsOne) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string option : {"--tolerance 1e-30", "--relative-tolerance 1", "--kappa 3"}) {
    const std::string name = option.substr(0, option.find(' '));
    for (const std::string command : {"certify x.json ", "campaign --casts 10 ", "show x.json "})
      expect_one_complaint(folder.graze(command + option),
                           name + ": is what an engine is held to; name one with --engine");
  }
  for (const std::string option : {"--time-limit 3", "--memory-limit 64", "--beyond-limits"}) {
    const std::string name = option.substr(0, option.find(' '));
    for (const std::string command : {"cast x.json ", "certify x.json ", "campaign --casts 10 ", "price "})
      expect_one_complaint(folder.graze(command + option),
                           name + ": applies to third-party engines; name one");
  }
  for (const std::string option : {"--needs-shape box", "--needs-answer time"}) {
    expect_one_complaint(folder.graze("certify x.json " + option),
                         "is what an engine must declare; name one");
  }
  expect_one_complaint(folder.graze("certify x.json --findings found"),
                       "--findings: applies to third-party engines");
  expect_one_complaint(folder.graze("certify x.json --report-cases 3"),
                       "--report-cases: applies to the report");
  // The names that may be needed are said, which is a long line.
  const CommandRun run = folder.graze("certify x.json --needs-shape banana");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--needs-shape: banana is no shape; it is point, segment,"), std::string::npos);
  expect_one_complaint(folder.graze("certify x.json --needs-answer banana"),
                       "banana is no answer; it is verdict,");
}

// For one version: what moved to a command of its own is said, and nothing is judged.
TEST(Options, TheOldSpellingsAnswerWithTheNewOnes) {
  const Folder folder;
  for (const auto& [old, now] :
       std::vector<std::pair<std::string, std::string>>{{"--laws x.json", "laws"},
                                                        {"--laws --law swapping --law never_late", "laws"},
                                                        {"--law swapping", "laws --law"},
                                                        {"--stability --plot p --family random", "stability"},
                                                        {"--plot p", "stability --plot"}}) {
    const CommandRun run = folder.graze("certify " + old);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    const std::string option = old.substr(0, old.find(' '));
    EXPECT_EQ(run.err, "graze: " + option + ": is a command of its own now: graze " + now + "\n");
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "p"));
}

TEST(Options, ACommandThatIsGivenNothingSaysWhatItWants) {
  const Folder folder;
  expect_one_complaint(folder.graze("cast"), "graze: cast: name a case file; see graze cast --help\n");
  expect_one_complaint(folder.graze("check"),
                       "graze: check: name a file of proofs; see graze check --help\n");
  expect_one_complaint(folder.graze("corpus add"),
                       "graze: corpus add: name a file of cases; see graze corpus add");
  expect_one_complaint(folder.graze("generate"),
                       "graze: generate: name a family; see graze generate --help\n");
  expect_one_complaint(folder.graze("draw"), "graze: draw: no case is given");
  expect_one_complaint(folder.graze(""), "see graze --help\n");
}

TEST(Options, TheNamesOfFamiliesStandApartFromWhatTheyAre) {
  const Folder folder;
  const std::string help = folder.graze("generate --help").out;
  for (const std::string name : {"grazing_edge", "redundant_vertices", "far_own_frame_turning"})
    EXPECT_NE(help.find("\n  " + name + "  "), std::string::npos) << name;
}

TEST(Options, AFolderIsNoFileAndAFileNoFolder) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("folder/y.json", kHit);
  expect_one_complaint(folder.graze("certify x.json --guarantees folder"), "folder: a directory");
  expect_one_complaint(folder.graze("merge folder"), "folder: a directory");
  expect_one_complaint(folder.graze("compare folder folder"), "folder: a directory");
  expect_one_complaint(folder.graze("compare x.json x.json"), "x.json: schema: is graze.case/1");
  expect_one_complaint(folder.graze("cast folder"), "folder: a directory");
  expect_one_complaint(folder.shell("graze cast - <folder"), "standard input: cannot be read");
  // At once, and not after everything else was judged.
  for (const std::string corpus : {"x.json", "missing"}) {
    expect_one_complaint(folder.graze("certify --corpus " + corpus), corpus + ": is no folder");
    expect_one_complaint(folder.graze("laws --corpus " + corpus), corpus + ": is no folder");
  }
  expect_one_complaint(folder.graze("stability --family random --plot x.json"), "x.json: is no folder");
  expect_one_complaint(folder.graze("stability --family random --plot x.json/p"), "x.json/p");
}

TEST(Options, ANameThatMayBeRepeatedTakesNoFileForAnother) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string option : {"--method gjk/double", "--family random --count 1"}) {
    const CommandRun run = folder.graze("certify --queries 0 --full " + option + " x.json");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("x.json"), std::string::npos) << run.out;
  }
  const CommandRun laws = folder.graze("laws --law swapping x.json");
  EXPECT_EQ(laws.exit_code, 0) << laws.err;
}

}  // namespace
}  // namespace graze
