// The generator and the shrinking are tested too: what is drawn, that it repeats, that shrinking ends small.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <graze/detail/shapes/hull_graph.hpp>
#include <map>

#include "corpus/format/case_io.hpp"
#include "corpus/support_value.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/far.hpp"
#include "properties/generate/large_hull.hpp"
#include "properties/generate/shrink.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {
namespace {

TEST(DrawCase, ReachesEveryOutcomeShapeAndTie) {
  corpus::Random random(5);
  std::map<Outcome, int> outcomes;
  std::map<std::size_t, int> shapes;
  int touching = 0, rotated = 0, rays = 0, rounded = 0, drawn = 0;
  constexpr int kCases = 400;  // that the exact oracle decides
  for (int i = 0; i < kCases; ++drawn) {
    ASSERT_LT(drawn, 2 * kCases);
    const corpus::Case problem = draw_case(random, drawn % 100);
    ASSERT_TRUE(in_domain(problem)) << corpus::write_case(problem);
    ++shapes[problem.a.shape.index()];
    if (!is_exactly_decided(problem)) continue;
    ++i;
    const oracle::CaseTruth& truth = truth_of(problem);
    ++outcomes[truth.outcome()];
    // Contact with no depth at all: touching at the start, or a path that grazes.
    touching += truth.outcome() != Outcome::miss && truth.depth().high == 0;
    rotated += !problem.a.orientation.is_identity();
    rays += problem.t_max == kInfinity<double>;
    rounded += problem.target_distance > 0;
  }
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::initially_overlapping}) {
    EXPECT_GE(outcomes[outcome], kCases / 10) << label_of(outcome);
  }
  for (std::size_t shape = 0; shape < std::variant_size_v<Shape<double>::Kinds>; ++shape) {
    EXPECT_GE(shapes[shape], drawn / 200) << shape;
  }
  EXPECT_GE(touching, kCases / 50);
  EXPECT_GE(rotated, kCases / 20);
  EXPECT_GE(rays, kCases / 40);
  EXPECT_GE(rounded, kCases / 40);
}

TEST(DrawCase, IsAFunctionOfItsBits) {
  corpus::Random one(99), two(99);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(same_input(draw_case(one, i), draw_case(two, i)));
}

double how_far_out(const Shape<double>& shape) {
  const corpus::Bounds box = corpus::bounds(shape);
  return std::max(std::abs(box.low[0]), std::abs(box.high[0]));
}

TEST(DrawFar, RodsAreOutAtEveryPowerAndTipToTipByAUnitAtMost) {
  corpus::Random random(23);
  std::map<int, int> tens;
  int both = 0, starts = 0, idle = 0;
  constexpr int kCases = 400;
  for (int i = 0; i < kCases; ++i) {
    corpus::Case problem;
    const bool now = i % 4 == 0;
    place_far_rods(random, problem, now ? 0 : 0.5);
    ASSERT_TRUE(in_domain(problem)) << corpus::write_case(problem);
    const double out = how_far_out(problem.b.shape);
    ++tens[std::ilogb(out) / 10];
    both += how_far_out(problem.a.shape) > 100;
    idle += problem.spin_b.pivot.isZero(0);
    EXPECT_TRUE(problem.spin_b.rotation.isZero(0));
    EXPECT_FALSE(problem.spin_a.rotation.isZero(0));
    if (!now) continue;
    // On the axis x from the start, A's tip is B's within a unit of either frame, or two where both are out.
    ++starts;
    const double tip_a = problem.a.position[0] + corpus::bounds(problem.a.shape).high[0];
    const double tip_b = problem.b.position[0] + corpus::bounds(problem.b.shape).low[0];
    EXPECT_LE(std::abs(tip_b - tip_a), 0x1p-50 * (out + how_far_out(problem.a.shape)))
        << corpus::write_case(problem);
  }
  for (int ten = 1; ten < 5; ++ten) EXPECT_GE(tens[ten], kCases / 10) << ten;
  EXPECT_GE(both, kCases / 5);
  EXPECT_GE(idle, kCases / 4);
  EXPECT_EQ(starts, kCases / 4);
}

