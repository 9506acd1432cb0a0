// Curves of error against hardness: made-up methods, whose errors are known, are measured and held to a row.
#include "certify/stability.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/stability_report.hpp"
#include "tests/shared/rotating_cases.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using corpus::Family;

// A point falls by 4 onto a box of half extents 1, from 2 above it: contact at t = 1/2. The scale is the
// box's diagonal.
const double kScale = std::sqrt(12.0);
constexpr double kSpeed = 4;

Case falling_point() {
  Case problem;
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b.shape = Point<double>{};
  problem.b.position = {0, 0, 3};
  problem.b.displacement = {0, 0, -kSpeed};
  return problem;
}

void set_bodies(Case& problem, const Case& bodies) {
  problem.a = bodies.a;
  problem.b = bodies.b;
  problem.spin_a = bodies.spin_a;
  problem.spin_b = bodies.spin_b;
}

constexpr double kLevels[] = {20, 30, 40};

void fill_hit(corpus::Draw&, double, Case& problem) { set_bodies(problem, falling_point()); }
// Passes the box at a distance of 2^-hardness.
void fill_near_miss(corpus::Draw&, double hardness, Case& problem) {
  set_bodies(problem, falling_point());
  problem.b.position.x() = 1 + std::ldexp(1.0, -static_cast<int>(hardness));
}
// Meets it as deep.
void fill_near_hit(corpus::Draw&, double hardness, Case& problem) {
  set_bodies(problem, falling_point());
  problem.b.position.x() = 1 - std::ldexp(1.0, -static_cast<int>(hardness));
}
void fill_ball(corpus::Draw&, double, Case& problem) {
  set_bodies(problem, falling_point());
  problem.b.shape = Sphere<double>{0.5};
}
void fill_bar(corpus::Draw&, double, Case& problem) { set_bodies(problem, test::turning_bar()); }

constexpr Family kHits{"hits", "", "nothing", kLevels, fill_hit};
constexpr Family kNearMisses{"near_misses", "", "-log2 of the clearance", kLevels, fill_near_miss};
constexpr Family kNearHits{"near_hits", "", "-log2 of the depth", kLevels, fill_near_hit};
constexpr Family kBalls{"balls", "", "nothing", kLevels, fill_ball};
constexpr Family kBars{"bars", "", "nothing", kLevels, fill_bar, true};

// Late by 2^-hardness in time.
double delay(const Case& problem) { return std::ldexp(1.0, -static_cast<int>(*problem.hardness)); }

engine::Answer late_answer(const Case& problem, const engine::Ask&) {
  const double t = 0.5 + delay(problem);
  return {.outcome = Outcome::hit, .toi_lower = t, .toi_upper = t};
}
engine::Answer hit_answer(const Case&, const engine::Ask&) {
  return {.outcome = Outcome::hit, .toi_lower = 0.5, .toi_upper = 0.5};
}
engine::Answer miss_answer(const Case&, const engine::Ask&) {
  return {.outcome = Outcome::miss, .toi_lower = kInfinity<double>, .toi_upper = kInfinity<double>};
}
engine::Answer stalled_answer(const Case&, const engine::Ask&) {
  return {.outcome = Outcome::not_converged, .toi_lower = 0, .toi_upper = kInfinity<double>};
}

Case as_given(const Case& problem) { return problem; }

engine::Method method_of(engine::Answer (*cast)(const Case&, const engine::Ask&)) {
  return {.name = "made_up",
          .scalar = "double",
          .tier = "standard",
          .unit_roundoff = kUnitRoundoff<double>,
          .ask = cast,
          .seen = as_given,
          .time_ns = nullptr};
}

constexpr std::size_t kCount = 3;

FamilyStability measured(const Family& family, const engine::Method& method, double kappa,
                         double stall_cap = 0) {
  const engine::Guarantee row{.method = method.name,
                              .scalar = method.scalar,
                              .tier = method.tier,
                              .kappa_polytope = kappa,
                              .kappa_rounded = kappa,
                              .stall_cap = stall_cap,
                              .mechanism = "a test"};
  engine::Method held = method;
  held.guarantee = &row;
  return measure_family(family, {.methods = {&held}, .count = kCount});
}

Curve only_curve(const FamilyStability& family) {
  EXPECT_EQ(family.curves.size(), 1U);
  return family.curves.at(0);
}

