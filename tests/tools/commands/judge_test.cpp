// graze judge holds answers that were made elsewhere against the judge of certify, each by its id.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "corpus/format/case_io.hpp"
#include "run_command.hpp"

namespace graze {
namespace {

using Json = nlohmann::json;
using test::CommandRun;
using test::Folder;

// Meets the cube's face at t = 0.375. Lifted by 2.5 it passes it by one.
corpus::Case flying_ball(const std::string& id, double height) {
  corpus::Case problem;
  problem.id = id;
  problem.family = "test";
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = {-4.5, height, 0};
  problem.b.displacement = {8, 0, 0};
  return problem;
}

Json hit(const std::string& id, double time) {
  return {
      {"schema", "graze.answer/1"}, {"id", id}, {"outcome", "hit"}, {"time", time}, {"normal", {-1, 0, 0}}};
}
Json miss(const std::string& id) { return {{"schema", "graze.answer/1"}, {"id", id}, {"outcome", "miss"}}; }

class Judge : public testing::Test {
 protected:
  Folder folder;

  Judge() {
    folder.write("cases.jsonl", corpus::write_case(flying_ball("t/hit", 0)) + "\n" +
                                    corpus::write_case(flying_ball("t/miss", 2.5)) + "\n");
  }
  CommandRun judge(const std::vector<Json>& answers, const std::string& arguments = "") {
    std::string text;
    for (const Json& answer : answers) text += answer.dump() + "\n";
    folder.write("answers.jsonl", text);
    return folder.graze("judge answers.jsonl --cases cases.jsonl " + arguments);
  }
};

TEST_F(Judge, FindsNoFaultWithRightAnswers) {
  const CommandRun run = judge({hit("t/hit", 0.375), miss("t/miss")}, "--tolerance 1e-9");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("0 of 2 answers at fault"), std::string::npos) << run.out;
}

TEST_F(Judge, NamesEachAnswerAtFaultAndItsFault) {
  const CommandRun late = judge({hit("t/hit", 0.4), miss("t/miss")}, "--tolerance 0.01 --full");
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_NE(late.out.find("t/hit  late  "), std::string::npos) << late.out;
  EXPECT_EQ(late.out.find("t/miss  "), std::string::npos) << late.out;
  const CommandRun wrong = judge({miss("t/hit"), hit("t/miss", 0.375)}, "--tolerance 0.01 --full");
  EXPECT_NE(wrong.out.find("t/hit  wrong  "), std::string::npos) << wrong.out;
  EXPECT_NE(wrong.out.find("t/miss  wrong  "), std::string::npos) << wrong.out;
  EXPECT_NE(wrong.out.find("2 of 2 answers at fault"), std::string::npos) << wrong.out;
}

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// A late hit is off by as much, and its normal may be wrong as well: that is one fault, told once.
TEST_F(Judge, TellsOneFaultOfAnAnswerAfterTheTableAndTheOthersInBrackets) {
  Json late = hit("t/hit", 0.4);
  late["normal"] = {0, 1, 0};
  const CommandRun run = judge({late, miss("t/miss")}, "--tolerance 0.01");
  EXPECT_EQ(run.exit_code, 1);
  const std::size_t table = run.out.find("answers/double"),
                    line = run.out.find(
                        "\nlate: 1 answer of 1 method in 1 family; the first is t/hit by answers/double: ");
  ASSERT_NE(table, std::string::npos) << run.out;
  ASSERT_NE(line, std::string::npos) << run.out;
  EXPECT_LT(table, line);
  EXPECT_NE(run.out.find("(also off, contact off)", line), std::string::npos) << run.out;
  EXPECT_EQ(lines_with(run.out, "t/hit by"), 1U) << run.out;
  EXPECT_EQ(run.out.find("t/hit  "), std::string::npos) << run.out;
  // Decimals, not hexfloats.
  EXPECT_NE(run.out.find("0.4", line), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("0x"), std::string::npos) << run.out;
}

// docs/reference/protocol.md: a hit is at a time above 0.
TEST_F(Judge, TakesAHitAtTime0ForWrong) {
  corpus::Case start = flying_ball("t/start", 0);
  start.b.position = {-1.5, 0, 0};
  folder.write("cases.jsonl", corpus::write_case(start) + "\n");
  const CommandRun wrong = judge({hit("t/start", 0)}, "--tolerance 0.01");
  EXPECT_EQ(wrong.exit_code, 1) << wrong.out;
  EXPECT_NE(wrong.out.find("\nwrong: 1 answer"), std::string::npos) << wrong.out;
  EXPECT_NE(wrong.out.find("a hit at time 0"), std::string::npos) << wrong.out;
  Json right = {{"schema", "graze.answer/1"}, {"id", "t/start"}, {"outcome", "initially_overlapping"}};
  EXPECT_EQ(judge({right}, "--tolerance 0.01").exit_code, 0);
}

// Without a promise it is held to 1e-3 of scale: the ball flies 4.5 to the cube's middle, and 0.025 of 8 is 0.2.
TEST_F(Judge, HoldsAnEngineWithoutAPromiseToAThousandthOfScale) {
  const CommandRun late = judge({hit("t/hit", 0.4), miss("t/miss")});
  EXPECT_EQ(late.exit_code, 1) << late.out << late.err;
  EXPECT_NE(late.out.find("0.001 scale (none declared)"), std::string::npos) << late.out;
  EXPECT_EQ(judge({hit("t/hit", 0.3755), miss("t/miss")}).exit_code, 0);  // 0.004 of a scale of 4.5
  const CommandRun wrong = judge({miss("t/hit"), miss("t/miss")});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.out.find("1 of 2 answers at fault"), std::string::npos) << wrong.out;
  EXPECT_EQ(judge({miss("t/hit"), miss("t/miss")}, "--measure --kappa 1").exit_code, 2);
}

