// Parts of the proof of contact of rotating bodies: weights of the origin, and a passage through a flat C.
#include <gtest/gtest.h>

#include <graze/detail/rotating/crossing.hpp>
#include <graze/rotating_cast.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

TEST(RotatingParts, TheWeightsOfATetrahedronMeetAtTheOrigin) {
  Draw draw{91};
  for (int round = 0; round < 100; ++round) {
    detail::Simplex<double> four;
    Vec3<double> last = Vec3<double>::Zero();
    for (int i = 0; i < 4; ++i) {
      detail::CsoPoint<double> p;
      p.w = i < 3 ? draw.vector<double>(1) : Vec3<double>(-(last * draw.between(0.5, 2)));
      last += p.w;
      four.add(p);
    }
    detail::weigh(four);
    Vec3<double> sum = Vec3<double>::Zero();
    for (std::size_t i = 0; i < 4; ++i) sum += four.lambda[i] * four.point[i].w;
    EXPECT_LE(sum.norm(), 1e-12) << round;
  }
}

// A point flies through a triangle that turns slowly in its plane: the corners are where the bodies have
// them.
TEST(RotatingParts, APointThatPassesThroughATriangleCrosses) {
  const RotatingBody<double> a{
      .body = {.shape = Triangle<double>{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, .position = {0.5, 0.25, 0}},
      .rotation = {0, 0, 0.125}};
  RotatingBody<double> b{
      .body = {.shape = Point<double>{}, .position = {0.375, 0.25, 1}, .displacement = {0, 0, -2}}};
  const auto crosses_between = [&](double t_1, double t_2) {
    detail::MovingPair pair(a, b, 0.0);
    pair.place(t_1);
    detail::Simplex<double> triangle;
    for (std::uint32_t i = 0; i < 3; ++i) {
      detail::CsoPoint<double> p;
      p.vertex_a = i;
      triangle.add(p);
    }
    return detail::crosses(pair, triangle, t_1, t_2);
  };
  EXPECT_TRUE(crosses_between(0.4375, 0.5625));
  EXPECT_FALSE(crosses_between(0.25, 0.375));
  b.body.position[0] = 4;
  EXPECT_FALSE(crosses_between(0.4375, 0.5625));
}

TEST(RotatingParts, TheCornersOfATriangleAreWhereTheBodiesHaveThem) {
  const RotatingBody<double> a{
      .body = {.shape = Triangle<double>{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, .position = {0.5, 0.25, 0}},
      .rotation = {0, 0, 2}};
  const RotatingBody<double> b{.body = {.shape = Point<double>{}, .position = {0.25, 0.5, 1}}};
  detail::MovingPair pair(a, b, 0.0);
  pair.place(0);
  detail::Simplex<double> triangle;
  for (std::uint32_t i = 0; i < 3; ++i) {
    detail::CsoPoint<double> p;
    p.vertex_a = i;
    triangle.add(p);
  }
  const double unit = power_of_two(-pair.cso().length_exponent());
  const auto corners = detail::corners_now(pair, detail::points_of(pair, triangle));
  EXPECT_LE((corners[0] - unit * Vec3<double>(1.25, -0.25, -1)).norm(), 1e-14);
  EXPECT_LE((corners[1] - unit * Vec3<double>(-0.75, 0.75, -1)).norm(), 1e-14);
  EXPECT_LE((corners[2] - unit * Vec3<double>(-0.75, -1.25, -1)).norm(), 1e-14);
}

TEST(RotatingParts, WhatIsSimulatedPrints) {
  EXPECT_EQ(to_text(Effects::nothing), "nothing");
  EXPECT_EQ(to_text(Effects::at_rest), "static");
  EXPECT_EQ(to_text(Effects::linear), "linear");
  EXPECT_EQ(to_text(Effects::rotating), "rotating");
}

TEST(RotatingParts, ATurnThatCannotBeSeenHasOneReason) {
  const RotatingBody<double> box{
      .body = {.shape = Box<double>{{1, 1, 1}}, .position = {-4, 0, 0}, .displacement = {8, 0, 0}}};
  const Shape<double> solids[] = {Sphere<double>{0.5}, Capsule<double>{0.5, 1}, Cylinder<double>{0.5, 1},
                                  Cone<double>{0.5, 1}, Ellipsoid<double>{{0.5, 0.5, 1}}};
  for (const Shape<double>& shape : solids) {
    const RotatingBody<double> solid{.body = {.shape = shape}, .rotation = {0, 0, 3}};
    const auto one = cast(solid, box), other = cast(box, solid);
    EXPECT_TRUE(one.plan.has(PlanReason::unseen_spin_a)) << shape.index();
    EXPECT_FALSE(one.plan.has(PlanReason::rotation_a));
    EXPECT_TRUE(other.plan.has(PlanReason::unseen_spin_b)) << shape.index();
    EXPECT_FALSE(other.plan.has(PlanReason::rotation_b));
  }
}

}  // namespace
}  // namespace graze
