// The options and the counters of the queries beside the cast. A bad option is refused, and an exhausted
// budget gives no verdict. A bracket that stays wide is reported as such, and the counters count the work.
#include <gtest/gtest.h>

#include <graze/detail/proving/named_point.hpp>
#include <graze/detail/search/robust/sweep.hpp>
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/swept_overlap.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

const Body<double> kBox{.shape = Box<double>{{1, 1, 1}}};

TEST(QueryOptions, NoBudgetOrNoNumberIsRefused) {
  const Body<double> b{.shape = Sphere<double>{0.5}, .position = {4, 0, 0}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(distance(kBox, b, {.max_iterations = 0}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(distance(kBox, b, {.tolerance = nan}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(penetration(kBox, b, {.max_iterations = 0}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(penetration(kBox, b, {.tolerance = -1}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(penetration_along(kBox, b, V(1, 0, 0), {.max_iterations = 0}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(line(kBox, b, {.max_iterations = 0}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(line(kBox, b, {.tolerance = nan}).invalid, Invalid::bad_tolerance);
  for (const SweptMethod method : {SweptMethod::gjk, SweptMethod::mpr})
    EXPECT_EQ(swept_overlap(kBox, b, {.method = method, .max_iterations = 0}).invalid,
              Invalid::bad_tolerance);
}

// Two ellipsoids that overlap, and a direction.
struct Overlapping {
  Body<double> a, b;
  V d;
};
Overlapping draw_overlapping(Draw& draw) {
  Overlapping out;
  out.a = {.shape = Ellipsoid<double>{{1, 0.5, 0.25}}, .orientation = draw.turn<double>()};
  out.b = {.shape = Ellipsoid<double>{{0.5, 1, 0.75}},
           .position = draw.vector<double>(0.25),
           .orientation = draw.turn<double>()};
  out.d = unit(draw.vector<double>(1));
  return out;
}

// Bodies that touch by 1e-7 on the side that the direction comes from: a few portal steps do not tell.
TEST(QueryOptions, ASpentBudgetIsNoVerdictAlongADirection) {
  Draw draw{71};
  int spent = 0;
  for (int round = 0; round < 100; ++round) {
    auto [a, b, d] = draw_overlapping(draw);
    b.position -= (penetration_along(a, b, V(-d)).lower - 1e-7) * d;
    ASSERT_EQ(penetration_along(a, b, d).outcome, Outcome::initially_overlapping);
    for (const int budget : {1, 2, 3, 4, 6, 8}) {
      const auto r = penetration_along(a, b, d, {.max_iterations = budget});
      EXPECT_NE(r.outcome, Outcome::miss) << round << ' ' << budget;
      if (r.outcome == Outcome::not_converged) {
        ++spent;
        EXPECT_TRUE(r.stalled);
      }
    }
  }
  EXPECT_GT(spent, 20);
}

// The other side: the far end of the line in C lies before the origin, and a few portal steps, or a tolerance, do not tell.
TEST(QueryOptions, NeitherASpentBudgetNorAToleranceIsContactAlongADirection) {
  Draw draw{73};
  int spent = 0, wide = 0;
  for (int round = 0; round < 100; ++round) {
    auto [a, b, d] = draw_overlapping(draw);
    b.position += (penetration_along(a, b, d).upper + 1e-3) * d;
    ASSERT_EQ(penetration_along(a, b, d).outcome, Outcome::miss);
    for (const int budget : {1, 2, 3, 4, 6, 8}) {
      const auto r = penetration_along(a, b, d, {.max_iterations = budget});
      EXPECT_NE(r.outcome, Outcome::initially_overlapping) << round << ' ' << budget;
      spent += r.outcome == Outcome::not_converged;
    }
    for (const double tolerance : {0.01, 0.1, 1.0}) {
      EXPECT_EQ(penetration_along(a, b, d, {.tolerance = tolerance}).outcome, Outcome::miss) << round;
    }
    // In contact the points of a bracket left wide are points of the bodies.
    b.position -= (penetration_along(a, b, V(-d)).lower + 0.25) * d;
    for (const int budget : {1, 2, 3, 4, 6, 8}) {
      const auto r = penetration_along(a, b, d, {.max_iterations = budget});
      if (r.outcome != Outcome::initially_overlapping) continue;
      wide += r.stalled;
      EXPECT_LE(distance(a, Body<double>{.position = r.point_a}).upper, 1e-13) << round << ' ' << budget;
      EXPECT_LE(distance(b, Body<double>{.position = r.point_b}).upper, 1e-13) << round << ' ' << budget;
    }
  }
  EXPECT_GT(spent, 20);
  EXPECT_GT(wide, 20);
}

TEST(QueryOptions, ADepthSaysWhetherItsBracketIsWide) {
  Draw draw{72};
  int wide = 0;
  for (int round = 0; round < 200; ++round) {
    const Body<double> a{.shape = Ellipsoid<double>{{1, 0.5, 0.25}}, .orientation = draw.turn<double>()};
    const Body<double> b{.shape = Ellipsoid<double>{{0.5, 1, 0.75}},
                         .position = draw.vector<double>(0.3),
                         .orientation = draw.turn<double>()};
    for (const int budget : {16, 24, 256}) {
      const auto r = penetration(a, b, {.max_iterations = budget});
      if (r.outcome != Outcome::initially_overlapping) continue;
      // Scale is below 4.
      const bool narrow = r.upper - r.lower <= 1e-12;
      EXPECT_EQ(r.stalled, !narrow) << round << ' ' << budget << ' ' << r.upper - r.lower;
      wide += narrow ? 0 : 1;
    }
  }
  EXPECT_GT(wide, 50);
}

// Cores apart, radii overlapping: known to the rounding.
TEST(QueryOptions, ADepthOfRoundBodiesIsNoStall) {
  Draw draw{73};
  for (int round = 0; round < 200; ++round) {
    const Body<double> a{.shape = Capsule<double>{1, 0.5}, .orientation = draw.turn<double>()};
    const Body<double> b{.shape = rounded<double>(Box<double>{{0.5, 0.25, 0.125}}, 0.75),
                         .position = 2 * unit(draw.vector<double>(1)),
                         .orientation = draw.turn<double>()};
    const auto r = penetration(a, b);
    if (r.outcome != Outcome::initially_overlapping) continue;
    EXPECT_FALSE(r.stalled) << round;
    EXPECT_GT(r.counters.supports, 1);
  }
}

TEST(QueryOptions, ALineIsBracketedAsNarrowlyAsAsked) {
  Draw draw{74};
  int hits = 0;
  for (int round = 0; round < 300; ++round) {
    const Body<double> a{.shape = Ellipsoid<double>{{1, 0.5, 0.75}}, .orientation = draw.turn<double>()};
    const Body<double> b{.shape = Sphere<double>{0.25},
                         .position = {draw.between(-0.5, 0.5), draw.between(-0.5, 0.5), -3},
                         .displacement = {0, 0, 4}};
    const auto best = line(a, b);
    for (const double tolerance : {1e-6, 1e-4, 1e-2}) {
      const auto r = line(a, b, {.tolerance = tolerance});
      if (r.outcome != Outcome::hit) continue;
      ++hits;
      // Beyond the rounding: kappa u scale is below 1e-12.
      EXPECT_LE(4 * (r.in_lower - best.in_upper), 1e-12) << round;
      EXPECT_LE(4 * (best.out_lower - r.out_upper), 1e-12) << round;
      // The scale is the distance of the centres, below 3.2, and the speed is 4.
      EXPECT_LE(4 * (r.in_upper - r.in_lower), 3.2 * tolerance) << round;
      EXPECT_LE(4 * (r.out_upper - r.out_lower), 3.2 * tolerance) << round;
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(QueryOptions, AnOverlapCountsTheSearchItAsks) {
  const Body<double> b{.shape = Cone<double>{0.5, 1}, .position = {4, 1, 0.25}};
  const auto d = distance(kBox, b, {.request = Request::normal});
  const auto r = overlap_gjk(kBox, b);
  EXPECT_EQ(r.outcome, Outcome::miss);
  EXPECT_EQ(r.counters.supports, d.counters.supports);
  EXPECT_EQ(r.counters.gjk_iterations, d.counters.gjk_iterations);
  EXPECT_GE(d.counters.supports, d.counters.gjk_iterations);
  EXPECT_GT(d.counters.gjk_iterations, 0);
}

TEST(QueryOptions, BoundsOfThePathAskSixSupports) {
  const Body<double> b{
      .shape = Sphere<double>{0.5}, .position = {-4, 0.5, 0.25}, .displacement = {8, 1, 0.5}};
  Counters counters;
  const auto clip = detail::clip_to_bounds(detail::Cso<double>(kBox, b), 1.0, counters);
  EXPECT_FALSE(clip.missed);
  EXPECT_EQ(counters.supports, 6);
}

TEST(QueryOptions, APointOfAProofIsASupport) {
  const Body<double> b{.shape = Sphere<double>{0.5}, .position = {4, 0, 0}};
  const detail::Cso<double> cso(kBox, b);
  Counters counters;
  const auto context = detail::proof_context(kBox, b, cso, 1.0, 0.0);
  const detail::NamedPoints<double> points(context, counters);
  for (const V& n : {V(1, 2, 3), V(-1, 2, 3)}) EXPECT_TRUE(points.along(n).named);
  EXPECT_EQ(counters.supports, 2);
}

// Bodies apart by about the rounding: whoever says so shows it.
TEST(QueryOptions, AMissNearTheNoiseHasAnAxis) {
  Draw draw{75};
  int misses = 0, contacts = 0;
  for (int round = 0; round < 2000; ++round) {
    const Body<double> a{.shape = Box<double>{{1, 0.5, 0.75}}, .orientation = draw.turn<double>()};
    Body<double> b{.shape = Box<double>{{0.5, 0.25, 0.75}},
                   .position = 4 * unit(draw.vector<double>(1)),
                   .orientation = draw.turn<double>()};
    const auto d = distance(a, b);
    b.position -= d.normal * (d.lower - draw.between(-32, 32) * 0x1p-53);
    const auto r = overlap_mpr(a, b);
    if (r.outcome == Outcome::initially_overlapping) ++contacts;
    if (r.outcome != Outcome::miss) continue;
    ++misses;
    EXPECT_NEAR(r.normal.norm(), 1, 1e-15) << round;
  }
  EXPECT_GT(misses, 100);
  EXPECT_GT(contacts, 100);
}

// A point of a proof that is off by the target distance is within it, however it rounds.
TEST(QueryOptions, APointOfATargetDistanceIsWithinIt) {
  Draw draw{76};
  const Body<double> b{.shape = Box<double>{{1, 1, 1}}, .position = {4, 0, 0}};
  const double m = 0.3;
  const detail::Cso<double> cso(kBox, b, m);
  Counters counters;
  const auto context = detail::proof_context(kBox, b, cso, 1.0, m);
  const detail::NamedPoints<double> points(context, counters);
  for (int round = 0; round < 1000; ++round) {
    const V target = points.along(draw.vector<double>(1)).target;
    long double square = 0;
    for (int i = 0; i < 3; ++i) square += static_cast<long double>(target[i]) * target[i];
    EXPECT_LE(square, static_cast<long double>(m) * m) << round;
    EXPECT_GE(target.norm(), m * (1 - 1e-14)) << round;
  }
}

TEST(QueryOptions, AShapeIsAPointUntilItIsGivenAnExtent) {
  EXPECT_EQ(Sphere<double>{}.radius, 0);
  EXPECT_EQ(Capsule<double>{}.radius, 0);
  EXPECT_EQ(Capsule<double>{}.half_height, 0);
  EXPECT_EQ(Cylinder<double>{}.radius, 0);
  EXPECT_EQ(Cone<double>{}.half_height, 0);
  EXPECT_EQ(Box<double>{}.half_extents, V(V::Zero()));
}

}  // namespace
}  // namespace graze