TEST_F(Judge, SaysWithWhichLimitAnEngineThatIsOnlyMeasuredWouldHavePassed) {
  const CommandRun run = judge({hit("t/hit", 0.4), miss("t/miss")}, "--measure --json out.json");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const Json total = Json::parse(folder.read("out.json"))["methods"][0]["total"];
  EXPECT_NEAR(total["least_tolerance"].get<double>(), 0.2, 1e-6);  // 0.025 of 8
}

TEST_F(Judge, HoldsAnEngineToWhatItsFilePromises) {
  Json engine = {{"schema", "graze.engine/1"},
                 {"name", "mine"},
                 {"scalar", "float"},
                 {"shapes", {"box", "sphere"}},
                 {"queries", {{"cast", {{"answers", {"time"}}, {"tolerance", 0.3}}}}}};
  folder.write("engine.json", engine.dump(1));
  EXPECT_EQ(judge({hit("t/hit", 0.4), miss("t/miss")}, "--engine-file engine.json").exit_code, 0);
  engine["queries"]["cast"]["tolerance"] = 0.1;
  folder.write("engine.json", engine.dump(1));
  const CommandRun run = judge({hit("t/hit", 0.4), miss("t/miss")}, "--engine-file engine.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("mine/float"), std::string::npos) << run.out;
  engine["scalar"] = "half";
  folder.write("engine.json", engine.dump(1));
  EXPECT_EQ(judge({miss("t/hit"), miss("t/miss")}, "--engine-file engine.json").exit_code, 2);
}

TEST_F(Judge, CountsWhatIsDeclined) {
  const Json declined = {{"schema", "graze.answer/1"}, {"id", "t/hit"}, {"outcome", "unsupported"}};
  const CommandRun run = judge({declined, miss("t/miss")}, "--json out.json");
  EXPECT_EQ(run.exit_code, 1) << run.out;
  EXPECT_NE(run.out.find("0 of 1 answers at fault; answers/double declines 1 of 2 questions (50 %)"),
            std::string::npos)
      << run.out;
  const Json total = Json::parse(folder.read("out.json"))["methods"][0]["total"];
  EXPECT_EQ(total["declined"], 1);
  EXPECT_EQ(total["cases"], 1);
  const CommandRun allowed = judge({declined, miss("t/miss")}, "--allow-declined");
  EXPECT_EQ(allowed.exit_code, 0) << allowed.out;
  EXPECT_NE(allowed.out.find("declines 1 of 2 questions"), std::string::npos) << allowed.out;
}

// An engine may declare how much work its answers take at most.
TEST_F(Judge, HoldsAnEngineToItsMostSupports) {
  const Json engine = {
      {"schema", "graze.engine/1"},
      {"name", "mine"},
      {"scalar", "double"},
      {"shapes", {"box", "sphere"}},
      {"queries", {{"cast", {{"answers", {"time"}}, {"tolerance", 0.3}, {"most_supports", 64}}}}}};
  folder.write("engine.json", engine.dump(1));
  Json answer = hit("t/hit", 0.375);
  for (const int supports : {64, 65}) {
    answer["supports"] = supports;
    const CommandRun run = judge({answer, miss("t/miss")}, "--engine-file engine.json");
    EXPECT_EQ(run.exit_code, supports > 64 ? 1 : 0) << run.out;
    EXPECT_EQ(run.out.find("\nwork: 1 answer") != std::string::npos, supports > 64) << run.out;
  }
}

TEST_F(Judge, NamesTheLineAndTheIdOfWhatDoesNotFit) {
  const CommandRun run = judge({hit("t/hit", 0.375), miss("t/other"), miss("t/hit")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("answers.jsonl:2: id t/other: no case has it"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("answers.jsonl:3: id t/hit: line 1 answers it, too"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("id t/miss: is not answered"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("0 of 1 answers at fault"), std::string::npos) << run.out;
}

TEST_F(Judge, TakesNanAndGarbageForFaultsOfTheAnswer) {
  folder.write("answers.jsonl",
               R"({"schema": "graze.answer/1", "id": "t/hit", "outcome": "hit", "time": "nan"})"
               "\n"
               R"({"schema": "graze.answer/1", "id": "t/miss", "outcome": "perhaps"})"
               "\n");
  const CommandRun run = folder.graze("judge answers.jsonl --cases cases.jsonl --full");
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find("t/hit  failed  "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("t/miss  failed  "), std::string::npos) << run.out;
}

}  // namespace
}  // namespace graze
