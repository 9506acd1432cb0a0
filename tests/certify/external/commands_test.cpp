// --engine of every command that judges or asks: a fault of the bad engine shows up in each, an honest engine passes each, and
// what it does not take is counted.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "balls.hpp"
#include "corpus/format/case_io.hpp"
#include "processes.hpp"
#include "tests/tools/commands/run_command.hpp"

namespace graze::test {
namespace {

std::string engine(const std::string& fault) { return "--engine \"" BAD_ENGINE " " + fault + "\""; }

void write_balls(const Folder& folder) {
  std::string lines;
  int i = 0;
  for (const double step : {-5.0, -1.0, -6.0, -7.0}) {
    corpus::Case problem = balls(step);
    problem.id = "balls/" + std::to_string(i++);
    lines += corpus::write_case(problem) + "\n";
  }
  folder.write("balls.jsonl", lines);
  corpus::Case box = balls(-5);
  box.id = "box";
  box.a.shape = Box<double>{{1, 1, 1}};
  folder.write("box.jsonl", corpus::write_case(box) + "\n");
}

void expect_says(const CommandRun& run, int exit_code, std::initializer_list<const char*> words) {
  EXPECT_EQ(run.exit_code, exit_code) << run.out << run.err;
  for (const char* const word : words) {
    EXPECT_NE((run.out + run.err).find(word), std::string::npos) << word << "\n" << run.out << run.err;
  }
  EXPECT_EQ(bad_engines(), 0U);
}

// ---- graze cast ----

TEST(CastByAnEngine, SaysWhatItAnsweredBesideOurs) {
  const Folder folder;
  write_balls(folder);
  const CommandRun alone = folder.graze("cast balls.jsonl " + engine("none"));
  expect_says(alone, 0, {"method    bad, double, tier declared", "toi       [0.5, 0.5]", "outcome   miss"});
  EXPECT_EQ(alone.out.find("method    gjk"), std::string::npos) << alone.out;
  expect_says(folder.graze("cast balls.jsonl --method gjk " + engine("none")), 0,
              {"method    bad, double", "method    gjk, double"});
}

TEST(CastByAnEngine, SaysItInJson) {
  const Folder folder;
  write_balls(folder);
  const CommandRun run = folder.graze("cast --json --time-limit 0.5 balls.jsonl " + engine("hang 2"));
  EXPECT_EQ(run.exit_code, 1) << run.err;
  std::istringstream lines(run.out);
  std::vector<nlohmann::json> all;
  for (std::string line; std::getline(lines, line);) all.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].at("outcome"), "hit");
  EXPECT_EQ(all[0].at("toi").at("lower"), 0.5);
  EXPECT_EQ(all[0].at("point_a").size(), 3U);
  EXPECT_TRUE(all[0].at("failure").is_null());
  EXPECT_TRUE(all[1].at("point_a").is_null());
  EXPECT_EQ(all[1].at("failure"), "hung");
  EXPECT_TRUE(all[1].at("outcome").is_null());
}

class CastSins : public testing::TestWithParam<std::pair<const char*, const char*>> {};
TEST_P(CastSins, AreSaidAndCounted) {
  const Folder folder;
  write_balls(folder);
  const auto& [fault, words] = GetParam();
  expect_says(folder.graze("cast --time-limit 0.5 balls.jsonl " + engine(std::string(fault) + " 4")), 1,
              {words, "1 without an answer", "toi       [0.5, 0.5]"});
}
INSTANTIATE_TEST_SUITE_P(Every, CastSins,
                         testing::Values(std::pair{"segfault", "failed    crashed: SIGSEGV"},
                                         std::pair{"hang", "failed    hung"},
                                         std::pair{"nan_token", "failed    no number"},
                                         std::pair{"garbage", "failed    garbage"}),
                         [](const auto& fault) { return std::string(fault.param.first); });

TEST(CastByAnEngine, CountsWhatItIsNotAsked) {
  const Folder folder;
  write_balls(folder);
  expect_says(folder.graze("cast balls.jsonl box.jsonl " + engine("none")), 0,
              {"case box: is not asked of bad: its shape box is not taken", "1 not asked"});
}

TEST(CastByAnEngine, NamesWhatWasLeftBehind) {
  const Folder folder;
  write_balls(folder);
  expect_says(folder.graze("cast balls.jsonl " + engine("forks_twice")), 1, {"outlived it, left behind"});
}

