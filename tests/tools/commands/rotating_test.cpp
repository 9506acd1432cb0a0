// The command graze on cases in which a body turns, and the plans that it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "corpus/format/case_io.hpp"
#include "engines/method.hpp"
#include "run_command.hpp"
#include "tests/shared/rotating_cases.hpp"

namespace graze {
namespace {

using Json = nlohmann::json;
using test::CommandRun;
using test::Folder;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void expect_one_complaint(const CommandRun& run, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(lines_of(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
  for (const std::string& part : parts)
    EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
}

// A folder with the bar, the ball, a linear case and one at rest.
struct Scene : Folder {
  Scene() {
    write("bar.json", corpus::write_case(test::turning_bar()));
    write("ball.json", corpus::write_case(test::spinning_ball()));
    corpus::Case straight = test::spinning_ball(), still = test::spinning_ball();
    straight.id = "test/straight";
    straight.spin_b = {};
    write("straight.json", corpus::write_case(straight));
    still.id = "test/still";
    still.spin_b = {};
    still.b.displacement.setZero();
    write("still.json", corpus::write_case(still));
  }
};

TEST(CastRotating, IsAnsweredByThePlanWhichTheTextShows) {
  const Scene scene;
  const CommandRun run = scene.graze("cast bar.json ball.json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("method    plan, double, tier standard"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("plan      rotating: A's rotation can be seen"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("plan      linear: B's rotation cannot be seen"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("poses"), std::string::npos);
}

TEST(CastRotating, JsonReadsBackToTheSameBits) {
  const Scene scene;
  for (const std::string scalar : {"double", "float"}) {
    const CommandRun run = scene.graze("cast bar.json --json --method all --scalar " + scalar);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::vector<std::string> lines = lines_of(run.out);
    ASSERT_EQ(lines.size(), 7U);
    for (const std::string& line : lines) {
      const Json json = Json::parse(line);
      const engine::Method* method =
          engine::find_method(engine::Kind::rotating, json["method"].get<std::string>() + "/" + scalar);
      ASSERT_NE(method, nullptr);
      const engine::Answer answer =
          method->ask(test::turning_bar(), {.request = Request::normal | Request::witnesses});
      EXPECT_EQ(json["tier"], method->tier);
      EXPECT_EQ(json["toi"]["lower"].get<double>(), answer.toi_lower);
      EXPECT_EQ(json["toi"]["upper"].get<double>(), answer.toi_upper);
      EXPECT_EQ(json["point_b"][1].get<double>(), answer.point_b.y());
      EXPECT_EQ(json["hidden_motion"].get<double>(), answer.hidden_motion);
      EXPECT_EQ(json["plan"], "rotating");
    }
  }
}

TEST(CastRotating, ByAMethodOrATierThatIsNamed) {
  const Scene scene;
  for (const std::string choice :
       {"--method certified", "--tier certified", "--method bilateral/float", "--method steps"}) {
    const CommandRun run = scene.graze("cast bar.json --json " + choice);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["outcome"], "hit");
    EXPECT_EQ(json["tier"], choice.find("certified") != std::string::npos ? "certified" : "standard");
  }
  // A linear case may have a rotating method, but a rotating case has no linear one.
  EXPECT_EQ(Json::parse(scene.graze("cast straight.json --json --method bilateral").out)["method"],
            "bilateral");
  expect_one_complaint(scene.graze("cast bar.json --method gjk"),
                       {"bar.json", "gjk", "rotating", "bilateral"});
  expect_one_complaint(scene.graze("cast bar.json --method spin"), {"--method", "spin", "bilateral"});
  expect_one_complaint(scene.graze("cast bar.json --tier certified --method ca"),
                       {"--tier", "certified", "ca"});
  expect_one_complaint(scene.graze("cast bar.json --tier good"), {"--tier", "good", "certified"});
}

TEST(CastRotating, TierExactAnswersOnlyWhereNoTurnIsSeen) {
  const Scene scene;
  expect_one_complaint(scene.graze("cast bar.json --tier exact --json"),
                       {"test/turning-bar", "rotation", "exact"});
  corpus::Case together = test::turning_bar();
  together.id = "test/together";
  together.spin_b.rotation = together.spin_a.rotation;
  together.spin_b.pivot = {0, 1.2, 0};  // the same axis
  scene.write("together.json", corpus::write_case(together));
  const CommandRun run = scene.graze("cast together.json --tier exact --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["outcome"], "miss");
  EXPECT_EQ(json["plan"], "static");
}

TEST(CastRotating, ProofsAreWrittenAndAccepted) {
  const Scene scene;
  ASSERT_EQ(scene.graze("cast bar.json ball.json --tier certified --proofs proofs.jsonl").exit_code, 0);
  EXPECT_EQ(lines_of(scene.read("proofs.jsonl")).size(), 2U);
  const CommandRun check = scene.graze("check proofs.jsonl");
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_EQ(check.out, "2 accepted, 0 refused\n");
}

TEST(CastRotating, WhatIsOnlyForLinearMotionsIsRefusedWithTheReason) {
  const Scene scene;
  corpus::Case ray = test::turning_bar();
  ray.t_max = std::numeric_limits<double>::infinity();
  scene.write("ray.json", corpus::write_case(ray));
  expect_one_complaint(scene.graze("cast ray.json --json"), {"ray.json", "t_max", "rotation"});
}

TEST(CastPlan, SaysWhatMustBeSimulatedAndWhyAndCastsNothing) {
  const Scene scene;
  const CommandRun text = scene.graze("cast --plan bar.json straight.json");
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("  plan      rotating\n  because   A's rotation can be seen\n"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("  plan      linear\n  because   neither body rotates\n"), std::string::npos)
      << text.out;
  EXPECT_EQ(text.out.find("toi"), std::string::npos);
  const CommandRun run = scene.graze("cast --plan --json bar.json ball.json straight.json still.json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<std::string> lines = lines_of(run.out);
  ASSERT_EQ(lines.size(), 4U);
  const std::vector<std::string> effects = {"rotating", "linear", "linear", "static"};
  const std::vector<std::string> reasons = {"A's rotation can be seen", "B's rotation cannot be seen",
                                            "neither body rotates", "nothing moves"};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Json json = Json::parse(lines[i]);
    EXPECT_EQ(json.size(), 3U);
    EXPECT_EQ(json["plan"], effects[i]);
    EXPECT_NE(std::find(json["reasons"].begin(), json["reasons"].end(), reasons[i]), json["reasons"].end())
        << lines[i];
  }
}

TEST(CastPlan, GoesWithNoMethodNoProofAndNoOtherQuery) {
  const Scene scene;
  expect_one_complaint(scene.graze("cast --plan bar.json --method ca"), {"--plan", "--method"});
  expect_one_complaint(scene.graze("cast --plan bar.json --proof p.jsonl"), {"--plan", "--proof"});
  corpus::Case overlap = test::turning_bar(), empty = test::turning_bar();
  overlap.query = corpus::Query::overlap;
  scene.write("overlap.json", corpus::write_case(overlap));
  expect_one_complaint(scene.graze("cast --plan overlap.json"), {"overlap.json", "other than cast"});
  empty.a.shape = Sphere<double>{-1};
  scene.write("negative.json", corpus::write_case(empty));
  expect_one_complaint(scene.graze("cast --plan negative.json"), {"negative.json", "radius"});
}

TEST(CertifyRotating, JudgesFilesAndFamiliesAndCanBeSwitchedOff) {
  const Scene scene;
  const CommandRun file =
      scene.graze("certify bar.json straight.json --method bilateral --method certified/double --full");
  EXPECT_EQ(file.exit_code, 0) << file.out << file.err;
  EXPECT_NE(file.out.find("Rotating casts"), std::string::npos);
  EXPECT_NE(file.out.find("Every method keeps its guarantee"), std::string::npos);
  const CommandRun off = scene.graze("certify bar.json straight.json --rotating 0");
  EXPECT_EQ(off.exit_code, 0) << off.out << off.err;
  EXPECT_EQ(off.out.find("Rotating casts"), std::string::npos);
  expect_one_complaint(scene.graze("certify bar.json --rotating 0"), {"no case"});
}

TEST(CertifyRotating, ExitsWith1AndNamesRowAndCaseIfAMethodBreaksItsRow) {
  const Scene scene;
  scene.write("strict.json", R"({"schema": "graze.guarantees/1", "rows": [
    {"query": "rotating", "method": "bilateral", "scalar": "double", "tier": "standard",
     "kappa_polytope": 0, "kappa_rounded": 0, "stall_cap": 0, "mechanism": ""}]})");
  const CommandRun run =
      scene.graze("certify bar.json --method bilateral/double --guarantees strict.json --save saved.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  EXPECT_NE(run.out.find(" by rotating bilateral/double: "), std::string::npos) << run.out;
  EXPECT_NE(scene.read("saved.jsonl").find("test/turning-bar"), std::string::npos);
}

}  // namespace
}  // namespace graze
