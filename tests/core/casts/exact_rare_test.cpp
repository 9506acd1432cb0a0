// Rare inputs of exact casts: a C that has no area seen along the path, bodies at rest that touch, slivers
// that are rotated, and numbers that outgrow their room in the queries beside the cast.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <graze/cast.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/swept_overlap.hpp>
#include <numbers>

#include <graze/detail/queries/exact_queries.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

constexpr double kU = kUnitRoundoff<double>;

CastResult<double> exactly(const Body<double>& a, const Body<double>& b,
                           StartPolicy policy = StartPolicy::report) {
  return cast_exact(a, b, {.tier = Tier::exact, .request = Request::everything, .start_policy = policy});
}

// --- C on a line along the path, seen as a point

TEST(ExactRare, SegmentsOnOneLineMeetEndToEnd) {
  const Body<double> a{.shape = Segment<double>{{-1, 0, 0}, {1, 0, 0}}};
  for (const double side : {1.0, -1.0}) {
    for (const bool point : {true, false}) {
      Body<double> b{
          .shape = Point<double>{}, .position = {4 * side, 0, 0}, .displacement = {-8 * side, 0, 0}};
      if (!point) b.shape = Segment<double>{{0.5, 0, 0}, {-0.5, 0, 0}};
      const double toi = (point ? 3 : 2.5) / 8;
      const auto r = exactly(a, b);
      ASSERT_EQ(r.outcome, Outcome::hit);
      EXPECT_EQ(r.toi_lower, toi);
      EXPECT_EQ(r.toi_upper, toi);
      const auto whole = line_exact(a, b);
      ASSERT_EQ(whole.outcome, Outcome::hit);
      EXPECT_EQ(whole.in_upper, toi);
      EXPECT_EQ(whole.out_lower, (point ? 5 : 5.5) / 8);
      b.displacement = -b.displacement;
      EXPECT_EQ(exactly(a, b).outcome, Outcome::miss);
    }
  }
}

// --- C in a plane that holds the path, seen as a segment

TEST(ExactRare, WhatSlidesInItsOwnPlaneIsPassedOver) {
  const Body<double> a{.shape = Triangle<double>{{-2, -1, 0}, {2, -1, 0}, {0, 3, 0}}};
  Draw draw{231};
  for (int round = 0; round < 50; ++round) {
    // A lattice point of the triangle's inside, so that it is in its plane exactly.
    const Body<double> b{.shape = Point<double>{},
                         .position = {draw.between(-0.5, 0.5), draw.between(-0.5, 0.5), 0},
                         .displacement = {draw.between(-9, 9), draw.between(-9, 9), 0}};
    EXPECT_EQ(exactly(a, b).outcome, Outcome::initially_overlapping) << round;
    const auto r = exactly(a, b, StartPolicy::pass_over);
    EXPECT_EQ(r.outcome, Outcome::miss) << round;
    EXPECT_TRUE(r.passed_over) << round;
    // Through the plane it goes out of a flat C at once.
    Body<double> through = b;
    through.displacement[2] = 1;
    EXPECT_TRUE(exactly(a, through, StartPolicy::pass_over).passed_over) << round;
  }
}

// The corner of C that is seen on the line, with the first two corners of the walk at equal distances.
TEST(ExactRare, ACornerOfAFlatCOnThePathIsMet) {
  const Body<double> a{.shape = Triangle<double>{{-1, 1, 0}, {-1, -1, 0}, {1, 0, 0}}};
  const Body<double> b{.shape = Point<double>{}, .position = {4, 0, 0}, .displacement = {-8, 0, 0}};
  const auto r = exactly(a, b);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_EQ(r.toi_lower, 3.0 / 8);
  EXPECT_EQ(r.toi_upper, 3.0 / 8);
  const auto whole = line_exact(a, b);
  EXPECT_EQ(whole.in_lower, 3.0 / 8);
  EXPECT_EQ(whole.out_upper, 5.0 / 8);
}

// --- at rest

// Whichever way the line from the origin to about the middle of C runs: the origin is on the border.
TEST(ExactRare, BodiesAtRestThatTouchArePassedOver) {
  const Body<double> a{.shape = Box<double>{{1, 1, 1}}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      for (const double own : {-1.5, 0.0, 1.5, 2.5}) {
        // A box between 1 and 3 along `axis`, about `own` in its own frame.
        std::vector<V> corners;
        for (int i = 0; i < 8; ++i) {
          V x(i & 1 ? 0.75 : -0.75, i & 2 ? 0.75 : -0.75, i & 4 ? 0.75 : -0.75);
          x[axis] = side * (own + (x[axis] > 0 ? 1 : -1));
          corners.push_back(x);
        }
        Body<double> b{.shape = Hull<double>{std::span<const V>(corners)}};
        b.position[axis] = side * (2 - own);
        EXPECT_EQ(exactly(a, b).outcome, Outcome::initially_overlapping);
        EXPECT_TRUE(exactly(a, b, StartPolicy::pass_over).passed_over) << axis << ' ' << side << ' ' << own;
        b.position[axis] -= side / 8;
        EXPECT_FALSE(exactly(a, b, StartPolicy::pass_over).passed_over) << axis << ' ' << side << ' ' << own;
      }
    }
  }
}

