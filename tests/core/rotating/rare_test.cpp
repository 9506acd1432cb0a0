// Rare cases of rotating casts: spheres of bounds that meet where the bodies do, a contact between two times,
// a published step that stands still, and the statements of plans.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/rotating_cast.hpp>
#include <set>
#include <span>
#include <vector>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

RotatingOptions<double> by(RotatingMethod method) {
  return {.method = method, .request = Request::everything};
}

// The farthest corner of a triangle, on the axis that it turns about, flies into a ball: the bodies meet as
// the spheres about their pivots do, at the time that subdivision begins with.
TEST(RotatingRare, SpheresThatMeetWhereTheBodiesDoHaveTheirWitnesses) {
  const RotatingBody<double> a{
      .body = {.shape = Triangle<double>{{1, 0, 0}, {-0.5, 0.5, 0}, {-0.5, -0.5, 0}}}, .rotation = {2, 0, 0}};
  const RotatingBody<double> b{
      .body = {.shape = Sphere<double>{0.5}, .position = {3, 0, 0}, .displacement = {-4, 0, 0}}};
  const auto r = cast(a, b, by(RotatingMethod::bounding_spheres));
  ASSERT_EQ(r.outcome, Outcome::hit);
  // 64 u of the scale, 3, for the contact and for the bracket, over the speed, 4.
  EXPECT_NEAR(r.toi_lower, 1.5 / 4, 2 * 64 * kUnitRoundoff<double> * 3 / 4);
  EXPECT_LE((r.point_a - V(1, 0, 0)).norm(), 1e-8);
  EXPECT_LE((r.point_b - V(1, 0, 0)).norm(), 1e-8);
}

// A point flies through a triangle that turns: contact is proved between two times, the first of which is no
// earlier than the proof's lower end.
TEST(RotatingRare, ACrossingSaysFromWhen) {
  const RotatingBody<double> a{
      .body = {.shape = Triangle<double>{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, .position = {0.5, 0.25, 0}},
      .rotation = {0, 0, 0.125}};
  const RotatingBody<double> b{
      .body = {.shape = Point<double>{}, .position = {0.375, 0.25, 1}, .displacement = {0, 0, -2}}};
  RotatingOptions<double> options{.request = Request::everything};
  options.tier = Tier::certified;
  const auto r = cast(a, b, options);
  ASSERT_EQ(r.outcome, Outcome::hit);
  ASSERT_TRUE(r.proof.has_value());
  ASSERT_TRUE(r.proof->crossing);
  // The tier's width, 1e-9 of the scale, the triangle's diagonal, over the speed.
  EXPECT_NEAR(r.proof->contact_from, 0.5, 1e-9 * std::sqrt(8.0) / 2);
  EXPECT_LE(r.proof->contact_from, r.proof->toi_upper);
  EXPECT_LE(0.5, r.proof->toi_upper);
}

// Ellipsoids are a little farther apart than the tolerance, and GJK knows their distance only to a quarter of
// it. If the pair that is pushed back is within the tolerance already, the step stands still. It is in
// contact by the tolerance.
TEST(RotatingRare, AStepThatStandsStillIsContact) {
  Draw draw{1};
  int contacts = 0;
  for (int round = 0; round < 20000; ++round) {
    const auto ellipsoid = [&](double longest) {
      return Ellipsoid<double>{{longest, draw.between(0.05, 1), draw.between(0.05, 1)}};
    };
    RotatingBody<double> a{.body = {.shape = ellipsoid(1), .orientation = draw.turn<double>()},
                           .rotation = draw.vector<double>(1)};
    RotatingBody<double> b{.body = {.shape = ellipsoid(draw.between(0.2, 1)),
                                    .position = draw.vector<double>(2.5),
                                    .orientation = draw.turn<double>(),
                                    .displacement = draw.vector<double>(2)},
                           .rotation = draw.vector<double>(1)};
    RotatingOptions<double> options = by(RotatingMethod::bilateral_published);
    options.tolerance = draw.between(0.01, 0.2);
    const auto r = cast(a, b, options);
    EXPECT_NE(r.outcome, Outcome::not_converged) << round;
    contacts += r.outcome == Outcome::hit || r.outcome == Outcome::initially_overlapping;
  }
  EXPECT_GT(contacts, 1000);
}

// A start that touches, and is not proved to, is open from 0 on or a hit that begins there. The search had ended where
// the balls about the cores met, with an axis on its way to the closest points and with others than those.
TEST(RotatingRare, AStartThatTouchesHasItsClosestPoints) {
  // The cone's tip is at (-4, -1, -3).
  const RotatingBody<double> a{
      .body = {.shape = Cone<double>{1, 1}, .position = {-3, -1, -3}, .orientation = {1, 0, -1, 0}},
      .rotation = {2, -2, -1},
      .pivot = {43, 25, -25}};
  const RotatingBody<double> b{
      .body = {.shape = Capsule<double>{4, 2}, .position = {-8, -1, -3}, .displacement = {3, 1, -4}},
      .rotation = {1.4, -2.1, -0.7}};
  RotatingOptions<double> options{.request = Request::everything};
  options.tier = Tier::certified;
  const auto r = cast(a, b, options);
  ASSERT_TRUE(r.outcome == Outcome::hit || r.outcome == Outcome::not_converged);
  EXPECT_EQ(r.toi_lower, 0);
  EXPECT_LE((r.normal - V(-1, 0, 0)).norm(), 1e-9);
  EXPECT_LE((r.point_a - V(-4, -1, -3)).norm(), 1e-9);
  EXPECT_LE((r.point_b - V(-4, -1, -3)).norm(), 1e-9);
}

// Two points are at one place at t = 0, and one of them rotates about a pivot beside it. The remainder of
// arms that cancel is known to 2^-90 of them, so the certified tier cannot decide, and must not return a
// miss.
TEST(RotatingRare, ArmsThatCancelLeaveAStartOpen) {
  const RotatingBody<double> a{.body = {.position = {1, 1, 0}}};
  const RotatingBody<double> b{.body = {.position = {1, 1, 0}, .orientation = {0, 0, 1, 32}},
                               .rotation = {0, 0, 1},
                               .pivot = {0, 0, 1}};
  RotatingOptions<double> options;
  EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping);
  options.tier = Tier::certified;
  const auto r = cast(a, b, options);
  EXPECT_NE(r.outcome, Outcome::miss);
  EXPECT_EQ(r.toi_lower, 0);
}

