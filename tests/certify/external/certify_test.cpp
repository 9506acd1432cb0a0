// graze certify --engine on the bad engine: the report has every fault under its name, with its case saved.
// The run continues to its end and leaves no process behind.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "balls.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/case_json.hpp"
#include "processes.hpp"
#include "tests/tools/commands/run_command.hpp"

namespace graze::test {
namespace {

constexpr int kHits = 4, kMisses = 4, kStarts = 2;
constexpr std::size_t kCases = kHits + kMisses + kStarts;

std::string cases() {
  std::string lines;
  const auto add = [&](corpus::Case problem, const std::string& id) {
    problem.id = id;
    problem.family = "balls";
    lines += corpus::write_case(problem) + "\n";
  };
  for (int i = 0; i < kHits; ++i) add(balls(-5 - i), "hit/" + std::to_string(i));
  for (int i = 0; i < kMisses; ++i) add(balls(-0.5 - 0.25 * i), "miss/" + std::to_string(i));
  for (int i = 0; i < kStarts; ++i) {
    corpus::Case start = balls(-1);
    start.b.position = {1.5 - 0.5 * i, 0, 0};  // touching, and overlapping
    add(start, "start/" + std::to_string(i));
  }
  return lines;
}

struct FaultKind {
  const char* name;
  const char* fault;    // of law::kFaultKinds
  const char* failure;  // of a fault "failed"
};
std::ostream& operator<<(std::ostream& out, const FaultKind& fault) { return out << fault.name; }

class Certify : public testing::TestWithParam<FaultKind> {};

TEST_P(Certify, NamesTheSin) {
  const FaultKind& fault = GetParam();
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const CommandRun run =
      // Memory takes its time to fill on a busy machine, and is to end before the time does.
      folder.graze(std::string("certify --queries 0 --threads 2 --time-limit ") +
                   (std::string_view(fault.name) == "leaks" ? "30" : "0.5") +
                   std::string(" --memory-limit "
                               "256 --json out.json --save bad.jsonl --junit out.xml "
                               "--engine \"" BAD_ENGINE " ") +
                   fault.name + " 2\" balls.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  EXPECT_EQ(bad_engines(), 0U);
  const auto report = nlohmann::json::parse(folder.read("out.json"), nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << run.err;
  const auto& total = report.at("methods").at(0).at("total");
  EXPECT_EQ(total.at("cases"), kCases);
  ASSERT_TRUE(total.at("faults").contains(fault.fault)) << report.dump(1);
  const std::size_t count = total.at("faults").at(fault.fault).at("count");
  EXPECT_GT(count, 0U);
  if (*fault.failure != '\0') {
    EXPECT_EQ(total.at("failures").at(fault.failure), count) << report.dump(1);
  }
  // The cases are saved, and can be read again.
  const corpus::ReadResult saved = corpus::read_file(folder.path() / "bad.jsonl");
  EXPECT_TRUE(saved.ok());
  EXPECT_GE(saved.cases.size(), count);
  EXPECT_LE(saved.cases.size(), kCases);
  const std::string first = total.at("faults").at(fault.fault).at("first");
  EXPECT_TRUE(std::any_of(saved.cases.begin(), saved.cases.end(), [&](const corpus::Case& problem) {
    return problem.id == first;
  })) << first;
  // For a build server, too.
  const std::string xml = folder.read("out.xml");
  EXPECT_NE(xml.find("<failure"), std::string::npos) << xml;
  EXPECT_NE(xml.find(first), std::string::npos) << xml;
}

INSTANTIATE_TEST_SUITE_P(
    Sins, Certify,
    testing::Values(
        FaultKind{"segfault", "failed", "crashed"}, FaultKind{"hang", "failed", "hung"},
        FaultKind{"nan_token", "failed", "no number"}, FaultKind{"before_0", "failed", "out of range"},
        FaultKind{"leaks", "failed", "out of memory"}, FaultKind{"wrong_id", "failed", "another's answer"},
        FaultKind{"garbage", "failed", "garbage"}, FaultKind{"half_a_line", "failed", "half a line"},
        FaultKind{"closes_output", "failed", "silent"}, FaultKind{"late", "late", ""},
        FaultKind{"early", "early", ""}, FaultKind{"flips_normals", "contact off", ""},
        FaultKind{"shrinks_start_normals", "failed", "out of range"},
        FaultKind{"flips_start_normals", "contact off", ""},
        FaultKind{"loses_start_witnesses", "contact off", ""},
        FaultKind{"beyond_its_margin", "contact off", ""}, FaultKind{"misses_hits", "wrong", ""},
        FaultKind{"claims_hits", "wrong", ""}),
    [](const testing::TestParamInfo<FaultKind>& fault) { return std::string(fault.param.name); });

TEST(Certify, AcquitsAGoodEngine) {
  for (const std::string good : {"none", "has_margin"}) {
    const Folder folder;
    folder.write("balls.jsonl", cases());
    const CommandRun run =
        folder.graze("certify --queries 0 --junit out.xml --save bad.jsonl --engine \"" BAD_ENGINE " " +
                     good + "\" balls.jsonl");
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    EXPECT_EQ(folder.read("bad.jsonl"), "");
    EXPECT_EQ(folder.read("out.xml").find("<failure"), std::string::npos);
  }
}

TEST(Certify, MakesOfAFindingASmallCaseOfSolids) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const CommandRun run = folder.graze("certify --queries 0 --findings found --engine \"" BAD_ENGINE
                                      " misses_all_hits\" balls.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  const corpus::ReadResult found = corpus::read_directory(folder.path() / "found");
  ASSERT_EQ(found.cases.size(), 1U) << run.out;
  for (const auto* body : {&found.cases[0].a, &found.cases[0].b}) {
    const auto* ball = std::get_if<Sphere<double>>(&body->shape);
    ASSERT_NE(ball, nullptr);
    EXPECT_GT(ball->radius, 0);
  }
}

TEST(Certify, CountsApartWhatLiesBeyondDocumentedLimits) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const std::string command =
      "certify --queries 0 --json out.json --junit out.xml --save bad.jsonl --engine \"" BAD_ENGINE
      " documents_misses\" balls.jsonl";
  EXPECT_EQ(folder.graze(command).exit_code, 2);  // no answer of it was judged
  auto method = nlohmann::json::parse(folder.read("out.json")).at("methods").at(0);
  EXPECT_TRUE(method.at("beyond_limits").is_null());
  EXPECT_EQ(method.at("total").at("not_asked"), kCases);
  const CommandRun run = folder.graze(command + " --beyond-limits");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("Beyond the documented limits of the engines"), std::string::npos) << run.out;
  method = nlohmann::json::parse(folder.read("out.json")).at("methods").at(0);
  EXPECT_EQ(method.at("total").at("cases"), 0);
  EXPECT_TRUE(method.at("total").at("faults").empty());
  EXPECT_EQ(method.at("beyond_limits").at("cases"), kCases);
  EXPECT_EQ(method.at("beyond_limits").at("faults").at("wrong").at("count"), kHits);
  EXPECT_EQ(folder.read("out.xml").find("<failure"), std::string::npos);
  EXPECT_EQ(corpus::read_file(folder.path() / "bad.jsonl").cases.size(), std::size_t{kHits});
}

// A hit is at a time above 0, and two starts give one line.
TEST(Certify, TakesAHitAtTime0ForWrong) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const CommandRun run = folder.graze("certify --queries 0 --json out.json --engine \"" BAD_ENGINE
                                      " hits_all_starts\" balls.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  const auto report = nlohmann::json::parse(folder.read("out.json"));
  EXPECT_EQ(report.at("methods").at(0).at("total").at("faults").at("wrong").at("count"), kStarts);
  const std::size_t table = run.out.find("needed by"),
                    line = run.out.find("\nwrong: 2 answers of 1 method in 1 family;");
  ASSERT_NE(line, std::string::npos) << run.out;
  EXPECT_LT(table, line);
  EXPECT_EQ(run.out.find("broken: "), std::string::npos);
  const CommandRun full =
      folder.graze("certify --queries 0 --full --engine \"" BAD_ENGINE " hits_all_starts\" balls.jsonl");
  EXPECT_NE(full.out.find("broken: bad/double"), std::string::npos) << full.out;
}

TEST(Certify, CountsWhatIsDeclined) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const std::string words =
      "certify --queries 0 --threads 1 --json out.json --engine \"" BAD_ENGINE " declines_half\" balls.jsonl";
  const CommandRun run = folder.graze(words);
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  const std::string said = "bad/double declines 5 of 10 questions (50 %)";
  EXPECT_NE(run.out.substr(0, run.out.find('\n')).find(said), std::string::npos) << run.out;
  const auto total = nlohmann::json::parse(folder.read("out.json")).at("methods").at(0).at("total");
  EXPECT_EQ(total.at("declined"), 5);
  EXPECT_EQ(total.at("not_asked"), 0);
  const CommandRun allowed = folder.graze(words + " --allow-declined");
  EXPECT_EQ(allowed.exit_code, 0) << allowed.out << allowed.err;
  EXPECT_NE(allowed.out.find(said), std::string::npos) << allowed.out;
}

TEST(Certify, SaysThatAProcessWasLeftBehind) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const CommandRun run =
      folder.graze("certify --queries 0 --threads 1 --engine \"" BAD_ENGINE " forks_twice\" balls.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  EXPECT_NE(run.out.find("outlived it, left behind"), std::string::npos) << run.out;
  EXPECT_EQ(bad_engines(), 0U);
}

TEST(Certify, JudgesASharedLibraryInAProcessOfItsOwn) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  EXPECT_EQ(folder.graze("certify --queries 0 --engine " BALL_LIBRARY " balls.jsonl").exit_code, 0);
  corpus::Case fall = balls(-20);
  fall.id = "fall";
  fall.b.shape = Sphere<double>{13};
  fall.b.position = {40, 0, 0};
  folder.write("fall.jsonl", corpus::write_case(fall) + "\n");
  const CommandRun run =
      folder.graze("certify --queries 0 --json out.json --engine " BALL_LIBRARY " balls.jsonl fall.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  const auto report = nlohmann::json::parse(folder.read("out.json"), nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << run.err;
  const auto& total = report.at("methods").at(0).at("total");
  EXPECT_EQ(total.at("failures").at("crashed"), 1) << report.dump(1);
  EXPECT_EQ(total.at("cases"), kCases + 1);
  EXPECT_EQ(folder.graze("host nowhere.so").exit_code, 2);
}

// A run beside ours that asks it nothing would be green without it.
TEST(Certify, RefusesToJudgeAnEngineByNothing) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  corpus::Case box = balls(-5);
  box.id = "box";
  box.b.shape = Box<double>{{1, 1, 1}};
  folder.write("box.jsonl", corpus::write_case(box) + "\n");
  const std::string words = "certify --queries 0 --method gjk --engine \"" BAD_ENGINE " none\" ";
  EXPECT_EQ(folder.graze(words + "balls.jsonl").exit_code, 0);
  const CommandRun run = folder.graze(words + "box.jsonl");
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_NE(run.err.find("bad: no answer of it was judged: of 1 case it takes none"), std::string::npos)
      << run.err;
}

TEST(Certify, SaysWhyNoCaseOfAFamilyIsAsked) {
  const Folder folder;
  const CommandRun run =
      folder.graze("certify --queries 0 --count 8 --family lattice --engine \"" BAD_ENGINE " none\"");
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_NE(run.err.find(
                "lattice: none of its cases is asked; the first, lattice/h0/s1: bad/double: its shape hull"),
            std::string::npos)
      << run.err;
}

TEST(Certify, SaysHowFewOfAFamilyAreAsked) {
  const Folder folder;
  const CommandRun run =
      folder.graze("certify --queries 0 --count 20 --family random --engine \"" BAD_ENGINE " none\"");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.err.find("random: 1 of 20 cases is one that an engine takes; the first other is random/h"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.out.find("so few answers certify little.\n"), std::string::npos) << run.out;
}

TEST(Certify, RefusesAnEngineThatCannotBeAsked) {
  const Folder folder;
  folder.write("balls.jsonl", cases());
  const CommandRun run = folder.graze("certify --engine \"" BAD_ENGINE " declares_nonsense\" balls.jsonl");
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_NE(run.err.find("scalar"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace graze::test