// --- rotated slivers

// A sliver 2^31 long and 2^-31 high, no edge of it short, turned by a quaternion of full length: its normal
// is the turned z axis. The point that meets it is given in the same axes, so that it is in its plane
// exactly.
TEST(ExactRare, TheNormalOfATurnedSliverIsExact) {
  using L = long double;
  Draw draw{233};
  const double l = 0x1p31;
  for (int round = 0; round < 20; ++round) {
    const Quaternion<double> q = draw.turn<double>();
    const L w = q.w, x = q.x, y = q.y, z = q.z, size = w * w + x * x + y * y + z * z;
    // The third column of R, within a few 2^-64.
    const V n(static_cast<double>(2 * (x * z + w * y) / size),
              static_cast<double>(2 * (y * z - w * x) / size),
              static_cast<double>((w * w - x * x - y * y + z * z) / size));
    const Body<double> a{.shape = Triangle<double>{{0, 0, 0}, {l, 1, 0}, {2 * l + 1, 2, 0}},
                         .orientation = q};
    const std::vector<V> middle = {V(l + 0.25, 1, 0)};
    for (const double side : {1.0, -1.0}) {
      const Body<double> b{.shape = Hull<double>{std::span<const V>(middle)},
                           .position = side * n,
                           .orientation = q,
                           .displacement = -2 * side * n};
      const auto r = exactly(a, b);
      ASSERT_EQ(r.outcome, Outcome::hit);
      // Within 2 u of the true one, which n is within u of.
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(r.normal[i], side * n[i], 3 * kU) << i;
    }
  }
}

// --- too complex

// Every query reports numbers that outgrow their room.
TEST(ExactRare, AQueryTooComplexIsRefused) {
  Draw draw{232};
  int refused = 0;
  for (int round = 0; round < 20; ++round) {
    const auto nested = [&](Shape<double> shape) {
      for (int level = 0; level < 15; ++level)
        shape = posed<double>(std::move(shape), draw.vector<double>(0.125), draw.turn<double>());
      return shape;
    };
    // Twice the same: corners of C lie at the origin, and a path along an edge of C meets ties only.
    const Shape<double> one = nested(Box<double>{{1, 0.5, 0.25}});
    const Body<double> a{.shape = one}, b{.shape = one, .displacement = {1, 0, 0}};
    const auto overlap = overlap_exact(a, b);
    const auto swept = swept_overlap_exact(a, b);
    const auto whole = line_exact(a, b);
    for (const auto& [outcome, invalid] :
         {std::pair(overlap.outcome, overlap.invalid), std::pair(swept.outcome, swept.invalid),
          std::pair(whole.outcome, whole.invalid)}) {
      EXPECT_EQ(outcome == Outcome::invalid_input, invalid == Invalid::too_complex) << round;
      refused += invalid == Invalid::too_complex;
    }
  }
  EXPECT_GT(refused, 10);
}

// --- witnesses that pairs of doubles cannot tell

// A needle of 2^190 flies along itself past a sheet of 2^61: the sides of their contact are 2^-126 of what
// they are summed up from.
TEST(ExactRare, WitnessesOfANeedleTouch) {
  constexpr double kLong = 0x1p190;
  const Body<double> sheet{
      .shape = Hull<double>{{0, 0, 0.5}, {0, 0x1p61, -0.5}, {0, -0.25, -0.25}, {0, -0.25, 12.75}},
      .displacement = {52, 52, 52}};
  const Body<double> needle{.shape = Hull<double>{{1, 1, 0}, {1 - kU, 1, 0}, {kLong, kLong, kLong}},
                            .displacement = {-kLong, -kLong, -kLong}};
  const auto r = exactly(sheet, needle);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_GT(r.toi_lower, 0.5);
  EXPECT_LT(r.toi_upper, 1);
  EXPECT_LE((r.point_a - r.point_b).norm(), 64 * kU * kLong);
}

// --- weights beyond doubles