TEST(Stability, ALateTimeIsMeasuredLevelByLevel) {
  const engine::Method method = method_of(late_answer);
  const Curve curve = only_curve(measured(kHits, method, 1024));
  ASSERT_EQ(curve.levels.size(), std::size(kLevels));
  for (const LevelErrors& level : curve.levels) {
    const double error = std::ldexp(kSpeed, -static_cast<int>(level.hardness)) / kScale;
    ASSERT_EQ(level.backward.size(), kCount);
    ASSERT_EQ(level.forward.size(), kCount);
    for (const double e : level.backward) EXPECT_NEAR(e, error, 1e-9 * error);
    for (const double e : level.forward) EXPECT_NEAR(e, error, 1e-9 * error);
    // 1,024 u of scale are 2^-43: each of the three is more than that late.
    EXPECT_EQ(level.late, kCount);
    EXPECT_EQ(level.faulty, kCount);
    EXPECT_EQ(level.wrong, 0U);
  }
  EXPECT_EQ(curve.hardest()->hardness, kLevels[0]);
  EXPECT_FALSE(curve.holds());
  EXPECT_TRUE(curve.first_fault.starts_with("hits/h20/s1: the time 0.5")) << curve.first_fault;
  ASSERT_EQ(breaches({curve}).size(), 1U);
  EXPECT_NE(breaches({curve})[0].find("9 of 9 beyond the guarantee"), std::string::npos)
      << breaches({curve})[0];
}

TEST(Stability, ARowThatGrantsTheErrorHolds) {
  const engine::Method method = method_of(late_answer);
  const double kappa = 1.01 * std::ldexp(kSpeed, -20) / kScale / kUnitRoundoff<double>;
  const Curve curve = only_curve(measured(kHits, method, kappa));
  EXPECT_TRUE(curve.holds()) << curve.first_fault;
  EXPECT_TRUE(breaches({curve}).empty());
  EXPECT_FALSE(only_curve(measured(kHits, method, 0.98 * kappa)).holds());
}

TEST(Stability, AWrongVerdictCountsByWhatItDenies) {
  const engine::Method hits = method_of(hit_answer), misses = method_of(miss_answer);
  for (const auto& [family, method] : {std::pair{&kNearMisses, &hits}, std::pair{&kNearHits, &misses}}) {
    // Between the second level and the third.
    const double kappa = std::ldexp(1.0, -35) / kScale / kUnitRoundoff<double>;
    const Curve curve = only_curve(measured(*family, *method, kappa));
    for (const LevelErrors& level : curve.levels) {
      const double denied = std::ldexp(1.0, -static_cast<int>(level.hardness)) / kScale;
      EXPECT_EQ(level.wrong, kCount);
      EXPECT_NEAR(level.denied, denied, 1e-6 * denied);
      ASSERT_EQ(level.backward.size(), kCount);
      EXPECT_NEAR(level.backward[0], denied, 1e-6 * denied);
      EXPECT_TRUE(level.forward.empty());
      EXPECT_EQ(level.faulty, level.hardness < 35 ? kCount : 0U) << level.hardness;
    }
    EXPECT_FALSE(curve.holds());
    EXPECT_NE(break_table({curve}).find(fmt::format("{}", kLevels[0])), std::string::npos);
  }
}

TEST(Stability, AStallHasNoErrorAndACap) {
  const engine::Method method = method_of(stalled_answer);
  const Curve curve = only_curve(measured(kHits, method, 64));
  EXPECT_EQ(curve.total().stalled, 9U);
  EXPECT_TRUE(curve.total().backward.empty());
  EXPECT_EQ(curve.hardest(), nullptr);
  EXPECT_FALSE(curve.holds());
  EXPECT_NE(breaches({curve})[0].find("9 of 9 not converged"), std::string::npos);
  EXPECT_FALSE(only_curve(measured(kHits, method, 64, 0.8)).holds());  // of nine, eight
  EXPECT_TRUE(only_curve(measured(kHits, method, 64, 0.9)).holds());
}

