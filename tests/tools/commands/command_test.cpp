// The command graze: its answers, its exit codes, and what it says about bad input.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "corpus/format/case_io.hpp"
#include "engines/method.hpp"
#include "run_command.hpp"

namespace graze {
namespace {

using Json = nlohmann::json;
using test::CommandRun;
using test::Folder;

constexpr const char* kHit = R"({"schema": "graze.case/1", "id": "test/hit", "family": "test",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 0.1]}},
 "b": {"shape": {"type": "sphere", "radius": 0.3}, "position": [0.1, 0.2, 1.4], "displacement": [0.1, 0, -10]}}
)";
constexpr const char* kEllipsoid = R"({"schema": "graze.case/1", "id": "test/ellipsoid", "family": "test",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 0.1]}},
 "b": {"shape": {"type": "ellipsoid", "radii": [0.3, 0.2, 0.1]}, "position": [0, 0, 2], "displacement": [0, 0, -4]}}
)";
constexpr const char* kMiss = R"({"schema": "graze.case/1", "id": "test/miss", "family": "test",
 "a": {"shape": {"type": "point"}}, "b": {"shape": {"type": "sphere", "radius": 0.25}, "position": [0, 0, 2]}}
)";
constexpr const char* kOverlap = R"({"schema": "graze.case/1", "id": "test/overlap", "family": "test",
 "a": {"shape": {"type": "point"}}, "b": {"shape": {"type": "sphere", "radius": 0.25}}}
)";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Exactly one line, which names the program and everything in `parts`.
void expect_one_complaint(const CommandRun& run, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(lines_of(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
  for (const std::string& part : parts)
    EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
}

TEST(Help, EveryCommandExplainsItselfAndItsExitCode) {
  const Folder folder;
  const CommandRun top = folder.graze("--help");
  EXPECT_EQ(top.exit_code, 0);
  for (const std::string command : {"cast", "check", "certify", "generate"}) {
    EXPECT_NE(top.out.find(command), std::string::npos);
    const CommandRun help = folder.graze(command + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("  graze " + command), std::string::npos) << help.out;
    EXPECT_GT(lines_of(help.out).size(), 8U);
  }
  EXPECT_EQ(folder.graze("--version").out, "graze 0.3.0\n");
  expect_one_complaint(folder.graze(""), {"--help"});
  expect_one_complaint(folder.graze("cats"), {"cats"});
}

TEST(Cast, JsonLinesHaveExactlyThePromisedFieldsAndReadBackToTheSameBits) {
  const Folder folder;
  folder.write("hit.json", kHit);
  const corpus::ReadResult read = corpus::read_text(kHit, "hit.json", false);
  ASSERT_TRUE(read.ok());
  for (const std::string scalar : {"double", "float"}) {
    const CommandRun run = folder.graze("cast hit.json --json --method all --scalar " + scalar);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::vector<std::string> lines = lines_of(run.out);
    ASSERT_EQ(lines.size(), 5U);
    for (const std::string& line : lines) {
      const Json json = Json::parse(line);
      std::set<std::string> keys;
      for (const auto& [key, value] : json.items()) keys.insert(key);
      EXPECT_EQ(keys,
                (std::set<std::string>{"id", "outcome", "because", "toi", "normal", "point_a", "point_b",
                                       "method", "scalar", "tier", "iterations", "supports"}));
      EXPECT_EQ(json["id"], "test/hit");
      EXPECT_EQ(json["outcome"], "hit");
      const engine::Method* method =
          engine::find_method(engine::Kind::linear, json["method"].get<std::string>() + "/" + scalar);
      ASSERT_NE(method, nullptr);
      EXPECT_EQ(json["tier"], method->tier);
      const engine::Answer answer =
          method->ask(read.cases[0], {.request = Request::normal | Request::witnesses});
      const auto same_bits = [](const Json& number, double x) {
        return std::bit_cast<std::uint64_t>(number.get<double>()) == std::bit_cast<std::uint64_t>(x);
      };
      EXPECT_TRUE(same_bits(json["toi"]["lower"], answer.toi_lower));
      EXPECT_TRUE(same_bits(json["toi"]["upper"], answer.toi_upper));
      for (const int i : {0, 1, 2}) {
        EXPECT_TRUE(same_bits(json["normal"][static_cast<std::size_t>(i)], answer.normal[i]));
        EXPECT_TRUE(same_bits(json["point_a"][static_cast<std::size_t>(i)], answer.point_a[i]));
        EXPECT_TRUE(same_bits(json["point_b"][static_cast<std::size_t>(i)], answer.point_b[i]));
      }
      EXPECT_EQ(json["iterations"], answer.counters.iterations);
    }
  }
}

TEST(Cast, WhatAnAnswerDoesNotHoldIsNull) {
  const Folder folder;
  folder.write("miss.json", kMiss);
  folder.write("overlap.json", kOverlap);
  const CommandRun run = folder.graze("cast miss.json overlap.json --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<std::string> lines = lines_of(run.out);
  ASSERT_EQ(lines.size(), 2U);
  const Json miss = Json::parse(lines[0]), overlap = Json::parse(lines[1]);
  EXPECT_EQ(miss["outcome"], "miss");
  EXPECT_TRUE(miss["toi"].is_null());
  EXPECT_TRUE(miss["normal"].is_null());
  EXPECT_EQ(overlap["outcome"], "initially_overlapping");
  EXPECT_EQ(overlap["toi"]["lower"], 0.0);
  EXPECT_TRUE(overlap["point_a"].is_null());
}

TEST(Cast, ReadsStandardInputWhetherOneObjectOrOneALine) {
  const Folder folder;
  EXPECT_NE(folder.graze("cast -", kHit).out.find("test/hit"), std::string::npos);
  const CommandRun generated = folder.graze("generate random --count 3 --seed 5");
  ASSERT_EQ(generated.exit_code, 0);
  EXPECT_EQ(lines_of(folder.graze("cast - --json", generated.out).out).size(), 3U);
}

TEST(Cast, AMalformedFileIsOneLineOfComplaintAndTheOthersAreAnswered) {
  struct Bad {
    const char *text, *field;
  };
  const Bad bad[] = {
      {"not json", ""},
      {R"({"schema": "graze.case/1", "id": "x", "family": "x", "colour": 1})", "colour"},
      {R"({"schema": "graze.case/1", "id": "x", "family": "x", "a": {"shape": {"type": "sphere", "radius": "r"}},
           "b": {"shape": {"type": "point"}}})",
       "a.shape.radius"},
      {R"({"schema": "graze.case/1", "id": "x", "family": "x", "a": {"shape": {"type": "point"}},
           "b": {"shape": {"type": "hull", "vertices": []}}})",
       "b.shape.vertices"},
  };
  const std::string deep = std::string(100000, '[');
  for (const Bad& one : bad) {
    const Folder folder;
    folder.write("bad.json", one.text);
    folder.write("good.json", kHit);
    const CommandRun run = folder.graze("cast bad.json good.json --json");
    expect_one_complaint(run, {"bad.json", one.field});
    EXPECT_NE(run.out.find("test/hit"), std::string::npos);
  }
  const Folder folder;
  folder.write("deep.json", deep);
  expect_one_complaint(folder.graze("cast deep.json"), {"deep.json"});
  expect_one_complaint(folder.graze("cast missing.json"), {"missing.json"});
}