// Twenty triangles, each under 15 turns by a third of a circle about (1, 1, 1), whose weights of 12.25
// multiply to 2^1084: in pairs of doubles their directions are NaN. Turned by five whole circles they are as
// if they were not turned, and so is every answer, to the bit.
TEST(ExactRare, WeightsOfManyTurnsOutgrowDoubles) {
  Draw draw{907};
  const Quaternion<double> third{1.75, 1.75, 1.75, 1.75};
  int hits = 0;
  for (int round = 0; round < 6; ++round) {
    Sum<double> plain, turned;
    for (int part = 0; part < 20; ++part) {
      const auto corner = [&] { return Vec3<double>((draw.vector<double>(8)).array().round()); };
      const Shape<double> triangle = Hull<double>{corner(), corner(), corner()};
      Shape<double> nested = triangle;
      for (int level = 0; level < 15; ++level)
        nested = posed<double>(std::move(nested), Vec3<double>::Zero(), third);
      plain.shapes.push_back(share(triangle));
      turned.shapes.push_back(share(nested));
    }
    const Vec3<double> way = 512 * unit(draw.vector<double>(1));
    const Body<double> ball{.shape = Box<double>{{1, 2, 3}}, .position = -way, .displacement = 2 * way};
    const auto one = exactly({.shape = plain}, ball), other = exactly({.shape = turned}, ball);
    ASSERT_EQ(one.outcome, other.outcome) << round << ' ' << static_cast<int>(other.invalid);
    EXPECT_EQ(one.toi_lower, other.toi_lower) << round;
    EXPECT_EQ(one.toi_upper, other.toi_upper) << round;
    EXPECT_LE((one.normal - other.normal).cwiseAbs().maxCoeff(), 4 * kU) << round;
    hits += one.outcome == Outcome::hit;
  }
  EXPECT_GT(hits, 2);
}

// The direction of two such differences: doubles know nothing of it, and say so by a bound that is finite.
TEST(ExactRare, ADirectionBeyondDoublesIsUnknown) {
  Sum<double> turned;
  for (int part = 0; part < 20; ++part) {
    Shape<double> nested = Hull<double>{{0, 0, 0}, {1.0 + part, 2, 3}, {4, 5.0 - part, 6}};
    for (int level = 0; level < 15; ++level)
      nested = posed<double>(std::move(nested), V::Zero(), {1.75, 1.75, 1.75, 1.75});
    turned.shapes.push_back(share(nested));
  }
  const Body<double> a{.shape = turned}, b;
  const detail::exact::Scene<double> scene(a, b, 0, 0);
  const auto vertex = [](std::uint32_t k) {
    detail::exact::Vertex v{};
    v.a = k;
    return v;
  };
  constexpr std::uint32_t kLast = 3486784400;  // 3^20 - 1: the last vertex of every part
  const auto first = detail::exact::Term::difference(vertex(0), vertex(kLast)),
             second = detail::exact::Term::difference(vertex(0), vertex(kLast / 2));
  const detail::exact::Direction n = detail::exact::direction_of(scene, first, second, 1);
  EXPECT_EQ(n.approx, V::Zero());
  EXPECT_GT(n.error.minCoeff(), 1e100);
  EXPECT_LT(n.error.maxCoeff(), kInfinity<double>);
}

// --- what a term's kind does not need is not read

// The grid of a point of C's inside is that of the four vertices in it. A fifth, off every coarse grid, would
// send the tie to exact arithmetic.
TEST(ExactRare, APointOfTheInsideIsOfItsOwnVertices) {
  const Body<double> a{.shape = Hull<double>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0x1p-200, 5, 5}}};
  const Body<double> b;
  const detail::exact::Scene<double> scene(a, b, 0, 0);
  const auto vertex = [](std::uint32_t k) {
    detail::exact::Vertex v{};
    v.a = k;
    return v;
  };
  detail::exact::Term inside = detail::exact::Term::inside({vertex(0), vertex(1), vertex(2)}, vertex(3));
  inside.to = vertex(4);
  EXPECT_EQ(scene.determinant_sign(inside, inside, detail::exact::Term::point(vertex(1))), 0);
  EXPECT_EQ(scene.exact_decisions(), 0);
}

// --- many vertices of one face, in rotated bodies

