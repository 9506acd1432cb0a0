// The tester is tested: a false law is planted, and whoever sees it break gets a small case as a file that
// reads back, its picture, and what to do with both.
#include "tests/properties/laws/law_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "certify/law_finding.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "tests/properties/generate/drawn_run.hpp"

namespace graze::law {
namespace {

namespace fs = std::filesystem;

const bool kGiven = takes_given_parameters("seed=20261122");

// A folder for findings, removed at the end.
class Findings {
 public:
  Findings() : path_(fs::temp_directory_path() / ("graze-findings-" + std::to_string(::getpid()))) {
    setenv("GRAZE_FINDINGS_DIR", path_.c_str(), 1);
  }
  ~Findings() {
    unsetenv("GRAZE_FINDINGS_DIR");
    fs::remove_all(path_);
  }
  Findings(const Findings&) = delete;
  Findings& operator=(const Findings&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Broken where mpr in double sees a hit of what `breaks`.
template <class Breaks>
Law planted(const std::string& name, Breaks breaks) {
  return {.name = name,
          .sentence = "No cast ever hits.",
          .needs = Needs::metamorphic,
          .check =
              [breaks](const corpus::Case& problem, const Method& method) {
                if (method.full_name() != "mpr/double") return not_applicable("another method");
                if (!is_linear_question(problem)) return not_applicable("no linear cast");
                const engine::Answer answer = method.ask(problem, {});
                if (answer.outcome == Outcome::hit && breaks(problem)) return broken("it hits");
                return holds({label_of(answer.outcome)});
              },
          .kind = Kind::linear};
}

bool is_hull(const Shape<double>& shape) {
  const auto* hull = std::get_if<Hull<double>>(&shape);
  return hull != nullptr && hull->size() >= 2;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expect_small(const corpus::Case& problem, double most = 4) {
  for (const double x : scalars(problem)) {
    if (x == kInfinity<double>) continue;  // the horizon of a ray
    EXPECT_EQ(x, std::nearbyint(x)) << corpus::write_case(problem);
    EXPECT_LE(std::abs(x), most) << corpus::write_case(problem);
  }
}

TEST(LawRun, AFalseLawEndsAsASmallCaseWithAPictureAndWhatToDo) {
  const Findings findings;
  const Law law = planted("hulls_are_never_hit", [](const corpus::Case& c) { return is_hull(c.a.shape); });
  LawRun run(law, "drawn");
  corpus::Random random(4);
  for (int i = 0; run.holds_for(draw_case(random, 100)); ++i) ASSERT_LT(i, 2000);
  run.minimise();
  const std::string report = run.report("graze generate some --seed 7");

  const corpus::Case& least = run.failing();
  ASSERT_TRUE(is_hull(least.a.shape)) << report;
  EXPECT_LE(std::get<Hull<double>>(least.a.shape).size(), 2U) << report;
  EXPECT_TRUE(std::holds_alternative<Point<double>>(least.b.shape)) << report;
  expect_small(least);

  // Two files, of one name.
  std::vector<fs::path> files(fs::directory_iterator(findings.path()), {});
  ASSERT_EQ(files.size(), 2U);
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files[0].extension(), ".jsonl");
  EXPECT_EQ(files[1].extension(), ".svg");
  EXPECT_EQ(files[0].stem(), files[1].stem());
  EXPECT_TRUE(files[0].filename().string().starts_with("hulls_are_never_hit-"));
  for (const std::string& part :
       {std::string("law hulls_are_never_hit is broken: No cast ever hits."), std::string("mpr/double"),
        std::string("it hits"), std::string("graze generate some --seed 7"),
        "graze cast " + files[0].string() + "\n", files[1].string(),
        "graze corpus add " + files[0].string() + " --known\n"}) {
    EXPECT_NE(report.find(part), std::string::npos) << part << "\nis not in\n" << report;
  }

  // The file is the case, and breaks the law again.
  const corpus::ReadResult read = corpus::read_file(files[0]);
  ASSERT_TRUE(read.ok()) << read.errors.front().text();
  ASSERT_EQ(read.cases.size(), 1U);
  EXPECT_TRUE(same_input(read.cases[0], least));
  EXPECT_EQ(law.check(read.cases[0], *engine::find_method(Kind::linear, "mpr/double")).holding,
            Holding::broken);
  EXPECT_EQ(read.cases[0].id, "law/" + files[0].stem().string());
  EXPECT_NE(read.cases[0].comment.find("hulls_are_never_hit"), std::string::npos);
  EXPECT_NE(text_of(files[1]).find("<title>" + read.cases[0].id + "</title>"), std::string::npos);
}

TEST(LawRun, MadeSmallFromAnywhereItHasFewVerticesAndSmallIntegers) {
  const Law law = planted("hulls_are_never_hit", [](const corpus::Case& c) { return is_hull(c.b.shape); });
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    LawRun run(law, "drawn");
    corpus::Random random(seed);
    for (int i = 0; run.holds_for(draw_case(random, 100)); ++i) ASSERT_LT(i, 2000);
    run.minimise();
    EXPECT_LE(std::get<Hull<double>>(run.failing().b.shape).size(), 2U);
    expect_small(run.failing(), 16);
  }
}

TEST(LawRun, RapidcheckEndsSmallAndSaysItsSeed) {
  const Findings findings;
  LawRun run(planted("nothing_is_hit", [](const corpus::Case&) { return true; }), "drawn");
  const std::string report = fault_of_drawn(run, cases(), 500);
  EXPECT_NE(report.find("seed     RC_PARAMS=\"" + std::string(std::getenv("RC_PARAMS")) + "\""),
            std::string::npos)
      << report;
  EXPECT_NE(report.find(findings.path().string()), std::string::npos) << report;
  for (const Body<double>* body : {&run.failing().a, &run.failing().b}) {
    EXPECT_TRUE(std::holds_alternative<Point<double>>(body->shape)) << report;
  }
  expect_small(run.failing());
}

TEST(LawRun, ALawThatHoldsLeavesNoFile) {
  const Findings findings;
  LawRun run(planted("holds", [](const corpus::Case&) { return false; }), "drawn");
  EXPECT_EQ(fault_of_drawn(run, cases(), 50), "");
  EXPECT_FALSE(fs::exists(findings.path()));
  EXPECT_GT(run.tally().applied(), 40U);
}

TEST(LawFinding, SaysInOneLineWhereItCannotWrite) {
  const Findings findings;
  std::ofstream(findings.path()) << "in the way";
  try {
    (void)save_finding({}, findings.path());
    FAIL() << "wrote into a file";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(findings.path().string()), std::string::npos);
  }
}

}  // namespace
}  // namespace graze::law