TEST(Stability, RoundShapesHaveACurveOfTheirOwn) {
  const engine::Method method = method_of(hit_answer);
  const Curve points = only_curve(measured(kHits, method, 64)),
              balls = only_curve(measured(kBalls, method, 64));
  EXPECT_FALSE(points.rounded);
  EXPECT_TRUE(balls.rounded);
  EXPECT_TRUE(points.holds());
  EXPECT_FALSE(balls.holds());  // the ball meets the box before t = 1/2
  std::vector<Curve> curves = {points, balls};
  curves[1].family = points.family;
  const std::vector<Curve> one = merged(curves);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].total().cases, points.total().cases + balls.total().cases);
}

TEST(Stability, TheWorstFamilyStandsFirst) {
  const engine::Method late = method_of(late_answer), hits = method_of(hit_answer);
  const Curve bad = only_curve(measured(kHits, late, 64)),
              worse = only_curve(measured(kNearMisses, hits, 64)),
              good = only_curve(measured(kHits, hits, 64));
  Curve middle = good;
  middle.family = "middle";
  middle.levels[1].backward = {1e-7};
  Curve first = bad;
  first.family = "first";
  const std::string table = stability_table({middle, worse, first});
  const std::size_t first_at = table.find("first"), worse_at = table.find("near_misses"),
                    middle_at = table.find("middle");
  EXPECT_LT(first_at, worse_at);
  EXPECT_LT(worse_at, middle_at);
  const std::string summary = summary_table({middle, worse, first});
  EXPECT_NE(summary.find("first"), std::string::npos);
  EXPECT_EQ(summary.find("middle"), std::string::npos);
}

TEST(Stability, OurMethodsHoldAndThreadsChangeNothing) {
  StabilitySettings settings{.count = 2};
  for (const engine::Method& method : engine::methods(engine::Kind::linear))
    settings.methods.push_back(&method);
  const Family* family = corpus::find_family("size_ratio");
  ASSERT_NE(family, nullptr);
  const FamilyStability one = measure_family(*family, settings);
  settings.threads = 3;
  const FamilyStability three = measure_family(*family, settings);
  EXPECT_EQ(level_table(one), level_table(three));
  EXPECT_TRUE(breaches(one.curves).empty()) << breaches(one.curves)[0];
  // Something was measured of every method.
  const std::vector<Curve> by_method = merged(one.curves);
  EXPECT_EQ(by_method.size(), settings.methods.size());
  for (const Curve& curve : by_method) EXPECT_FALSE(curve.total().backward.empty()) << curve.method;
}

// The bar's edge meets the floor at about 1.4 lengths a unit of t. Its ends move by at most pi/2 times their
// arm.
constexpr double kDelay = 1e-6;

engine::Answer late_turn(const Case& problem, const engine::Ask& ask) {
  engine::Answer answer = engine::find_method(engine::Kind::rotating, "bilateral")->ask(problem, ask);
  answer.toi_lower += kDelay;
  answer.toi_upper += kDelay;
  return answer;
}
engine::Answer missed_turn(const Case&, const engine::Ask&) {
  return {.outcome = Outcome::miss, .toi_lower = kInfinity<double>, .toi_upper = kInfinity<double>};
}

Curve measured_turn(engine::Answer (*cast)(const Case&, const engine::Ask&)) {
  engine::Method method = *engine::find_method(engine::Kind::rotating, "bilateral");
  method.ask = cast;
  return only_curve(measure_family(kBars, {.methods = {&method}, .rotating_count = 1}));
}

TEST(Stability, RotatingTimesAndVerdictsAreMeasured) {
  const Curve late = measured_turn(late_turn);
  EXPECT_TRUE(late.rotating);
  EXPECT_EQ(late.total().late, std::size(kLevels));
  for (const LevelErrors& level : late.levels) {
    ASSERT_EQ(level.backward.size(), 1U);
    EXPECT_GT(level.backward[0], 0.1 * kDelay);
    EXPECT_LT(level.backward[0], kDelay);
    ASSERT_EQ(level.forward.size(), 1U);
    EXPECT_GE(level.forward[0], level.backward[0]);
    EXPECT_LT(level.forward[0], 4 * kDelay);
  }
  EXPECT_FALSE(late.holds());
  const Curve missed = measured_turn(missed_turn);
  EXPECT_EQ(missed.total().wrong, std::size(kLevels));
  EXPECT_GT(missed.total().denied, 0.01);
  EXPECT_FALSE(missed.holds());
}

}  // namespace
}  // namespace graze::tool
