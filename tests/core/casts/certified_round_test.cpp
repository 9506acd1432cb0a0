// Brackets of spheres, capsules and polytopes at a distance, which the exact tier answers from the round
// walk. Each holds the time of impact, by the oracle, to its last bit, and the answer comes from the walk.
// Near and far from the origin, balls large and small, grazes, in float and in double.
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

Shape<double> any_shape(Draw& draw, int kind) {
  const double radius = std::ldexp(draw.between(1, 2), below(draw, 11) - 8);
  switch (kind) {
    case 0:
      return Sphere<double>{radius};
    case 1:
      return Capsule<double>{radius, draw.between(0.125, 2)};
    case 2:
      return Box<double>{{draw.between(0.125, 2), draw.between(0.125, 2), draw.between(0.125, 2)}};
    default:
      return Triangle<double>{{draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)},
                              {draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)},
                              {draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)}};
  }
}

corpus::Case drawn(Draw& draw) {
  corpus::Case c;
  const double far = below(draw, 3) == 0 ? 1024 : 4;
  const Vec3<double> base(draw.between(-far, far), draw.between(-far, far), draw.between(-far, far));
  const Vec3<double> start(draw.between(-6, 6), draw.between(-6, 6), draw.between(3, 8));
  const Vec3<double> aim(draw.between(-2, 2), draw.between(-2, 2), draw.between(-2, 2));
  c.a = {.shape = any_shape(draw, below(draw, 4)), .position = base, .orientation = draw.turn<double>()};
  c.b = {.shape = any_shape(draw, below(draw, 2)),
         .position = base + start,
         .orientation = draw.turn<double>(),
         .displacement = draw.between(1, 2) * (aim - start)};
  if (below(draw, 4) == 0) {
    c.b.shape = any_shape(draw, 2);
    c.target_distance = draw.between(0.01, 1);
  }
  return c;
}

template <Scalar S>
void judge_brackets(int rounds) {
  Draw draw{std::same_as<S, double> ? 91u : 92u};
  int hits = 0, misses = 0, walked = 0;
  for (int round = 0; round < rounds; ++round) {
    corpus::Case c = drawn(draw);
    const Body<S> a = engine::round_to<S>(c.a), b = engine::round_to<S>(c.b);
    const S target = static_cast<S>(c.target_distance);
    c.a = engine::round_to<double>(a);
    c.b = engine::round_to<double>(b);
    c.target_distance = double(target);
    const CastResult<S> r = cast(a, b, {.tier = Tier::certified, .target_distance = target});
    walked += r.counters.portal_steps == 0;
    const oracle::CaseTruth truth(c);
    if (truth.outcome() == Outcome::not_converged) continue;
    ASSERT_EQ(r.outcome, truth.outcome()) << round;
    misses += r.outcome == Outcome::miss;
    if (r.outcome != Outcome::hit) continue;
    ++hits;
    EXPECT_LE(double(r.toi_lower), truth.toi_upper()) << round;
    EXPECT_GE(double(r.toi_upper), truth.toi_lower()) << round;
    EXPECT_NEAR(double(r.normal.norm()), 1, 8 * double(kUnitRoundoff<S>));
    // Witnesses are of toi_lower, where the bodies are r.distance apart at most, and each within 64 u scale of its body.
    EXPECT_LE((r.point_a - r.point_b).template cast<double>().norm(),
              double(target) + double(r.distance) + 128 * double(kUnitRoundoff<S>) * truth.scale().low)
        << round;
  }
  EXPECT_GT(hits, rounds / 5);
  EXPECT_GT(misses, rounds / 5);
  EXPECT_GT(walked, rounds * 9 / 10);
}

TEST(RoundPairs, HoldsTheTimeOfImpact) { judge_brackets<double>(600); }
TEST(RoundPairs, HoldsTheTimeOfImpactOfFloats) { judge_brackets<float>(200); }

// The path's offset is moved to where ball arithmetic says that it grazes: the verdict is right on either side.
TEST(RoundPairs, GrazesAreDecided) {
  Draw draw{93};
  for (int round = 0; round < 60; ++round) {
    const double r_a = draw.between(0.25, 1), r_b = draw.between(0.25, 1);
    for (const double aside : {-0x1p-30, -0x1p-44, -0x1p-52, 0.0, 0x1p-52, 0x1p-44, 0x1p-30}) {
      corpus::Case c;
      c.a = {.shape = Sphere<double>{r_a}};
      c.b = {.shape = Capsule<double>{r_b, 0.5},
             .position = {-4, (r_a + r_b) * (1 + aside), 0},
             .displacement = {8, 0, 0}};
      const CastResult<double> r = cast(c.a, c.b, {.tier = Tier::certified});
      const oracle::CaseTruth truth(c);
      if (truth.outcome() == Outcome::not_converged) continue;
      EXPECT_EQ(r.outcome, truth.outcome()) << round << ' ' << aside;
    }
  }
}

}  // namespace