TEST(DrawFar, ArmsAreLongAndTurnAlikeButForAUnitOrTwo) {
  corpus::Random random(29);
  std::map<int, int> tens;
  int one_vector = 0, balls = 0;
  constexpr int kCases = 400;
  for (int i = 0; i < kCases; ++i) {
    corpus::Case problem = draw_case(random, i % 100);
    place_far_arms(random, problem);
    ASSERT_TRUE(in_domain(problem)) << corpus::write_case(problem);
    const double arm = std::max(problem.spin_a.pivot.norm(), problem.spin_b.pivot.norm());
    EXPECT_GE(arm, 0x1p7 - 16);
    EXPECT_LE(arm, 0x1p44);
    ++tens[std::ilogb(arm) / 10];
    const Vec3<double> difference = problem.spin_b.rotation - problem.spin_a.rotation;
    one_vector += difference.isZero(0);
    // Components of up to 9 have units of 2^-49. Both A's and B's rotations may differ by them.
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), 4 * 0x1p-49);
    balls += std::holds_alternative<Sphere<double>>(problem.a.shape) &&
             std::holds_alternative<Ellipsoid<double>>(problem.b.shape);
    EXPECT_EQ(problem.a.displacement, problem.b.displacement);
  }
  for (int ten = 0; ten < 5; ++ten) EXPECT_GE(tens[ten], kCases / 40) << ten;
  EXPECT_GE(one_vector, kCases / 4);
  EXPECT_LE(one_vector, kCases * 3 / 4);
  EXPECT_GE(balls, kCases / 20);
}

// True for a hull with a map of directions.
bool is_mapped(const Shape<double>& shape) {
  const auto* hull = std::get_if<Hull<double>>(&shape);
  return hull != nullptr && hull->has_adjacency() && !hull->graph().map.empty();
}

TEST(DrawLargeHull, HasAMapAndMeetsItFromEverySide) {
  corpus::Random random(31);
  const engine::Method& certified = *engine::find_method(engine::Kind::linear, "certified");
  std::map<Outcome, int> outcomes;
  int mapped = 0, both = 0, rotated = 0, far = 0, in_float = 0, rays = 0;
  constexpr int kCases = 200;
  for (int i = 0; i < kCases; ++i) {
    const corpus::Case problem = draw_large_hull(random);
    ASSERT_TRUE(in_domain(problem)) << corpus::write_case(problem);
    const bool of_a = is_mapped(problem.a.shape), of_b = is_mapped(problem.b.shape);
    mapped += of_a || of_b;
    both += of_a && of_b;
    rays += std::holds_alternative<Point<double>>(problem.a.shape) ||
            std::holds_alternative<Point<double>>(problem.b.shape);
    const Body<double>& large = of_a ? problem.a : problem.b;
    rotated += !large.orientation.is_identity();
    if (const auto* hull = std::get_if<Hull<double>>(&large.shape)) {
      far += hull->center().cwiseAbs().maxCoeff() > 4;
      const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
      in_float += std::all_of(hull->vertices().begin(), hull->vertices().end(), [&](const Vec3<double>& v) {
        return is_float(v[0]) && is_float(v[1]) && is_float(v[2]);
      });
    }
    ++outcomes[certified.ask(problem, {}).outcome];
  }
  EXPECT_GE(mapped, kCases * 3 / 4);
  EXPECT_GE(both, kCases / 50);
  EXPECT_GE(rotated, kCases / 4);
  EXPECT_GE(far, kCases / 20);
  EXPECT_GE(in_float, kCases / 4);
  EXPECT_GE(rays, kCases / 50);
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::initially_overlapping}) {
    EXPECT_GE(outcomes[outcome], kCases / 20) << label_of(outcome);
  }
}

TEST(DrawLargeHull, IsAFunctionOfItsBits) {
  corpus::Random one(99), two(99);
  for (int i = 0; i < 20; ++i)
    EXPECT_TRUE(same_input(draw_turning_large_hull(one), draw_turning_large_hull(two)));
}

// An oracle's answer for one start policy is not the answer for the other.
TEST(SameInput, TellsTheStartPoliciesApart) {
  corpus::Random random(99);
  corpus::Case reported = draw_case(random, 50), passed_over = reported;
  reported.start_policy = StartPolicy::report;
  passed_over.start_policy = StartPolicy::pass_over;
  EXPECT_FALSE(same_input(reported, passed_over));
}

