// Prepared bodies and starts: the same answers from both, and no start, however wrong, that costs a guarantee.
#include <gtest/gtest.h>

#include <graze/distance.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

template <Scalar S>
Shape<S> polytope(Draw& draw, int kind) {
  const auto points = [&](int count) {
    std::vector<Vec3<S>> out;
    for (int i = 0; i < count; ++i) out.push_back(draw.vector<S>(1));
    return out;
  };
  switch (kind % 5) {
    case 0:
      return Box<S>{draw.vector<S>(1).cwiseAbs()};
    case 1:
      return Hull<S>(points(4 + kind % 9));
    case 2: {
      const auto p = points(2);
      return Segment<S>{p[0], p[1]};
    }
    case 3: {
      const auto p = points(3);
      return Triangle<S>{p[0], p[1], p[2]};
    }
    default:
      return Hull<S>(points(20));
  }
}

template <Scalar S>
struct Two {
  Body<S> a, b;
};
template <Scalar S>
Two<S> two(Draw& draw, int round) {
  Two<S> out;
  out.a = {.shape = polytope<S>(draw, round), .position = draw.vector<S>(1), .orientation = draw.turn<S>()};
  out.b = {
      .shape = polytope<S>(draw, round / 5), .position = draw.vector<S>(1.5), .orientation = draw.turn<S>()};
  return out;
}

template <class S>
class Prepares : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Prepares, Scalars, );

TYPED_TEST(Prepares, PreparedBodiesAnswerToTheBit) {
  using S = TypeParam;
  Draw draw{3};
  int contacts = 0;
  for (int round = 0; round < 500; ++round) {
    auto [a, b] = two<S>(draw, round);
    if (round % 10 == 9) b.shape = Sphere<S>{S(0.5)};  // prepared for nothing, and answered all the same
    const Prepared<S> p(a), q(b);
    EXPECT_EQ(p.invalid(), Invalid::none);
    const auto mpr = overlap_mpr(a, b), mpr_prepared = overlap_mpr(p, q);
    EXPECT_EQ(mpr.outcome, mpr_prepared.outcome);
    EXPECT_EQ(mpr.normal, mpr_prepared.normal);
    EXPECT_EQ(mpr.counters.supports, mpr_prepared.counters.supports);
    const auto gjk = overlap_gjk(a, b), gjk_prepared = overlap_gjk(p, q);
    EXPECT_EQ(gjk.outcome, gjk_prepared.outcome);
    EXPECT_EQ(gjk.normal, gjk_prepared.normal);
    const auto d = distance(a, b), d_prepared = distance(p, q);
    EXPECT_EQ(d.lower, d_prepared.lower);
    EXPECT_EQ(d.upper, d_prepared.upper);
    EXPECT_EQ(d.normal, d_prepared.normal);
    EXPECT_EQ(d.point_a, d_prepared.point_a);
    EXPECT_EQ(d.point_b, d_prepared.point_b);
    const auto depth = penetration(a, b), depth_prepared = penetration(p, q);
    EXPECT_EQ(depth.outcome, depth_prepared.outcome);
    EXPECT_EQ(depth.upper, depth_prepared.upper);
    EXPECT_EQ(depth.normal, depth_prepared.normal);
    EXPECT_EQ(depth.point_a, depth_prepared.point_a);
    contacts += mpr.outcome == Outcome::initially_overlapping;
  }
  EXPECT_GT(contacts, 50);
  EXPECT_LT(contacts, 450);
}

TYPED_TEST(Prepares, WhatIsRefusedIsRefusedPrepared) {
  using S = TypeParam;
  const Body<S> good{.shape = Box<S>{{1, 1, 1}}};
  const Body<S> bad{.shape = Box<S>{{1, -1, 1}}};
  const Prepared<S> p(good), q(bad);
  EXPECT_EQ(q.invalid(), Invalid::negative_extent);
  EXPECT_EQ(overlap_mpr(p, q).invalid_at.body, InvalidBody::b);
  EXPECT_EQ(overlap_gjk(q, p).invalid_at.field, InvalidField::half_extents);
  EXPECT_EQ(distance(p, q).invalid, Invalid::negative_extent);
  EXPECT_EQ(penetration(p, q).outcome, Outcome::invalid_input);
  EXPECT_EQ(distance(p, p, {.max_iterations = 0}).invalid, Invalid::bad_tolerance);
}

// Starts of the pair, of another pair, of no pair at all.
template <Scalar S>
std::vector<WarmStart> starts(Draw& draw, const WarmStart& own) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<WarmStart> out = {own, {}, {.axis = {nan, 0, 1}}, {.axis = {kInfinity<double>, 0, 0}}};
  out.push_back({.axis = Vec3<double>(1e-300, 0, 0), .size = -3});
  out.push_back({.axis = draw.vector<double>(1), .size = 1 << 30});
  out.push_back({.size = 3, .vertex_a = {0, 0, 0, 0}, .vertex_b = {0, 0, 0, 0}});
  out.push_back({.size = 4, .vertex_a = {0xffffffff, 1, 2, 3}, .vertex_b = {0, 1, 2, 3}});
  for (int size = 1; size <= 4; ++size) {
    WarmStart w{.axis = draw.vector<double>(1), .size = size};
    for (std::size_t i = 0; i < 4; ++i) {
      w.vertex_a[i] = static_cast<std::uint32_t>(draw.bits() % 9);
      w.vertex_b[i] = static_cast<std::uint32_t>(draw.bits() % 9);
    }
    out.push_back(w);
  }
  WarmStart reversed = own;
  reversed.axis = -own.axis;
  std::swap(reversed.vertex_a, reversed.vertex_b);
  out.push_back(reversed);
  return out;
}

