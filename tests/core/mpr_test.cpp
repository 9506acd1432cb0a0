#include <gtest/gtest.h>
#include <graze/mpr.hpp>

#include "tests/core/draw.hpp"

namespace graze {
namespace {

using test::Draw;

Outcome overlap(const Body<double>& a, const Body<double>& b) {
  const Cso<double> cso(a, b);
  Counters counters;
  CastOptions<double> options;
  return mpr_overlap(cso, sweep_limits(cso, options), counters).outcome;
}

TEST(MprOverlap, BoxesTouchingAtAFaceAnEdgeAndACornerOverlap) {
  const Body<double> a{.shape = Box<double>{{1, 2, 3}}};
  for (const Vec3<double>& at : {Vec3<double>(2, 0, 0), Vec3<double>(0.5, 4, 1), Vec3<double>(2, 4, 0),
                                 Vec3<double>(2, 4, 6), Vec3<double>(0, 0, 0), Vec3<double>(-2, -4, 6)}) {
    const Body<double> b{.shape = Box<double>{{1, 2, 3}}, .position = at};
    EXPECT_EQ(overlap(a, b), Outcome::initially_overlapping) << at.transpose();
  }
  const double apart = std::nextafter(2.0, 3.0) + 1e-12;
  EXPECT_EQ(overlap(a, {.shape = Box<double>{{1, 2, 3}}, .position = {apart, 0, 0}}), Outcome::miss);
}

TEST(MprOverlap, AgreesWithGjkOnHulls) {
  Draw draw{31};
  int apart = 0, together = 0;
  for (int round = 0; round < 2000; ++round) {
    Body<double> a{.shape = draw.hull<double>(4 + round % 12, 1)},
        b{.shape = draw.hull<double>(4 + round % 9, 1)};
    b.position = draw.vector<double>(1.6);
    b.orientation = draw.turn<double>();
    const Cso<double> cso(a, b);
    Simplex<double> simplex;
    Counters counters;
    const Distance<double> d =
        gjk_distance(cso, Vec3<double>(Vec3<double>::Zero()), simplex, 1e-15, 1e-15, 256, counters);
    if (d.upper > 1e-13 && !(d.lower > 1e-13)) continue;  // between: either answer is right
    (d.lower > 1e-13 ? apart : together)++;
    EXPECT_EQ(overlap(a, b), d.lower > 1e-13 ? Outcome::miss : Outcome::initially_overlapping) << round;
  }
  EXPECT_GT(apart, 300);
  EXPECT_GT(together, 300);
}

TEST(MprOverlap, FlatShapesInOnePlane) {
  // A square and a triangle in z = 0, as a game in two dimensions has them.
  const Body<double> square{.shape = Hull<double>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
  Body<double> triangle{.shape = Hull<double>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  triangle.position = {0.5, 0.5, 0};
  EXPECT_EQ(overlap(square, triangle), Outcome::initially_overlapping);
  triangle.position = {1, 1, 0};  // corner on corner
  EXPECT_EQ(overlap(square, triangle), Outcome::initially_overlapping);
  triangle.position = {1.25, 0.5, 0};
  EXPECT_EQ(overlap(square, triangle), Outcome::miss);
  triangle.position = {0.5, 0.5, 0.125};
  EXPECT_EQ(overlap(square, triangle), Outcome::miss);
}

// The entry of the line {s r} into a box has a closed form: the slabs.
TEST(Portal, LineIntoABox) {
  Draw draw{32};
  int entered = 0, missed = 0;
  for (int round = 0; round < 2000; ++round) {
    const Vec3<double> half = draw.vector<double>(1).cwiseAbs();
    Body<double> a{.shape = Box<double>{half}}, b{.shape = Point<double>{}};
    b.position = draw.vector<double>(2);
    b.displacement = draw.vector<double>(2);
    double enter = -kInfinity<double>, leave = kInfinity<double>;
    for (int i = 0; i < 3; ++i) {
      const double near = (-half[i] - b.position[i]) / b.displacement[i];
      const double far = (half[i] - b.position[i]) / b.displacement[i];
      enter = std::max(enter, std::min(near, far));
      leave = std::min(leave, std::max(near, far));
    }
    const Cso<double> cso(a, b);
    const Frame<double> frame(cso.direction());
    Counters counters;
    const auto search = enter_line(cso, frame, kInfinity<double>, 1e-15, 256, counters);
    if (std::abs(leave - enter) < 1e-9) continue;
    if (enter > leave) {
      ++missed;
      EXPECT_EQ(search.state, PortalSearch<double>::State::missed) << round;
      EXPECT_LT(search.n.dot(cso.support(search.n).w), 0);
      EXPECT_NEAR(search.n.dot(frame.e3), 0, 4 * kUnitRoundoff<double>);
    } else {
      ++entered;
      ASSERT_EQ(search.state, PortalSearch<double>::State::entered) << round;
      EXPECT_NEAR(cso.to_time(search.upper / frame.length), enter, 1e-12 * (1 + std::abs(enter))) << round;
      EXPECT_NEAR(cso.to_time(search.lower / frame.length), enter, 1e-12 * (1 + std::abs(enter))) << round;
    }
  }
  EXPECT_GT(entered, 200);
  EXPECT_GT(missed, 200);
}

// A line in the plane of a face, along an edge, through a corner: ties in every decision.
TEST(Portal, LinesOnTheSilhouetteTouch) {
  const Body<double> box{.shape = Box<double>{{1, 1, 1}}};
  for (const Vec3<double>& from :
       {Vec3<double>(-3, 1, 0), Vec3<double>(-3, 1, 1), Vec3<double>(-3, 0.25, -1)}) {
    const Body<double> ray{.shape = Point<double>{}, .position = from, .displacement = {4, 0, 0}};
    const Cso<double> cso(box, ray);
    Counters counters;
    const auto search =
        enter_line(cso, Frame<double>(cso.direction()), kInfinity<double>, 1e-15, 256, counters);
    ASSERT_EQ(search.state, PortalSearch<double>::State::entered) << from.transpose();
    EXPECT_EQ(cso.to_time(search.upper / cso.direction().norm()), 0.5) << from.transpose();
  }
}

}  // namespace
}  // namespace graze
