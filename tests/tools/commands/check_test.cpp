// graze check compares the claims of a record with those of its proof. One line names the lines of a file
// that are not proofs.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "corpus/format/case_io.hpp"
#include "run_command.hpp"

namespace graze {
namespace {

using Json = nlohmann::json;
using test::CommandRun;
using test::Folder;

corpus::Case falling_cube() {
  corpus::Case problem;
  problem.id = "test/hit";
  problem.family = "test";
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b.shape = Box<double>{{0.5, 0.5, 0.5}};
  problem.b.position = {4, 0.25, 0.125};
  problem.b.displacement = {-4, 0, 0};
  return problem;
}

long lines_in(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

// The record of one method's answer to the falling cube, and of what was made of it.
class CheckRecords : public testing::Test {
 protected:
  Folder folder;

  Json cast(const std::string& arguments) {
    folder.write("cube.json", corpus::write_case(falling_cube()));
    const CommandRun run = folder.graze("cast cube.json --proof proofs.jsonl " + arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(folder.read("proofs.jsonl"));
  }
  CommandRun check(std::initializer_list<Json> records) {
    std::string text;
    for (const Json& record : records) text += record.dump() + "\n";
    folder.write("made.jsonl", text);
    return folder.graze("check made.jsonl");
  }
};

TEST_F(CheckRecords, CastWritesTheTierAndTheBracketOfItsAnswer) {
  for (const std::string tier : {"standard", "certified", "exact"}) {
    const Json record = cast("--tier " + tier);
    EXPECT_EQ(record["tier"], tier);
    EXPECT_EQ(record["outcome"], "hit");
    EXPECT_LE(record["toi"]["lower"], 0.625);
    EXPECT_GE(record["toi"]["upper"], 0.625);
    const CommandRun run = folder.graze("check proofs.jsonl");
    EXPECT_EQ(run.exit_code, 0) << run.out;
    EXPECT_EQ(run.out, "1 accepted, 0 refused\n");
    // Records from before these fields existed are read as ever.
    Json old = record;
    old.erase("tier");
    old.erase("toi");
    EXPECT_EQ(check({old}).out, "1 accepted, 0 refused\n");
  }
}

TEST_F(CheckRecords, AcceptsWithinKappaWhatIsFalseByRounding) {
  Json late = cast("--tier exact");
  // The cube goes 4 in a unit of t, and the scale is 4: by 2^-50 of t it goes 8 u of scale.
  late["proof"]["toi_lower"] = late["proof"]["toi_upper"] = 0.625 + 0x1p-50;
  late.erase("toi");
  EXPECT_EQ(check({late}).exit_code, 1);
  EXPECT_EQ(folder.graze("check made.jsonl --kappa 4").exit_code, 1);
  const CommandRun run = folder.graze("check made.jsonl --kappa 16");
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out,
            "1 accepted, 0 refused\n1 of the proofs is true within 16 u of scale, and not exactly\n");
  EXPECT_EQ(folder.graze("check made.jsonl --kappa -1").exit_code, 2);
}

// First contact is at 0.625: a true proof that brackets it from 0.25 to 0.75 says nothing of 0.7, in no tier.
TEST_F(CheckRecords, AcceptsABracketOnlyAsNearAsTheProofProvesIt) {
  for (const std::string tier : {"standard", "certified", "exact"}) {
    Json weak = cast("--tier " + tier);
    weak["proof"]["toi_lower"] = 0.25;
    weak["proof"]["toi_upper"] = 0.75;
    weak["toi"] = {{"lower", 0.25}, {"upper", 0.75}};
    EXPECT_EQ(check({weak}).exit_code, 0) << tier;
    for (const auto& [lower, upper] : {std::pair{0.7, 0.7}, {0.3, 0.3}, {0.7, 0.75}, {0.25, 0.3}}) {
      weak["toi"] = {{"lower", lower}, {"upper", upper}};
      const CommandRun run = check({weak});
      EXPECT_EQ(run.exit_code, 3) << tier << run.out;
      EXPECT_NE(run.out.find("proves only first contact from 0.25 to 0.75"), std::string::npos) << run.out;
    }
  }
  // In the standard tier within kappa u scale: the cube goes 4 in a unit of t, and the scale is 4.
  Json record = cast("--tier standard");
  const double time = record["toi"]["lower"];
  record["proof"]["toi_lower"] = 0.25;
  record["toi"]["lower"] = record["toi"]["upper"] = time + 32 * 0x1p-53;
  EXPECT_EQ(check({record}).exit_code, record["proof"]["toi_upper"] < record["toi"]["lower"] ? 1 : 0);
  record["proof"]["toi_upper"] = 0.75;
  EXPECT_EQ(check({record}).exit_code, 0);
  record["toi"]["lower"] = record["toi"]["upper"] = time + 128 * 0x1p-53;
  EXPECT_EQ(check({record}).exit_code, 3);
  // An engine without a guarantee is granted nothing, unless it is given.
  record["toi"]["lower"] = record["toi"]["upper"] = time + 32 * 0x1p-53;
  record["method"] = "mine";
  EXPECT_EQ(check({record}).exit_code, 3);
  EXPECT_EQ(folder.graze("check made.jsonl --kappa 64").exit_code, 0);
}

TEST_F(CheckRecords, RefusesARecordThatItsProofContradicts) {
  const Json sound = cast("--tier exact");
  Json miss = sound, start = sound, late = sound;
  miss["outcome"] = "miss";
  miss.erase("toi");
  start["outcome"] = "initially_overlapping";
  start.erase("toi");
  late["toi"] = {{"lower", 0.75}, {"upper", 0.75}};
  const CommandRun run = check({miss, start, late, sound});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(
      run.out,
      "refused  test/hit  exact/double  contradicted: claims miss, proves first contact from 0.625 to 0.625\n"
      "refused  test/hit  exact/double  contradicted: claims initially_overlapping, proves first contact "
      "from 0.625 to 0.625\n"
      "refused  test/hit  exact/double  contradicted: claims hit from 0.75 to 0.75, proves first contact "
      "from 0.625 to 0.625\n"
      "1 accepted, 3 refused\n");
}

TEST_F(CheckRecords, RefusesARecordThatProvesNothing) {
  Json record = cast("--tier exact");
  record["outcome"] = "miss";
  record.erase("toi");
  record["proof"] = {{"toi_lower", 0}, {"toi_upper", "inf"}};
  EXPECT_EQ(check({record}).exit_code, 1);
  record.erase("tier");
  const CommandRun run = check({record});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(
      run.out,
      "refused  test/hit  exact/double  unproved: claims miss, proves nothing\n0 accepted, 1 refused\n");
}

TEST_F(CheckRecords, HalfOfAHitIsNeitherAcceptedNorRefused) {
  const Json sound = cast("--tier exact");
  Json lower = sound, upper = sound, false_half = sound;
  lower["proof"]["toi_upper"] = "inf";
  lower["proof"].erase("portal");
  upper["proof"]["toi_lower"] = 0;
  upper["proof"].erase("axis");
  for (Json* half : {&lower, &upper}) half->erase("toi");
  const CommandRun run = check({lower, sound, upper});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.out,
            "in part  test/hit  exact/double  claims hit, proves only no contact before 0.625\n"
            "in part  test/hit  exact/double  claims hit, proves only contact by 0.625\n"
            "1 accepted, 2 proved in part, 0 refused\n");
  // A refusal is graver, and what cannot be read graver still.
  false_half["proof"]["toi_lower"] = 0.75;
  const CommandRun graver = check({lower, false_half});
  EXPECT_EQ(graver.exit_code, 1);
  EXPECT_NE(graver.out.find("0 accepted, 1 proved in part, 1 refused"), std::string::npos) << graver.out;
  folder.write("bad.jsonl", "{}\n");
  EXPECT_EQ(folder.graze("check bad.jsonl made.jsonl").exit_code, 2);
}

TEST_F(CheckRecords, AFileOfCasesIsOneComplaint) {
  const CommandRun generated = folder.graze("generate random --count 500 --seed 3");
  ASSERT_EQ(generated.exit_code, 0);
  const auto expect_one = [](const CommandRun& run, const std::string& holds) {
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(lines_in(run.err), 1) << run.err;
    for (const std::string& part : {holds, std::string("graze.case/1"), std::string("graze cast --proof")})
      EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "0 accepted, 0 refused\n");
  };
  folder.write("cases.jsonl", generated.out);
  expect_one(folder.graze("check cases.jsonl"), "cases.jsonl:1: schema: holds 500 cases");
  expect_one(folder.graze("check -", generated.out), "holds 500 cases");
  folder.write("one.json", corpus::write_case(falling_cube()));
  expect_one(folder.graze("check one.json"), "holds a case");
  // One object over many lines, as corpus files are.
  folder.write("pretty.json", corpus::write_case_pretty(falling_cube()));
  ASSERT_GT(lines_in(folder.read("pretty.json")), 1);
  expect_one(folder.graze("check pretty.json"), "holds a case");
  // Proofs beside them are judged all the same, over many lines too.
  const Json sound = cast("--tier exact");
  folder.write("both.jsonl", generated.out + sound.dump() + "\n");
  const CommandRun both = folder.graze("check both.jsonl");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_EQ(lines_in(both.err), 1) << both.err;
  EXPECT_EQ(both.out, "1 accepted, 0 refused\n");
  folder.write("pretty_proof.json", sound.dump(2));
  EXPECT_EQ(folder.graze("check pretty_proof.json").out, "1 accepted, 0 refused\n");
}

}  // namespace
}  // namespace graze