TEST(CastByAnEngine, RefusesWhatHasNoMeaning) {
  const Folder folder;
  write_balls(folder);
  expect_says(folder.graze("cast --plan balls.jsonl " + engine("none")), 2, {"--plan"});
  expect_says(folder.graze("cast balls.jsonl " + engine("declares_nonsense")), 2, {"scalar"});
}

// ---- graze campaign ----

constexpr const char* kCampaign =
    "campaign --casts 40 --block 20 --family size_ratio --family smooth_graze --json out.json ";

TEST(CampaignOfAnEngine, AcquitsAnHonestOne) {
  const Folder folder;
  const CommandRun run = folder.graze(kCampaign + engine("none"));
  expect_says(run, 0, {"40 casts by bad/double", "bad/double 1 is held to 1e-09 scale", "None of 40 failed"});
  EXPECT_EQ(run.out.find("exact/double"), std::string::npos);
}

class CampaignSins : public testing::TestWithParam<std::pair<const char*, const char*>> {};
TEST_P(CampaignSins, AreFaults) {
  const Folder folder;
  const auto& [fault, words] = GetParam();
  expect_says(folder.graze(kCampaign + std::string("--time-limit 0.5 --save bad.jsonl --threads 2 ") +
                           engine(std::string(fault) + " 3")),
              1, {words, "FAILED"});
  const corpus::ReadResult saved = corpus::read_file(folder.path() / "bad.jsonl");
  EXPECT_TRUE(saved.ok());
  EXPECT_FALSE(saved.cases.empty());
}
INSTANTIATE_TEST_SUITE_P(Every, CampaignSins,
                         testing::Values(std::pair{"segfault", "without an answer"},
                                         std::pair{"late", "late"}, std::pair{"misses_hits", "wrong"},
                                         std::pair{"nan_token", "no number"},
                                         std::pair{"flips_normals", "normal"}),
                         [](const auto& fault) { return std::string(fault.param.first); });

// The saved state holds all that a summary needs where the engine is missing. The state of another engine is
// not continued.
TEST(CampaignOfAnEngine, IsMergedWithoutIt) {
  const Folder folder;
  for (const char* shard : {"1", "2"}) {
    EXPECT_EQ(folder
                  .graze(std::string(kCampaign) + "--shard " + shard + "/2 --state part" + shard + ".json " +
                         engine("none"))
                  .exit_code,
              0);
  }
  const CommandRun whole = folder.graze(kCampaign + engine("none"));
  const CommandRun merged = folder.graze("merge part1.json part2.json");
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(merged.out, whole.out);
  expect_says(folder.graze(kCampaign + std::string("--shard 1/2 --state part1.json --tolerance 0.5 ") +
                           engine("none")),
              2, {"part1.json belongs to another campaign", "or their bounds differ"});
}

TEST(CampaignOfAnEngine, RefusesAPartThatItCannotBeAsked) {
  const Folder folder;
  expect_says(folder.graze("campaign --queries 5 --family size_ratio " + engine("none")), 2,
              {"none of these engines supports queries"});
}

// ---- graze stability ----

constexpr const char* kStability = "stability --family size_ratio --count 6 ";

TEST(StabilityOfAnEngine, AcquitsAnHonestOneBesideOurs) {
  const Folder folder;
  expect_says(folder.graze(kStability + engine("none")), 0, {"bad/double", "1e-09 scale", "yes"});
  // When our methods run too, the suite is everybody's, and the cases that the engine does not take are counted.
  expect_says(folder.graze(std::string(kStability) + "--method gjk/double " + engine("none")), 0,
              {"gjk/double", "are not asked of bad/double"});
}

class StabilitySins : public testing::TestWithParam<std::pair<const char*, const char*>> {};
TEST_P(StabilitySins, AreBeyondTheRow) {
  const Folder folder;
  const auto& [fault, words] = GetParam();
  expect_says(folder.graze(kStability + std::string("--time-limit 0.5 ") + engine(fault)), 1,
              {words, "broken: bad/double"});
}
INSTANTIATE_TEST_SUITE_P(Every, StabilitySins,
                         testing::Values(std::pair{"segfault", "without an answer by bad/double"},
                                         std::pair{"late", "late"}, std::pair{"misses_hits", "miss"},
                                         std::pair{"garbage", "garbage"}),
                         [](const auto& fault) { return std::string(fault.param.first); });

// ---- graze laws ----