TYPED_TEST(Prepares, NoStartCostsAGuarantee) {
  using S = TypeParam;
  Draw draw{4};
  for (int round = 0; round < 400; ++round) {
    const auto [a, b] = two<S>(draw, round);
    const auto cold = distance(a, b);
    const auto depth = penetration(a, b);
    const S scale = 16, slack = 64 * kUnitRoundoff<S> * scale;  // bodies within 8 of each other
    const bool undecided = cold.upper <= slack && !(depth.upper > slack);
    for (const WarmStart& start : starts<S>(draw, cold.warm)) {
      const auto d = distance(a, b, {.start = start});
      EXPECT_LE(d.lower, cold.upper + slack) << round;
      EXPECT_GE(d.upper, cold.lower - slack) << round;
      EXPECT_LE(d.upper - d.lower, slack) << round;
      if (d.lower > 0) {
        EXPECT_NEAR((d.point_a - d.point_b).norm(), d.upper, slack) << round;
        EXPECT_NEAR(d.normal.norm(), S(1), 8 * kUnitRoundoff<S>);
      }
      if (undecided) continue;
      const Outcome truth = cold.lower > 0 ? Outcome::miss : Outcome::initially_overlapping;
      EXPECT_EQ(overlap_mpr(a, b, start).outcome, truth) << round;
      EXPECT_EQ(overlap_gjk(a, b, start).outcome, truth) << round;
    }
  }
}

// A plate, and below it a stump whose upper corners differ in height by less than floats tell (1e-9): which of them
// is highest is no guess in the answer, whichever comes first.
TEST(FastSearches, VerticesThatFloatsTakeForEqualAreTold) {
  const Body<double> plate{.shape = Box<double>{{8, 8, 0.5}}};
  for (std::size_t high = 0; high < 8; ++high) {
    std::vector<Vec3<double>> points;
    for (std::size_t k = 0; k < 8; ++k) {
      const double turn = 0.785398 * double(k);
      points.emplace_back(std::cos(turn), std::sin(turn), k == high ? 1 + 1e-9 : 1);
      points.emplace_back(2 * std::cos(turn), 2 * std::sin(turn), -3);
    }
    Body<double> stump{.shape = Hull<double>(points), .position = {0, 0, -2}};
    const auto d = distance(plate, stump);
    EXPECT_NEAR(d.lower, 0.5 - 1e-9, 1e-14) << high;
    EXPECT_NEAR(d.upper, 0.5 - 1e-9, 1e-14) << high;
    stump.position[2] = -1.4;
    const auto p = penetration(plate, stump);
    EXPECT_NEAR(p.lower, 0.1 + 1e-9, 1e-14) << high;
    EXPECT_NEAR(p.upper, 0.1 + 1e-9, 1e-14) << high;
    // Apart, or not, by less than floats tell.
    stump.position[2] = -1.5 - 2e-9;
    EXPECT_EQ(overlap_mpr(plate, stump).outcome, Outcome::miss);
    EXPECT_EQ(overlap_gjk(plate, stump).outcome, Outcome::miss);
    stump.position[2] = -1.5 - 0.5e-9;
    EXPECT_EQ(overlap_mpr(plate, stump).outcome, Outcome::initially_overlapping);
    EXPECT_EQ(overlap_gjk(plate, stump).outcome, Outcome::initially_overlapping);
  }
}

// A hull's bounds contain every vertex and its interior point.
TEST(FastSearches, AHullKnowsItsReach) {
  Draw draw{6};
  for (const double far : {0.0, 1.0, 1e6}) {
    const Vec3<double> offset = draw.vector<double>(1) * far;
    std::vector<Vec3<double>> points;
    for (int i = 0; i < 12; ++i) points.push_back(offset + draw.vector<double>(1));
    const Hull<double> hull(points);
    for (const Vec3<double>& v : points) {
      EXPECT_LE((v - hull.center()).norm(), hull.reach_about_center());
      EXPECT_LE((v - hull.center()).cwiseAbs().maxCoeff(), hull.size_about_center() * (1 + 1e-15));
    }
    EXPECT_LE(hull.reach_about_center(), 4 * (1 + far));
    EXPECT_LT((hull.inside() + hull.center() - offset).cwiseAbs().maxCoeff(), 1);
  }
}

TEST(WarmStarts, AnswerTheSameQuestionInASupport) {
  Draw draw{5};
  int cold_supports = 0, warm_supports = 0, rounds = 0;
  for (int round = 0; round < 200; ++round) {
    auto [a, b] = two<double>(draw, round);
    const auto first = overlap_mpr(a, b);
    const auto apart = distance(a, b);
    // Nearly the same question: a step of a simulation.
    b.position += draw.vector<double>(1e-3);
    const auto again = overlap_mpr(a, b, first.warm);
    if (first.outcome == again.outcome && std::abs(apart.upper) > 0.1) {
      EXPECT_LE(again.counters.supports, 1) << round;
    }
    if (!(apart.lower > 0.1)) continue;
    ++rounds;
    cold_supports += distance(a, b).counters.supports;
    warm_supports += distance(a, b, {.start = apart.warm}).counters.supports;
  }
  EXPECT_GT(rounds, 50);
  EXPECT_LT(2 * warm_supports, cold_supports);
}

}  // namespace
}  // namespace graze
