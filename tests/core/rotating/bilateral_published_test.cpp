// Bilateral advancement as published, the baseline: right within its slop where a step holds one contact, and
// blind to a contact that begins and ends within the step.
#include <gtest/gtest.h>

#include <graze/rotating_cast.hpp>
#include <numbers>

#include "tests/shared/turning_bodies.hpp"

namespace graze {
namespace {

using test::Draw;

RotatingOptions<double> by(RotatingMethod method) {
  return {.method = method, .request = Request::everything};
}

RotatingResult<double> published(const RotatingBody<double>& a, const RotatingBody<double>& b) {
  return cast(a, b, by(RotatingMethod::bilateral_published));
}

// A cube's corner rotates into a wall's face: the axis is the face's, whichever body it belongs to.
TEST(BilateralPublished, ACornerTurnsIntoAWall) {
  const RotatingBody<double> cube{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {0, 0, 1}};
  const RotatingBody<double> wall{.body = {.shape = Box<double>{{1, 2, 2}}, .position = {2.25, 0.125, 0.25}}};
  const double toi = std::numbers::pi / 4 - std::acos(1.25 / std::numbers::sqrt2);
  for (const bool swapped : {false, true}) {
    const auto r = swapped ? published(wall, cube) : published(cube, wall);
    ASSERT_EQ(r.outcome, Outcome::hit);
    // The slop and its quarter, lengths: 1/160 of scale, 6 at most. The corner's speed in x is 0.6 and more
    // there.
    EXPECT_LE(r.toi_lower, toi);
    EXPECT_GE(r.toi_lower, toi - 6.0 / 160 / 0.6);
    EXPECT_NEAR(r.normal[0], swapped ? -1 : 1, 1e-12);
  }
}

// A tolerance of the caller's in place of the slop: as near as it says.
TEST(BilateralPublished, StopsAtTheTolerance) {
  const RotatingBody<double> rod{.body = {.shape = Segment<double>{{0, 0, 0}, {1, 0, 0}}},
                                 .rotation = {0, 0, 2}};
  const RotatingBody<double> ball{.body = {.shape = Sphere<double>{0.25}, .position = {0, 0.75, 0}}};
  const double toi = (std::numbers::pi / 2 - std::asin(0.25 / 0.75)) / 2;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    RotatingOptions<double> options = by(RotatingMethod::bilateral_published);
    options.tolerance = tolerance;
    const auto r = cast(rod, ball, options);
    ASSERT_EQ(r.outcome, Outcome::hit);
    // The scale is sqrt(5/4) at most. At the hit the rod's point approaches the ball at a speed of 2
    // cos(asin(1/3)) 3/4.
    const double speed = 2 * 0.75 * std::cos(std::asin(1.0 / 3));
    EXPECT_LE(r.toi_lower, toi);
    EXPECT_GE(r.toi_lower, toi - 2 * tolerance * 1.25 / speed);
  }
}

TEST(BilateralPublished, MissesAContactThatBeginsAndEndsWithinTheStep) {
  // A flat blade sweeps half a rotation across a small ball, and is far from it at both ends of the step.
  const RotatingBody<double> blade{.body = {.shape = Box<double>{{2, 0.03125, 0.25}}, .position = {0, 0, 0}},
                                   .rotation = {0, 0, 3},
                                   .pivot = {-2, 0, 0}};
  const RotatingBody<double> ball{
      .body = {.shape = Sphere<double>{0.0625}, .position = {-2, 3, 0}, .displacement = {0, -0.5, 0}}};
  const auto safe = cast(blade, ball, by(RotatingMethod::bilateral_advancement));
  ASSERT_EQ(safe.outcome, Outcome::hit);
  EXPECT_EQ(published(blade, ball).outcome, Outcome::miss);
}

TEST(BilateralPublished, AStartInContactIsOne) {
  const RotatingBody<double> box{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {1, 0, 0}};
  const RotatingBody<double> inside{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {0.5, 0.25, 0.125}},
                                    .rotation = {0, 2, 0}};
  EXPECT_EQ(published(box, inside).outcome, Outcome::initially_overlapping);
}

// It may stop at a later contact than the first, but where it stops the bodies are near.
TEST(BilateralPublished, WhereItStopsTheBodiesAreNear) {
  Draw draw{90};
  int hits = 0, misses = 0;
  for (int round = 0; round < 1000; ++round) {
    const RotatingBody<double> a = test::turning_body(draw), b = test::turning_body(draw);
    const auto r = published(a, b);
    if (r.outcome == Outcome::hit) {
      ++hits;
      EXPECT_LE((r.point_a - r.point_b).norm(), 15.0 / 160);  // scale is below 15
    }
    misses += r.outcome == Outcome::miss;
  }
  EXPECT_GE(hits, 30);
  EXPECT_GE(misses, 100);
}

}  // namespace
}  // namespace graze
