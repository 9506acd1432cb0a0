// Brackets of cylinders, cones and ellipsoids that come from the curved walk: each holds the time of impact,
// by the oracle, and the answer comes from the walk. A bracket here is some hundred roundings wide. The
// search that the walk replaces proves its own bracket in pairs of doubles. The two have a time in common,
// and both agree on the verdict.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/cast.hpp>

#include "engines/convert.hpp"
#include "oracles/truth/case_truth.hpp"
#include "tests/shared/generate.hpp"

namespace {

using namespace graze;
using test::Draw;

int below(Draw& draw, int n) { return static_cast<int>(draw.between(0, n)); }

Shape<double> curved_shape(Draw& draw) {
  const double radius = std::ldexp(draw.between(1, 2), below(draw, 8) - 6);
  switch (below(draw, 3)) {
    case 0:
      return Cylinder<double>{radius, draw.between(0.125, 2)};
    case 1:
      return Cone<double>{radius, draw.between(0.125, 2)};
    default:
      return Ellipsoid<double>{{radius, draw.between(0.125, 2), draw.between(0.125, 2)}};
  }
}
Shape<double> other_shape(Draw& draw) {
  switch (below(draw, 5)) {
    case 0:
      return Box<double>{{draw.between(0.125, 2), draw.between(0.125, 2), draw.between(0.125, 2)}};
    case 1:
      return Capsule<double>{draw.between(0.125, 1), draw.between(0.125, 2)};
    case 2: {
      std::vector<Vec3<double>> points;
      for (int i = 0; i < 12; ++i)
        points.emplace_back(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1));
      return Hull<double>(points);
    }
    default:
      return curved_shape(draw);
  }
}

corpus::Case drawn(Draw& draw) {
  corpus::Case c;
  const double far = below(draw, 3) == 0 ? 1024 : 4;
  const Vec3<double> base(draw.between(-far, far), draw.between(-far, far), draw.between(-far, far));
  const Vec3<double> start(draw.between(-6, 6), draw.between(-6, 6), draw.between(3, 8));
  const Vec3<double> aim(draw.between(-2, 2), draw.between(-2, 2), draw.between(-2, 2));
  c.a = {.shape = curved_shape(draw), .position = base, .orientation = draw.turn<double>()};
  c.b = {.shape = other_shape(draw),
         .position = base + start,
         .orientation = draw.turn<double>(),
         .displacement = draw.between(1, 2) * (aim - start)};
  if (below(draw, 4) == 0) c.target_distance = draw.between(0.01, 1);
  if (below(draw, 2) == 0) std::swap(c.a, c.b);
  return c;
}

template <Scalar S>
void judge_brackets(int rounds) {
  Draw draw{std::same_as<S, double> ? 94u : 95u};
  int hits = 0, misses = 0, walked = 0, judged = 0;
  for (int round = 0; round < rounds; ++round) {
    corpus::Case c = drawn(draw);
    const Body<S> a = engine::round_to<S>(c.a), b = engine::round_to<S>(c.b);
    const S target = static_cast<S>(c.target_distance);
    c.a = engine::round_to<double>(a);
    c.b = engine::round_to<double>(b);
    c.target_distance = double(target);
    const CastOptions<S> options{.tier = Tier::certified, .target_distance = target};
    const CastResult<S> r = cast(a, b, options);
    walked += r.counters.gjk_iterations == 0;
    // The wider search, to which a proof belongs: what it states without condition.
    CastOptions<S> proved = options;
    proved.request = Request::everything;
    const CastResult<S> wide = cast(a, b, proved);
    ASSERT_TRUE(wide.proof.has_value()) << round;
    EXPECT_EQ(wide.toi_lower, r.toi_lower) << round;
    EXPECT_EQ(wide.toi_upper, r.toi_upper) << round;
    misses += r.outcome == Outcome::miss;
    if (r.outcome == Outcome::hit) {
      ++hits;
      if (wide.proof->portal_size > 0) {
        EXPECT_LE(double(r.toi_lower), wide.proof->toi_upper) << round;
      }
      EXPECT_GE(double(r.toi_upper), wide.proof->toi_lower) << round;
      EXPECT_NEAR(double(r.normal.norm()), 1, 8 * double(kUnitRoundoff<S>));
    }
    const oracle::CaseTruth truth(c);
    if (truth.outcome() == Outcome::not_converged) continue;
    ++judged;
    ASSERT_EQ(r.outcome, truth.outcome()) << round;
    if (r.outcome != Outcome::hit) continue;
    EXPECT_LE(double(r.toi_lower), truth.toi_upper()) << round;
    EXPECT_GE(double(r.toi_upper), truth.toi_lower()) << round;
    EXPECT_LE((r.point_a - r.point_b).template cast<double>().norm(),
              double(target) + double(r.distance) + 128 * double(kUnitRoundoff<S>) * truth.scale().low)
        << round;
  }
  EXPECT_GT(hits, rounds / 5);
  EXPECT_GT(misses, rounds / 5);
  EXPECT_GT(walked, rounds * 8 / 10);
  EXPECT_GT(judged, rounds / 2);
}

TEST(CurvedBracket, HoldsTheTimeOfImpact) { judge_brackets<double>(400); }
TEST(CurvedBracket, HoldsTheTimeOfImpactOfFloats) { judge_brackets<float>(150); }

// A flat end that lands flat on a box, a rim on a rim, an apex on a face: the closed times.
TEST(CurvedBracket, HoldsTimesThatAreKnown) {
  const Body<double> floor{.shape = Box<double>{{4, 4, 1}}};
  const Body<double> cone{
      .shape = Cone<double>{1, 1}, .position = {0.25, 0.5, 5}, .displacement = {0, 0, -8}};
  for (const Tier tier : {Tier::standard, Tier::certified}) {
    // Its base at height 4 above the floor's top at 1: 3 of 8.
    const CastResult<double> r = cast(floor, cone, {.tier = tier});
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_NEAR(r.toi_lower, 0.375, 1e-13);
    EXPECT_NEAR(r.toi_upper, 0.375, 1e-13);
    EXPECT_NEAR(r.normal.z(), 1, 1e-12);
    // Upside down its apex comes first, at the same height.
    Body<double> turned = cone;
    turned.orientation = {0, 1, 0, 0};
    const CastResult<double> apex = cast(floor, turned, {.tier = tier});
    ASSERT_EQ(apex.outcome, Outcome::hit);
    EXPECT_NEAR(apex.toi_lower, 0.375, 1e-13);
    EXPECT_NEAR(apex.point_b.x(), 0.25, 1e-12);
    EXPECT_NEAR(apex.point_b.y(), 0.5, 1e-12);
  }
}

}  // namespace
