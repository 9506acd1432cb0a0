// Error against time: what has no time has no error of one, in the rows, the table and the data of the plot.
#include "certify/tolerance_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "report/statistics.hpp"

namespace graze::tool {
namespace {

using corpus::Case;

// A point falls onto a box of half extents 1, a depth of 2^-20 within its edge.
constexpr double kDepth = 1.0 / (1 << 20);
Case grazing_point() {
  Case problem;
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b.shape = Point<double>{};
  problem.b.position = {1 - kDepth, 0, 3};
  problem.b.displacement = {0, 0, -4};
  return problem;
}

// Says that it misses while the tolerance exceeds the depth, does not converge below 1e-13, and is right
// between.
engine::Answer answer_within(const Case&, const engine::Ask& ask) {
  if (ask.tolerance > 1e-6) {
    return {.outcome = Outcome::miss, .toi_lower = kInfinity<double>, .toi_upper = kInfinity<double>};
  }
  if (ask.tolerance < 1e-13) {
    return {.outcome = Outcome::not_converged, .toi_lower = 0.25, .toi_upper = kInfinity<double>};
  }
  return {.outcome = Outcome::hit, .toi_lower = 0.5, .toi_upper = 0.5};
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(ToleranceStudy, an_excused_miss_has_no_time_and_no_infinite_error) {
  const engine::Method method{.name = "made_up",
                              .scalar = "double",
                              .tier = "standard",
                              .unit_roundoff = kUnitRoundoff<double>,
                              .ask = answer_within,
                              .seen = [](const Case& problem) { return problem; },
                              .time_ns = [](const Case&, const engine::Ask&, int) { return 100.0; }};
  const std::vector<Case> hits = {grazing_point()};
  const std::vector<ToleranceRow> rows = study_tolerances({&method}, hits, 1);
  ASSERT_EQ(rows.size(), studied_tolerances().size());
  const double scale = std::sqrt(12.0);
  for (const ToleranceRow& row : rows) {
    SCOPED_TRACE(row.tolerance);
    EXPECT_FALSE(std::isinf(worst(row.lower)));
    EXPECT_FALSE(std::isinf(worst(row.upper)));
    EXPECT_FALSE(std::isinf(worst(row.width)));
    const bool misses = row.tolerance > 1e-6;
    EXPECT_EQ(row.missed, misses ? 1U : 0U);
    EXPECT_EQ(std::isnan(row.lower[0]), misses);
    if (misses) {
      EXPECT_NEAR(row.denied[0], kDepth / scale, 1e-3 * kDepth);
    }
  }
  EXPECT_EQ(rows.back().not_converged, 1U);
  EXPECT_FALSE(std::isnan(rows.back().lower[0]));
  EXPECT_TRUE(std::isnan(rows.back().upper[0]));

  EXPECT_EQ(tolerance_table(rows).find("inf"), std::string::npos) << tolerance_table(rows);
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "graze_tolerance_study";
  (void)draw_tolerances(rows, folder.string());
  const std::string data = text_of(folder / "error_against_time.dat");
  EXPECT_NE(data.find("0.01 100 nan nan 1 "), std::string::npos) << data;
  EXPECT_EQ(data.find("inf"), std::string::npos) << data;
  // What is absent is not drawn, and is not drawn as an error of 0 either.
  EXPECT_NE(text_of(folder / "error_against_time.gp").find("x != x ? NaN"), std::string::npos);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace graze::tool