TEST(Simpler, EveryChainEndsAndEveryStepIsValid) {
  corpus::Random random(7);
  for (int i = 0; i < 20; ++i) {
    const corpus::Case problem = draw_case(random, 100);
    // Everything fails: the descent ends at two points at the origin, at rest.
    const corpus::Case least = minimised(problem, [](const corpus::Case& c) { return in_domain(c); });
    EXPECT_TRUE(std::holds_alternative<Point<double>>(least.a.shape));
    EXPECT_TRUE(std::holds_alternative<Point<double>>(least.b.shape));
    EXPECT_TRUE(least.b.position.isZero(0) && least.b.displacement.isZero(0));
    EXPECT_TRUE(least.a.orientation.is_identity());
    EXPECT_EQ(least.t_max, 1);
  }
}

TEST(Simpler, AHitShrinksToSmallIntegers) {
  corpus::Random random(11);
  int shrunk = 0;
  while (shrunk < 5) {
    const corpus::Case problem = draw_case(random, 50);
    const auto is_hit = [](const corpus::Case& c) {
      return in_domain(c) && is_exactly_decided(c) && truth_of(c).outcome() == Outcome::hit &&
             truth_of(c).depth().low > 0;
    };
    if (!is_hit(problem)) continue;
    ++shrunk;
    const corpus::Case least = minimised(problem, is_hit);
    ASSERT_TRUE(is_hit(least));
    for (const double x : scalars(least)) EXPECT_LE(std::abs(x), 8) << corpus::write_case(least);
  }
}

// The edits the laws rest on, against the exact oracle: the true answer is what the edit promises.
TEST(CaseEdit, TrueAnswersAreRelatedAsTheLawsSay) {
  corpus::Random random(3);
  int rays = 0, splits = 0, moves = 0, scales = 0;
  const auto next = [&](int size) {
    corpus::Case drawn = draw_case(random, size);
    while (!is_exactly_decided(drawn)) drawn = draw_case(random, size);
    return drawn;
  };
  for (int i = 0; i < 200; ++i) {
    const corpus::Case problem = next(i % 60);
    const std::string shown = corpus::write_case(problem);
    const oracle::LinearTruth truth(problem);
    const auto same = [&](const corpus::Case& other) {
      const oracle::LinearTruth its(other);
      return its.outcome() == truth.outcome() && its.toi_lower() == truth.toi_lower() &&
             its.toi_upper() == truth.toi_upper();
    };
    EXPECT_TRUE(same(swapped(problem))) << shown;
    // A superset may have a ball where others have no ball. Then it is not a case of the exact oracle.
    if (const corpus::Case larger = grown(problem, hash_of(problem)); is_exactly_decided(larger)) {
      EXPECT_LE(oracle::LinearTruth(larger).toi_lower(), truth.toi_lower()) << shown;
    }
    if (const auto other = scaled(problem, 9)) {
      EXPECT_TRUE(same(*other)) << shown;
      ++scales;
    }
    if (const auto other = translated(problem, hash_of(problem))) {
      EXPECT_TRUE(same(*other)) << shown;
      ++moves;
    }
    if (const auto other = ray_against_cso(problem)) {
      EXPECT_TRUE(same(*other)) << shown;
      ++rays;
    }
    if (const auto parts = split(problem, hash_of(problem))) {
      const oracle::LinearTruth before(parts->before), after(parts->after);
      const bool contact = truth.outcome() != Outcome::miss;
      EXPECT_EQ(contact, before.outcome() != Outcome::miss || after.outcome() != Outcome::miss) << shown;
      ++splits;
    }
  }
  EXPECT_GE(scales, 100);
  EXPECT_GE(moves, 100);
  EXPECT_GE(rays, 10);
  EXPECT_GE(splits, 40);
}

TEST(CaseEdit, ExactMeansExact) {
  EXPECT_EQ(exact_sum(1, 0x1p-52), 1 + 0x1p-52);
  EXPECT_FALSE(exact_sum(1, 0x1p-54));
  EXPECT_FALSE(exact_sum(1e308, 1e308));
  EXPECT_EQ(exact_product(3, 0.5), 1.5);
  EXPECT_FALSE(exact_product(0.1, 0.1));
  EXPECT_FALSE(exact_product(1e-200, 1e-200));
  EXPECT_EQ(exact_product(0, 0.1), 0);
}

}  // namespace
}  // namespace graze::law