TEST(Cast, TheExactTierBracketsTheTimeByNeighbouringDoubles) {
  const Folder folder;
  const std::string cube = R"({"schema": "graze.case/1", "id": "test/cube", "family": "test",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 1]}},
 "b": {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "position": [0, 0, 3], "displacement": [0, 0, -3]}})";
  folder.write("cube.json", cube);
  for (const std::string choice : {"--method exact", "--tier exact"}) {
    const CommandRun run = folder.graze("cast cube.json --json --proof proof.jsonl " + choice);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["tier"], "exact");
    EXPECT_EQ(json["toi"]["lower"], std::nextafter(json["toi"]["upper"].get<double>(), 0.0));
    EXPECT_EQ(json["toi"]["lower"], 1.0 / 3);
    EXPECT_EQ(folder.graze("check proof.jsonl").exit_code, 0);
  }
  EXPECT_EQ(lines_of(folder.graze("cast cube.json --json --method all").out).size(), 5U);
  std::string line = cube;
  line.insert(line.rfind('}'), R"(, "query": "line")");
  folder.write("line.json", line);
  const Json answer = Json::parse(folder.graze("cast line.json --json --tier exact").out);
  EXPECT_EQ(answer["tier"], "exact");
  EXPECT_EQ(answer["t_in"]["lower"], 1.0 / 3);
  folder.write("ellipsoid.json", kEllipsoid);
  expect_one_complaint(folder.graze("cast ellipsoid.json --tier exact"),
                       {"test/ellipsoid", "body b: shape", "tier exact"});
}