// Level faces of 24 vertices each at z = -1/2 and 1/2, whose x and y are no short numbers.
Hull<double> level_prism(Draw& draw) {
  std::vector<V> corners;
  for (const double z : {-0.5, 0.5}) {
    for (int i = 0; i < 24; ++i) {
      const double angle = i * 0.26 + draw.between(0, 0.02);
      corners.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  }
  return Hull<double>(std::span<const V>(corners));
}

// The rotation drops out of what is asked about one body's face, or about two that are turned alike: every tie on
// the face is settled without exact numbers. Turned as a part of a combinator, which takes the long way, the same
// bits.
TEST(ExactRare, TheFaceOfATurnedBodyIsSettledInItsOwnAxes) {
  Draw draw{239};
  int hits = 0;
  for (int round = 0; round < 60; ++round) {
    const Hull<double> prism = level_prism(draw);
    const Quaternion<double> q = draw.turn<double>();
    const Mat3<double> r = detail::rotation_matrix(q);
    Body<double> a{.shape = prism, .orientation = q}, b;
    const bool both = round % 2 == 0;
    if (both) b = a;
    // Onto the upper face, or past it.
    b.position = r * V(draw.between(-0.9, 0.9), draw.between(-0.9, 0.9), draw.between(2, 3));
    b.displacement = r * V(draw.between(-0.2, 0.2), draw.between(-0.2, 0.2), -4);
    const auto straight = exactly(a, b);
    a.shape = posed<double>(prism, V::Zero(), q);
    if (both) b.shape = a.shape;
    a.orientation = b.orientation = {};
    const auto nested = exactly(a, b);
    ASSERT_EQ(straight.outcome, nested.outcome) << round;
    EXPECT_EQ(straight.toi_lower, nested.toi_lower) << round;
    EXPECT_EQ(straight.toi_upper, nested.toi_upper) << round;
    EXPECT_EQ(straight.counters.exact_decisions, 0) << round;
    if (straight.outcome != Outcome::hit) continue;
    ++hits;
    EXPECT_GT(nested.counters.exact_decisions, 10) << round;
  }
  EXPECT_GT(hits, 20);
}

// A combinator's vertices are rounded in its own axes: of them nothing is taken for level that is not.
TEST(ExactRare, ThePartsOfACombinatorAreNotTakenForLeaves) {
  Draw draw{241};
  for (int round = 0; round < 60; ++round) {
    const Quaternion<double> q = draw.turn<double>(), p = draw.turn<double>();
    const double thin = std::ldexp(1.0, -round);
    const Box<double> box{{1, 1, thin}};
    Body<double> a{.shape = posed<double>(box, {draw.between(-1, 1), 0, 0}, p), .orientation = q}, b;
    b.position = {draw.between(-0.5, 0.5), draw.between(-0.5, 0.5), 4};
    b.displacement = {0, 0, -8};
    const auto r = exactly(a, b);
    EXPECT_EQ(r.invalid, Invalid::none) << round;
    EXPECT_NE(r.outcome, Outcome::invalid_input) << round;
  }
}

// --- thousands of vertices within rounding of the last plane

// Two discs whose caps are parallel except for the last bits, as one orientation is the other's over its
// length. The walk takes the farthest of the vertices beyond the portal's plane. Any of them would be
// correct, but would cost hundreds of steps.
TEST(ExactRare, CapsThatAreNearlyParallelTakeFewSteps) {
  Draw draw{37};
  std::vector<V> disc;
  constexpr int kCorners = 512;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    for (const double z : {-0.5, 0.5}) disc.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  const Hull<double> hull{std::span<const V>(disc)};
  for (int round = 0; round < 20; ++round) {
    const Quaternion<double> q = draw.turn<double>();
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) * 1.1;
    const Quaternion<double> other{q.w / length, q.x / length, q.y / length, q.z / length};
    const Eigen::Quaterniond turn = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
    const Body<double> a{.shape = hull, .orientation = q};
    const Body<double> b{.shape = hull,
                         .position = turn * V(draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), 3),
                         .orientation = other,
                         .displacement = turn * V(0, 0, -4)};
    const auto r = exactly(a, b);
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_NEAR(r.toi_lower, 0.5, 1e-12);  // 2 of the way of 4, within the rounding of pose and motion
    EXPECT_LE(r.counters.portal_steps, 40) << round;
  }
}

// q and -q are one rotation: what ties as it stands costs no exact arithmetic.
TEST(ExactRare, OppositeQuaternionsAreOneRotation) {
  const Quaternion<double> q{0.8, 0.1, -0.3, 0.5}, minus{-0.8, -0.1, 0.3, -0.5};
  const Body<double> a{.shape = Box<double>{{1, 1, 1}}, .orientation = q};
  Body<double> b{.shape = Box<double>{{0.5, 0.5, 0.5}},
                 .position = {0.25, 0, 5},
                 .orientation = q,
                 .displacement = {0, 0, -5}};
  const auto same = exactly(a, b);
  b.orientation = minus;
  const auto r = exactly(a, b);
  EXPECT_EQ(r.outcome, same.outcome);
  EXPECT_EQ(r.toi_lower, same.toi_lower);
  EXPECT_EQ(r.counters.exact_decisions, same.counters.exact_decisions);
  EXPECT_EQ(r.counters.supports, same.counters.supports);
}

}  // namespace
}  // namespace graze