TEST(LawsOfAnEngine, HoldForAnHonestOne) {
  const Folder folder;
  write_balls(folder);
  const CommandRun run = folder.graze("laws balls.jsonl " + engine("none"));
  expect_says(run, 0,
              {"swapping", "never_late", "Every law holds", "laws do not apply to third-party engines",
               "which no engine guarantees", "requesting"});
  // At least one question was asked.
  EXPECT_EQ(folder.graze("laws --law swapping balls.jsonl " + engine("none")).exit_code, 0);
}

TEST(LawsOfAnEngine, CountWhatItIsNotAsked) {
  const Folder folder;
  write_balls(folder);
  const CommandRun run = folder.graze("laws --law never_late balls.jsonl box.jsonl " + engine("none"));
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  // law, engine, needs, answers, not asked, not for the law, failed, broken
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string law, name, needs;
    std::size_t answers = 0, skipped = 0, open = 0, failed = 0, broken = 0;
    if (!(words >> law >> name >> needs >> answers >> skipped >> open >> failed >> broken) ||
        law != "never_late")
      continue;
    EXPECT_EQ(answers, 4U) << line;
    EXPECT_EQ(skipped, 1U) << line;
    EXPECT_EQ(failed + broken, 0U) << line;
    return;
  }
  FAIL() << run.out;
}

class LawSins : public testing::TestWithParam<std::pair<const char*, const char*>> {};
TEST_P(LawSins, BreakLaws) {
  const Folder folder;
  write_balls(folder);
  const auto& [fault, words] = GetParam();
  expect_says(folder.graze("laws --time-limit 0.5 --save bad.jsonl balls.jsonl " + engine(fault)), 1,
              {words, "A law is broken"});
  EXPECT_FALSE(corpus::read_file(folder.path() / "bad.jsonl").cases.empty());
}
TEST(LawsOfAnEngine, BrokenMakeAPageThatShowsThem) {
  const Folder folder;
  write_balls(folder);
  const CommandRun run = folder.graze("laws --law never_late --report out balls.jsonl " + engine("late"));
  expect_says(run, 1, {"broken: never_late by bad/double", "The report is out/index.html"});
  // The command that it names shows the saved case.
  const std::size_t begin = run.out.find("  look     graze ");
  ASSERT_NE(begin, std::string::npos) << run.out;
  const std::string look = run.out.substr(begin + 17, run.out.find('\n', begin) - begin - 17);
  EXPECT_EQ(folder.graze(look).exit_code, 0) << look;
  EXPECT_NE(folder.read("case.html"), "");
  ASSERT_EQ(corpus::read_file(folder.path() / "out" / "cases.jsonl").cases.size(), 1U);
  EXPECT_NE(folder.read("out/index.html").find("never_late"), std::string::npos);
  // Without a folder the same command, for the case that is printed.
  expect_says(folder.graze("laws --law never_late balls.jsonl " + engine("late")), 1,
              {"look     graze show case.json --out case.html (the smallest, saved as case.json)"});
}
INSTANTIATE_TEST_SUITE_P(Every, LawSins,
                         testing::Values(std::pair{"segfault", "crashed: SIGSEGV"},
                                         std::pair{"late", "broken: never_late by bad/double"},
                                         std::pair{"misses_hits", "broken: verdict_is_right by bad/double"},
                                         std::pair{"flips_normals", "broken: normal_supports by bad/double"}),
                         [](const auto& fault) { return std::string(fault.param.first); });

// ---- times ----

TEST(TimesOfEngines, AreThoseOfTheirOwnLoopAlone) {
  const Folder folder;
  write_balls(folder);
  const CommandRun timed =
      folder.graze("certify --queries 0 --method gjk/double --engine " BALL_LIBRARY " balls.jsonl");
  expect_says(timed, 0, {"Time of a call", "balls-c/double", "gjk/double"});
  // An engine that does not time itself has no time, because the time over a pipe does not count as one.
  const CommandRun untimed = folder.graze("certify --queries 0 balls.jsonl " + engine("none"));
  EXPECT_EQ(untimed.exit_code, 0) << untimed.err;
  EXPECT_EQ(untimed.out.find("Time of a call"), std::string::npos) << untimed.out;
  expect_says(folder.graze("certify --queries 0 --engine " BALL_LIBRARY " balls.jsonl " + engine("none")), 0,
              {"Not in the table, since their answers hold no time of machine code: bad/double"});
}

}  // namespace
}  // namespace graze::test