TEST(Certify, JudgesTheExactTierToTheLastBitAndSaysWhatThatAllows) {
  const Folder folder;
  const CommandRun run = folder.graze(
      "certify --family grazing_edge --family curved --count 300 --method exact --queries 20 --full");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("0 wrong, 0 stalled"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("below 3/n"), std::string::npos) << run.out;
}

TEST(Cast, WhatThisVersionLacksIsSaidAndNotAnswered) {
  const Folder folder;
  folder.write("hit.json", kHit);
  expect_one_complaint(folder.graze("cast hit.json --tier exact --method mpr"), {"--tier", "mpr"});
  expect_one_complaint(folder.graze("cast hit.json --method epa"), {"epa", "gjk"});
  expect_one_complaint(folder.graze("cast hit.json --scalar half"), {"half", "float"});
  expect_one_complaint(folder.graze("cast hit.json --proof no/such/folder.jsonl"), {"no/such/folder.jsonl"});
}

TEST(Check, AcceptsTheProofsThatCastWrites) {
  const Folder folder;
  folder.write("hit.json", kHit);
  folder.write("miss.json", kMiss);
  for (const std::string scalar : {"double", "float"}) {
    ASSERT_EQ(folder.graze("cast hit.json miss.json --method all --proof proofs.jsonl --scalar " + scalar)
                  .exit_code,
              0);
    const CommandRun check = folder.graze("check proofs.jsonl");
    EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
    EXPECT_EQ(check.out, "10 accepted, 0 refused\n");
  }
}

TEST(Check, RefusesAProofThatWasTamperedWithAndNamesTheClaim) {
  const Folder folder;
  folder.write("hit.json", kHit);
  ASSERT_EQ(folder.graze("cast hit.json --proof proofs.jsonl").exit_code, 0);
  Json record = Json::parse(folder.read("proofs.jsonl"));
  record["proof"]["toi_lower"] = 0.5;  // the contact is at about 0.1
  folder.write("tampered.jsonl", record.dump() + "\n");
  const CommandRun check = folder.graze("check proofs.jsonl tampered.jsonl");
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_NE(check.out.find("test/hit"), std::string::npos);
  EXPECT_NE(check.out.find("lower_not_proved"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("1 accepted, 1 refused"), std::string::npos);
}

TEST(Check, BadInputWinsOverARefusal) {
  const Folder folder;
  folder.write("bad.jsonl", "{}\n");
  expect_one_complaint(folder.graze("check bad.jsonl"), {"bad.jsonl"});
  folder.write("hit.json", kHit);
  ASSERT_EQ(folder.graze("cast hit.json --proof proofs.jsonl").exit_code, 0);
  Json record = Json::parse(folder.read("proofs.jsonl"));
  record["proof"]["toi_lower"] = 0.5;
  folder.write("tampered.jsonl", record.dump() + "\n");
  const CommandRun both = folder.graze("check bad.jsonl tampered.jsonl");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.out.find("1 refused"), std::string::npos);
}

// A table that no arithmetic can keep: any rounding at all breaks it.
std::string guarantees_with(double kappa) {
  Json rows = Json::array();
  for (const engine::Method& method : engine::methods(engine::Kind::linear)) {
    rows.push_back({{"method", method.name},
                    {"scalar", method.scalar},
                    {"tier", method.tier},
                    {"kappa_polytope", kappa},
                    {"kappa_rounded", kappa},
                    {"stall_cap", 1},
                    {"mechanism", "a test"}});
  }
  return Json{{"schema", "graze.guarantees/1"}, {"rows", rows}}.dump();
}