// A rod and a needle with a square for a tip, on one line and 4e-8 into each other. The origin is amid the
// square, on the diagonal of its corners, and no four corners of C surround it.
TEST(RotatingRare, AContactThatNoFourCornersSurroundIsOneAtTheStart) {
  const double thick = 0x1p-14;
  const std::vector<V> tip = {
      {0, thick, thick}, {0, thick, -thick}, {0, -thick, thick}, {0, -thick, -thick}, {-2, 0, 0}};
  const RotatingBody<double> a{.body = {.shape = Hull<double>(std::span<const V>(tip))},
                               .rotation = {0, 0, 0.25}};
  const RotatingBody<double> b{.body = {.shape = Segment<double>{{-0x1p-24, 0, 0}, {2, 0, 0}}}};
  RotatingOptions<double> options{.request = Request::everything};
  options.tier = Tier::certified;
  const auto r = cast(a, b, options);
  EXPECT_EQ(r.outcome, Outcome::initially_overlapping);
  ASSERT_TRUE(r.proof.has_value());
  EXPECT_EQ(r.proof->toi_upper, 0);
  options.request = Request::verdict;
  EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping);
}

// A point in the middle of a cone's base: the origin is between the base's centre and the apex, and of the corners of
// C that searches meet on that line no four surround it. Those around it do.
TEST(RotatingRare, APointOnTheAxisOfAConeIsContact) {
  const RotatingBody<double> a{.body = {.shape = Point<double>{}}};
  for (const double turn : {0.0, 6.0}) {
    const RotatingBody<double> b{
        .body = {.shape = Cone<double>{1, 1}, .position = {0, 0, 4.5}, .displacement = {0, 0, -5}},
        .rotation = {0, 0, turn}};
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      const auto r = cast(a, b, {.tier = tier, .request = Request::everything});
      ASSERT_EQ(r.outcome, Outcome::hit) << turn;
      EXPECT_LE(r.toi_lower, 0.7);
      EXPECT_GE(r.toi_upper, 0.7);
      EXPECT_LE(r.toi_upper - r.toi_lower, 1e-8);
      ASSERT_TRUE(r.proof.has_value());
      EXPECT_EQ(r.proof->contact_size, 4);
    }
  }
}

// An octahedron that spins about its diagonal: on it no four of the six corners have the origin inside. Three
// corners and the mean of two do, and so do a square pyramid's five. A hexagon's tip has four such corners.
TEST(RotatingRare, ATipOnAPointIsContact) {
  const RotatingBody<double> a{.body = {.shape = Point<double>{}}};
  for (const int corners : {4, 6}) {
    for (const bool pyramid : {false, true}) {
      std::vector<V> tips = {{0, 0, -1}};
      if (!pyramid) tips.push_back({0, 0, 1});
      for (int i = 0; i < corners; ++i) {
        const double angle = i * 2 * M_PI / corners;
        tips.push_back(corners == 4 ? V(i == 0   ? 1
                                        : i == 2 ? -1
                                                 : 0,
                                        i == 1   ? 1
                                        : i == 3 ? -1
                                                 : 0,
                                        0)
                                    : V(std::cos(angle), std::sin(angle), 0));
      }
      const RotatingBody<double> b{.body = {.shape = Hull<double>(std::span<const V>(tips)),
                                            .position = {0, 0, 4.5},
                                            .displacement = {0, 0, -5}},
                                   .rotation = {0, 0, 6}};
      for (const Tier tier : {Tier::standard, Tier::certified}) {
        const auto r = cast(a, b, {.tier = tier, .request = Request::everything});
        ASSERT_EQ(r.outcome, Outcome::hit) << corners << pyramid;
        EXPECT_LE(r.toi_lower, 0.7);
        EXPECT_GE(r.toi_upper, 0.7);
        EXPECT_LE(r.toi_upper - r.toi_lower, 1e-8);
        ASSERT_TRUE(r.proof.has_value());
        EXPECT_EQ(r.proof->contact_size, corners == 4 ? 5 : 4);
      }
    }
  }
}

