#include <gtest/gtest.h>
#include <graze/detail/search/robust/mpr.hpp>
#include <graze/distance.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

template <Scalar S>
Outcome overlap(const Body<S>& a, const Body<S>& b) {
  const detail::Cso<S> cso(a, b);
  Counters counters;
  CastOptions<S> options;
  return detail::mpr_overlap(cso, detail::sweep_limits(cso, options), counters).outcome;
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
    const detail::Cso<double> cso(a, b);
    detail::Simplex<double> simplex;
    Counters counters;
    const detail::Distance<double> d =
        detail::gjk_distance(cso, Vec3<double>(Vec3<double>::Zero()), simplex, 1e-15, 1e-15, 256, counters);
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

// The line from C's inside runs in the plate's own plane, within the rounding of float: no face of the portal
// says where along it the plate ends. They are 0.07 of their size apart.
TEST(MprOverlap, APlateSeenEdgeOnEnds) {
  const Body<float> plate{.shape = Box<float>{{2.1763108F, 3.2389083F, 2.5e-6F}},
                          .position = {-1.3451121F, -3.8941395F, 2.2300808F},
                          .orientation = {-5, 0, 0, -3}};
  const Body<float> triangle{.shape = Triangle<float>{{-1.4610823F, -1.7616553F, -2.5e-6F},
                                                      {3.3998308F, -0.7946014F, 2.5e-6F},
                                                      {-2.5321021F, 0.1704859F, 0}},
                             .position = {2.5335650F, 0.4296701F, 2.2300808F},
                             .orientation = {-3, 0, 0, -3}};
  const DistanceResult<float> d = distance(plate, triangle);
  EXPECT_GT(d.lower, 0.1F);
  EXPECT_EQ(overlap(plate, triangle), Outcome::miss);
}

// A point that projects to 1e-23 of the scale has products that vanish in float: it lies on the line.
TEST(MprOverlap, APointAlmostOnTheLineIsOnIt) {
  const Body<float> high{.shape = Point<float>{},
                         .position = {3.8461538e-13F, 9.2307692e-13F, 3.4512241e10F}};
  const Body<float> turned{.shape = Point<float>{}, .orientation = {2, 3, 2, -3}};
  EXPECT_EQ(overlap(high, turned), Outcome::miss);
  EXPECT_EQ(overlap(turned, high), Outcome::miss);
}

// Near an end of an edge that is seen along a plate two edges are equally high, as rounded. The one with the
// new corner is steeper: it is the one to go on with.
TEST(MprOverlap, TheRimOfAPlateIsReached) {
  const Body<float> point{.shape = Point<float>{}, .position = {-1e-14F, 2.3528196F, 0}};
  const Body<float> plate{.shape = Cylinder<float>{2.9940009F, 9.3132257e-10F},
                          .position = {-2.9940009F, 0, 0},
                          .orientation = {8, 0, 0, -8}};
  EXPECT_EQ(overlap(point, plate), Outcome::miss);
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
    const detail::Cso<double> cso(a, b);
    const detail::Frame<double> frame(cso.direction());
    Counters counters;
    const auto search = detail::enter_line(cso, frame, kInfinity<double>, 1e-15, 256, counters);
    if (std::abs(leave - enter) < 1e-9) continue;
    if (enter > leave) {
      ++missed;
      EXPECT_EQ(search.state, detail::PortalSearch<double>::State::missed) << round;
      EXPECT_LT(search.n.dot(cso.support(search.n).w), 0);
      EXPECT_NEAR(search.n.dot(frame.e3), 0, 4 * kUnitRoundoff<double>);
    } else {
      ++entered;
      ASSERT_EQ(search.state, detail::PortalSearch<double>::State::entered) << round;
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
    const detail::Cso<double> cso(box, ray);
    Counters counters;
    const auto search = detail::enter_line(cso, detail::Frame<double>(cso.direction()), kInfinity<double>,
                                           1e-15, 256, counters);
    ASSERT_EQ(search.state, detail::PortalSearch<double>::State::entered) << from.transpose();
    EXPECT_EQ(cso.to_time(search.upper / cso.direction().norm()), 0.5) << from.transpose();
  }
}

}  // namespace
}  // namespace graze