TEST(Certify, ExitsWith1AndNamesRowAndCaseIfAMethodBreaksItsRow) {
  const Folder folder;
  folder.write("generous.json", guarantees_with(1e15));
  folder.write("strict.json", guarantees_with(0));
  const std::string family = "certify --family random --count 40 --method mpr/double --guarantees ";
  const CommandRun kept = folder.graze(family + "generous.json");
  EXPECT_EQ(kept.exit_code, 0) << kept.out << kept.err;
  EXPECT_NE(kept.out.find("Every method keeps its guarantee"), std::string::npos);
  const CommandRun broken = folder.graze(family + "strict.json --save saved.jsonl");
  EXPECT_EQ(broken.exit_code, 1) << broken.out << broken.err;
  EXPECT_NE(broken.out.find(" of 1 method in 1 family; the first is random/h"), std::string::npos)
      << broken.out;
  EXPECT_NE(broken.out.find(" by mpr/double: "), std::string::npos) << broken.out;
  EXPECT_EQ(broken.out.find("broken: "), std::string::npos) << broken.out;
  const CommandRun full = folder.graze(family + "strict.json --full");
  EXPECT_NE(full.out.find("broken: mpr/double standard, random: "), std::string::npos) << full.out;
  const corpus::ReadResult saved = corpus::read_text(folder.read("saved.jsonl"), "saved.jsonl", true);
  EXPECT_TRUE(saved.ok());
  EXPECT_FALSE(saved.cases.empty());
}

// A case that no method supports is refused, and a refusal keeps no guarantee.
TEST(Certify, ARunThatJudgesNothingSaysWhyAndIsNoSuccess) {
  const Folder folder;
  folder.write(
      "balls.json",
      R"({"schema": "graze.case/1", "id": "test/balls", "a": {"shape": {"type": "sphere", "radius": 1}},
 "b": {"shape": {"type": "sphere", "radius": 1}, "position": [5, 0, 0], "displacement": [-4, 0, 0]}})");
  folder.write(
      "far.json",
      R"({"schema": "graze.case/1", "id": "test/far", "a": {"shape": {"type": "sphere", "radius": 1}},
 "b": {"shape": {"type": "sphere", "radius": 1}, "position": [1e200, 0, 0], "displacement": [-4, 0, 0]}})");
  folder.write("ellipsoid.json", kEllipsoid);
  const CommandRun exact = folder.graze("certify ellipsoid.json --method exact");
  expect_one_complaint(exact, {"no answer was judged", "test/ellipsoid: tier exact answers"});
  EXPECT_EQ(exact.out.find("Nothing was judged: 0 answers to 0 cases"), 0U) << exact.out;
  const CommandRun far = folder.graze("certify far.json");
  expect_one_complaint(far, {"no answer was judged", "test/far: it has a magnitude outside 1e-60 to 1e60"});
  EXPECT_EQ(far.out.find("Nothing was judged: 0 answers to 0 cases"), 0U) << far.out;
  EXPECT_EQ(far.out.find("casts of rotating bodies"), std::string::npos) << far.out;  // none was given
  // Beside one that is judged they are no answers.
  const CommandRun both = folder.graze("certify balls.json far.json --method gjk --queries 0");
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(both.out.find("Every method keeps its guarantee: 2 answers to 1 case of 1 suite"), 0U)
      << both.out;
  EXPECT_NE(both.out.find("so few answers certify little.\n"), std::string::npos) << both.out;
}

TEST(Certify, BadInputWinsAndTheOtherFilesAreStillJudged) {
  const Folder folder;
  folder.write("bad.json", "{");
  folder.write("hit.json", kHit);
  folder.write("strict.json", guarantees_with(0));
  const CommandRun run = folder.graze("certify bad.json hit.json --guarantees strict.json");
  expect_one_complaint(run, {"bad.json"});
  EXPECT_NE(run.out.find("hit.json"), std::string::npos);
  expect_one_complaint(folder.graze("certify --family nonsense"), {"nonsense"});
  expect_one_complaint(folder.graze("certify --method nonsense"), {"nonsense"});
  expect_one_complaint(folder.graze("certify hit.json --guarantees hit.json"), {"hit.json", "schema"});
  expect_one_complaint(folder.graze("certify hit.json --save no/such/folder"), {"no/such/folder"});
}