// A crate that yaws slides from one floor tile onto the next, level with it. Before they touch, the axis is
// that of the tile's edge, along which the crate advances. In contact it is that of the tile's top, along
// which nothing moves. The contact is a tie and stays undecided. It must not cost an evaluation at every
// millionth of the step.
TEST(RotatingRare, AContactThatStaysATieIsNotLookedAtAllAlong) {
  const RotatingBody<double> tile{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {3, 0, -1}}};
  for (const double spin : {1e-3, 1.0, 10.0}) {
    RotatingBody<double> crate{
        .body = {.shape = Box<double>{{0.5, 0.5, 0.5}}, .position = {0, 0, 0.5}, .displacement = {3, 0, 0}},
        .rotation = {0, 0, spin}};
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      const auto r = cast(tile, crate, {.tier = tier});
      EXPECT_NE(r.outcome, Outcome::miss) << spin;
      EXPECT_LT(r.counters.supports, 4000) << spin;
      crate.body.position[2] = 0.5 - 1e-9;
      EXPECT_EQ(cast(tile, crate, {.tier = tier}).outcome, Outcome::hit) << spin;
      crate.body.position[2] = 0.5;
    }
  }
}

// The start is decided before the rest of the motion.
TEST(RotatingRare, ABoxThatSpinsWhereItRestsIsInContactAtOnce) {
  const RotatingBody<double> floor{.body = {.shape = Box<double>{{50, 50, 1}}}};
  const RotatingBody<double> box{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {0, 0, 2}},
                                 .rotation = {0, 0, 10}};
  const auto r = cast(floor, box, {.tier = Tier::certified});
  EXPECT_EQ(r.outcome, Outcome::initially_overlapping);
  EXPECT_LT(r.counters.supports, 200);
}

// Bodies on equal arms of 2.7e8 about pivots apart: each moves at 1.7e8, neither to the other. One slice says
// so.
TEST(RotatingRare, EqualArmsStandStillToEachOther) {
  const V w(0.19577492773532867, 0.5873247981071472, -0.19577492773532867),
      pivot(-141477904, 113182320, 198069072);
  const RotatingBody<double> a{
      .body = {.shape = Sphere<double>{1.1884433031082153}, .position = {1.661403992159194e-08, 0, 0}},
      .rotation = w,
      .pivot = pivot};
  const RotatingBody<double> b{
      .body = {.position = {-1.1884433031082153, 0, 0}}, .rotation = w, .pivot = pivot};
  RotatingOptions<double> options{.request = Request::everything, .t_max = 4};
  options.tier = Tier::certified;
  const auto r = cast(a, b, options);
  EXPECT_EQ(r.outcome, Outcome::miss);
  ASSERT_TRUE(r.proof.has_value());
  EXPECT_LE(r.proof->chain.size(), 2u);
}

// Two balls that turn almost as one come together at 1.6e-11 while both move at 1e6. Nearer than an axis that
// turns with them can tell, the axes of the world gave slices of 1e-9, until the budget was spent.
TEST(RotatingRare, BodiesThatTurnAlmostAsOneMeet) {
  const V v(0.027732805807881095, -0.06418070310430851, 0.019166119004061566), w(0, -0.11847878992557526, 0);
  const RotatingBody<double> a{.body = {.shape = Sphere<double>{3.650273614563048},
                                        .position = {1.0116077415523674e-09, 0, 0},
                                        .displacement = v},
                               .rotation = w,
                               .pivot = {2188331.9999999995, -20359664.000000004, 13129996}};
  const RotatingBody<double> b{.body = {.shape = Sphere<double>{3.738158341497183},
                                        .position = {-7.388431956060231, 0, 0},
                                        .displacement = v},
                               .rotation = w,
                               .pivot = {2188339.388431956, -10212219, 13129996}};
  const auto r = cast(a, b, {.t_max = 64});
  EXPECT_EQ(r.outcome, Outcome::hit);
  EXPECT_LE(r.counters.supports, 500);
}

TEST(RotatingRare, EveryReasonHasItsOwnWords) {
  constexpr int kReasons = kPlanReasons;
  std::set<std::string_view> texts;
  for (int k = 0; k < kReasons; ++k) texts.insert(to_text(static_cast<PlanReason>(k)));
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(kReasons));
  EXPECT_EQ(to_text(PlanReason::unseen_spin_a), "A's rotation cannot be seen");
  EXPECT_EQ(to_text(PlanReason::unseen_spin_b), "B's rotation cannot be seen");
}

}  // namespace
}  // namespace graze
