// Casts of balls about polytopes that the round walk answers: what a tolerance may not change, and the normal.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <graze/cast.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

// Report: with a tolerance of 1e-8 the whole bracket lay after the contact. Mechanism: the lower end rested on the vertex
// that floats take for the farthest, of three that are one to a float.
TEST(RoundCast, IsNeverLateWhereFloatsCannotTellVerticesApart) {
  Draw draw{311};
  int hits = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto near = [&](const Vec3<double>& p) {
      return Vec3<double>(p +
                          1e-7 * Vec3<double>(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)));
    };
    const Vec3<double> corner(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)),
        v(-3.1, -1.9, 2.4);
    const Vec3<double> beside(draw.between(-0.12, 0.12), draw.between(-0.12, 0.12),
                              draw.between(-0.12, 0.12));
    const Body<double> a{.shape = Hull<double>{corner, near(corner), near(corner), Vec3<double>(-corner)}};
    const Body<double> b{
        .shape = Sphere<double>{0.125}, .position = corner + beside - 0.5 * v, .displacement = v};
    const CastResult<double> truth = cast(a, b, {.tier = Tier::certified});
    if (truth.outcome != Outcome::hit) continue;
    ++hits;
    for (const double tolerance : {0.0, 1e-12, 1e-10, 1e-8, 1e-6, 1e-3}) {
      const CastResult<double> r = cast(a, b, {.tolerance = tolerance});
      ASSERT_EQ(r.outcome, Outcome::hit) << tolerance;
      EXPECT_LE(r.toi_lower, truth.toi_upper + 1e-13) << "tolerance " << tolerance << ", round " << round;
      EXPECT_GE(r.toi_upper, truth.toi_lower - 1e-13) << "tolerance " << tolerance << ", round " << round;
    }
  }
  EXPECT_GT(hits, 400);
}

// For a hit with a tolerance, the normal is the axis that proves the lower end: nothing of C lies beyond its
// plane through the path's point then.
TEST(RoundCast, TheNormalSupportsWhatTheLowerEndSays) {
  Draw draw{312};
  int hits = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto extents = [&] {
      return Vec3<double>(std::max(draw.between(-1, 2), 0.0), draw.between(0, 2), draw.between(0, 2));
    };
    const Vec3<double> half_a = extents(), half_b = extents(),
                       from(draw.between(-4, 4), draw.between(-4, 4), 5);
    const Vec3<double> v(draw.between(-4, 4), draw.between(-4, 4), -8);
    const double distance = draw.between(0, 1), tolerance = std::pow(10.0, draw.between(-9, -2));
    const Body<double> a{.shape = Box<double>{half_a}},
        b{.shape = Box<double>{half_b}, .position = from, .displacement = v};
    const CastResult<double> r =
        cast(a, b, {.method = Method::gjk_ray_cast, .target_distance = distance, .tolerance = tolerance});
    if (r.outcome != Outcome::hit) continue;
    ++hits;
    const Vec3<double>& n = r.normal;
    // Its length, the quotient and the products, and here the norm: 8 u.
    EXPECT_NEAR(n.norm(), 1, 8 * kUnitRoundoff<double>);
    EXPECT_LT(n.dot(v), 0);
    const double reach = n.cwiseAbs().dot(half_a + half_b) + distance - n.dot(from);
    EXPECT_LE(reach - r.toi_lower * n.dot(v), 1e-12) << "round " << round << ", tolerance " << tolerance;
  }
  EXPECT_GT(hits, 1000);
}

// Report: normals from B to A. Mechanism: of a ball far smaller than the rounding of where it is, the side of a flat shape
// that it lies on at contact is rounding.
TEST(RoundCast, ABallOfNoSizeMeetsTheSideThatItComesFrom) {
  const Body<double> a{.shape = Triangle<double>{{-3, -3, 0.1}, {3, -2, 0.7}, {0.3, 4, -0.9}}};
  for (const double radius : {1e-17, 1e-15, 1e-13}) {
    for (int k = 0; k < 400; ++k) {
      const Body<double> b{.shape = Sphere<double>{radius},
                           .position = {0.1 + 0.001 * k, 0.2, 2},
                           .displacement = {0.3, 0.002 * k, -5}};
      const CastResult<double> r = cast(a, b);
      ASSERT_EQ(r.outcome, Outcome::hit);
      EXPECT_LT(r.normal.dot(b.displacement), 0) << radius << ", " << k;
    }
  }
}

// The weights of a sliver round by the square of how thin it is, and the distance of a ball that lands on it hardly tells.
TEST(RoundCast, WitnessesOnSliversLieAtEachOther) {
  Draw draw{313};
  int hits = 0;
  for (int round = 0; round < 2000; ++round) {
    const double width = std::ldexp(1.0, -static_cast<int>(draw.bits() % 16));
    const Vec3<double> across = width * draw.vector<double>(1), along = draw.vector<double>(1);
    const Vec3<double> corner = draw.vector<double>(1), met = corner + 0.3 * across + 0.4 * along;
    const Vec3<double> normal = along.cross(across).normalized();
    const Body<double> a{.shape = Triangle<double>{corner, corner + across, corner + along}},
        b{.shape = Sphere<double>{1}, .position = met + 2 * normal, .displacement = -2 * normal};
    const CastResult<double> r = cast(a, b, {.method = Method::gjk_ray_cast});
    if (r.outcome != Outcome::hit) continue;
    ++hits;
    EXPECT_LT((r.point_a - r.point_b).norm(), 2e-14) << "round " << round << ", width " << width;
  }
  EXPECT_GT(hits, 1900);
}

// The round walk takes roundings of polytopes, too: one with a radius r and one at a target distance r meet at the same time.
TEST(RoundCast, ARoundedPolytopeIsCastLikeOneAtATargetDistance) {
  Draw draw{313};
  int hits = 0, supports = 0;
  for (int round = 0; round < 400; ++round) {
    const auto vector = [&](double most) {
      return Vec3<double>(draw.between(-most, most), draw.between(-most, most), draw.between(-most, most));
    };
    const Shape<double> box = Box<double>{vector(1).cwiseAbs()},
                        hull = Hull<double>{vector(1), vector(1), vector(1), vector(1), vector(1)},
                        triangle = Triangle<double>{vector(1), vector(1), vector(1)};
    const Shape<double>& shape = round % 3 == 0 ? box : round % 3 == 1 ? hull : triangle;
    const double radius = draw.between(0.01, 0.5);
    const Vec3<double> from = vector(3);
    const Quaternion<double> turned{draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1), 1};
    const Body<double> b{
        .shape = box, .position = from, .orientation = turned, .displacement = vector(1) - 1.5 * from};
    for (const Tier tier : {Tier::certified, Tier::exact}) {
      const CastResult<double> rounded_one =
          cast(Body<double>{.shape = rounded<double>(shape, radius)}, b, {.tier = tier});
      const CastResult<double> at_distance =
          cast(Body<double>{.shape = shape}, b, {.tier = tier, .target_distance = radius});
      EXPECT_EQ(rounded_one.outcome, at_distance.outcome);
      EXPECT_EQ(rounded_one.toi_lower, at_distance.toi_lower);
      EXPECT_EQ(rounded_one.toi_upper, at_distance.toi_upper);
      hits += rounded_one.outcome == Outcome::hit;
      supports += rounded_one.counters.supports;
    }
  }
  EXPECT_GT(hits, 400);
  EXPECT_LT(supports, 10 * 800);
}

}  // namespace
}  // namespace graze