// All but the times: how long it took is said in the first line, and what a cast takes in the last column of
// the first tables.
std::string without_times(const std::string& text) {
  std::string kept;
  for (std::string line : lines_of(text.substr(text.find('\n')))) {
    while (!line.empty() && (std::isdigit(static_cast<unsigned char>(line.back())) != 0)) line.pop_back();
    while (!line.empty() && line.back() == ' ') line.pop_back();
    kept += line + '\n';
  }
  return kept;
}

TEST(Certify, TheVerdictsDoNotDependOnTheNumberOfThreads) {
  const Folder folder;
  const CommandRun one = folder.graze("certify --family grazing_edge --count 60 --full --threads 1");
  const CommandRun three = folder.graze("certify --family grazing_edge --count 60 --full --threads 3");
  EXPECT_EQ(one.exit_code, three.exit_code);
  EXPECT_NE(one.out.find("grazing"), std::string::npos);
  EXPECT_EQ(without_times(one.out), without_times(three.out));
}

// Two runs of the same cases do the same work, whatever the clock says. A planted change of it is found.
TEST(Price, ARunIsComparedWithAnotherAndAPlantedChangeIsFound) {
  const Folder folder;
  const std::string few = "price --only polytopes --only 'face gap 2' --rounds 2 --json ";
  const CommandRun first = folder.graze(few + "old.json --csv old.csv");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.out.find("One more digit costs, on polytopes"), std::string::npos) << first.out;
  EXPECT_NE(folder.read("old.csv").find("exact/double"), std::string::npos);
  // Work and errors are the same: a threshold above all noise of the clock.
  ASSERT_EQ(folder.graze(few + "new.json").exit_code, 0);
  const CommandRun same = folder.graze("compare old.json new.json --threshold 20");
  EXPECT_EQ(same.exit_code, 0) << same.out;
  std::string text = folder.read("new.json");
  const std::string before = R"("late_by":null,"proved":0,"iterations":)";
  const std::size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 14, R"("late_by":0.25)");
  folder.write("new.json", text);
  const CommandRun worse = folder.graze("compare old.json new.json --threshold 20");
  EXPECT_EQ(worse.exit_code, 1) << worse.out;
  EXPECT_NE(worse.out.find("greatest lateness 0.0e+00 -> 2.5e-01 of scale"), std::string::npos) << worse.out;
}

TEST(Price, WhatWasMeasuredBeforeAStopIsGoneOnWith) {
  const Folder folder;
  ASSERT_EQ(folder.graze("price --only 'face gap 2' --rounds 1 --json p.json").exit_code, 0);
  const std::string before = folder.read("p.json");
  const std::size_t from = before.find(R"("time":{)");
  const std::string first_time = before.substr(from, before.find('}', from) - from);
  ASSERT_EQ(folder.graze("price --only 'face gap' --rounds 1 --json p.json --continue").exit_code, 0);
  const std::string after = folder.read("p.json");
  EXPECT_NE(after.find(first_time), std::string::npos) << "measured again";
  EXPECT_NE(after.find("face gap 12"), std::string::npos);
  const CommandRun other = folder.graze("price --only 'face gap' --seed 2 --json p.json --continue");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("p.json: is of a quick run with seed 1"), std::string::npos) << other.err;
}

TEST(Generate, RepeatsItselfAndRefusesWhatTheFamilyHasNot) {
  const Folder folder;
  const CommandRun once = folder.graze("generate grazing_vertex --hardness 12 --count 4 --seed 9");
  ASSERT_EQ(once.exit_code, 0);
  const corpus::ReadResult read = corpus::read_text(once.out, "generated", true);
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read.cases.size(), 4U);
  for (const corpus::Case& problem : read.cases) EXPECT_EQ(problem.hardness, 12);
  EXPECT_EQ(once.out, folder.graze("generate grazing_vertex --hardness 12 --count 4 --seed 9").out);
  expect_one_complaint(folder.graze("generate nonsense"), {"nonsense"});
  expect_one_complaint(folder.graze("generate grazing_vertex --hardness 1e9"), {"--hardness"});
}

}  // namespace
}  // namespace graze
