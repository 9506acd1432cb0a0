#include <gtest/gtest.h>
#include <graze/line.hpp>

#include "tests/shared/query_truth.hpp"

namespace graze {
namespace {

using namespace test;

template <class S>
class Line : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Line, Scalars);

// Test slack, over u scale, of the distance and the depth of the path at either end.
constexpr double kSlack = 64;

TYPED_TEST(Line, BothEndsAreTheExactOnes) {
  using S = TypeParam;
  for (const Pairs pairs : {Pairs::hulls, Pairs::boxes, Pairs::lattice, Pairs::flat}) {
    Draw draw{81};
    int hits = 0, misses = 0;
    for (int round = 0; round < 400; ++round) {
      auto [a, b] = draw_pair<S>(draw, pairs, round);
      b.position += pairs == Pairs::lattice ? lattice_point<S>(draw, 2) : draw.vector<S>(1);
      b.displacement =
          pairs == Pairs::lattice || pairs == Pairs::flat ? lattice_point<S>(draw, 2) : draw.vector<S>(2);
      if (b.displacement == Vec3<S>::Zero()) continue;
      const LineResult<S> r = line(a, b);
      corpus::Case problem = case_of(a, b);
      const oracle::LinearTruth truth(problem);
      const double limit = kSlack * double(kUnitRoundoff<S>) * truth.scale().high;
      const auto interval = truth.contact_interval();
      if (!interval) {
        ++misses;
        if (r.outcome == Outcome::miss) continue;
        ASSERT_EQ(r.outcome, Outcome::hit) << name(pairs) << ' ' << round;
        EXPECT_LE(truth.distance_at(double(r.in_upper)).high, limit) << name(pairs) << ' ' << round;
        continue;
      }
      ++hits;
      // How deep the whole line goes: from far before to far after.
      if (r.outcome == Outcome::miss) {
        problem.b.position += problem.b.displacement * interval->t_in;
        problem.b.displacement *= interval->t_out - interval->t_in;
        EXPECT_LE(oracle::LinearTruth(problem).depth().high, limit) << name(pairs) << ' ' << round;
        continue;
      }
      ASSERT_EQ(r.outcome, Outcome::hit) << name(pairs) << ' ' << round;
      EXPECT_LE(r.in_lower, r.in_upper);
      EXPECT_LE(r.in_upper, r.out_lower);
      EXPECT_LE(r.out_lower, r.out_upper);
      EXPECT_LE(truth.distance_at(double(r.in_upper)).high, limit) << name(pairs) << ' ' << round;
      EXPECT_LE(truth.distance_at(double(r.out_lower)).high, limit) << name(pairs) << ' ' << round;
      EXPECT_LE(truth.distance_at(double(r.in_lower)).high, limit) << name(pairs) << ' ' << round;
      EXPECT_LE(truth.distance_at(double(r.out_upper)).high, limit) << name(pairs) << ' ' << round;
      // The parts of the line that the brackets leave out are shallow.
      for (const auto& [from, to] :
           {std::pair(interval->t_in, double(r.in_lower)), std::pair(double(r.out_upper), interval->t_out)}) {
        if (!(from < to)) continue;
        corpus::Case part = problem;
        part.b.position += part.b.displacement * from;
        part.b.displacement *= to - from;
        const oracle::LinearTruth left_out(part);
        EXPECT_LE(left_out.outcome() == Outcome::miss ? 0 : left_out.depth().high, limit)
            << name(pairs) << ' ' << round;
      }
      EXPECT_LE(r.normal_in.dot(b.displacement), limit) << name(pairs) << ' ' << round;
      EXPECT_GE(r.normal_out.dot(b.displacement), -limit) << name(pairs) << ' ' << round;
    }
    EXPECT_GT(hits, 100) << name(pairs);
    EXPECT_GT(misses, 20) << name(pairs);
  }
}

TYPED_TEST(Line, ThroughABoxFromBehindAndBefore) {
  using S = TypeParam;
  const Body<S> box{.shape = Box<S>{{1, 1, 1}}};
  for (const S at : {S(-6), S(0), S(6)}) {
    const Body<S> ray{.shape = Point<S>{}, .position = {at, 0, S(0.5)}, .displacement = {2, 0, 0}};
    const LineResult<S> r = line(box, ray);
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_EQ(r.in_lower, (-1 - at) / 2);
    EXPECT_EQ(r.in_upper, (-1 - at) / 2);
    EXPECT_EQ(r.out_lower, (1 - at) / 2);
    EXPECT_EQ(r.out_upper, (1 - at) / 2);
    EXPECT_EQ(r.normal_in, Vec3<S>(-1, 0, 0));
    EXPECT_EQ(r.normal_out, Vec3<S>(1, 0, 0));
  }
}

TYPED_TEST(Line, AtRestIsAlwaysOrNever) {
  using S = TypeParam;
  const Body<S> box{.shape = Box<S>{{1, 1, 1}}};
  const LineResult<S> always = line(box, {.shape = Sphere<S>{1}, .position = {2, 0, 0}});
  ASSERT_EQ(always.outcome, Outcome::hit);
  EXPECT_EQ(always.in_upper, -kInfinity<S>);
  EXPECT_EQ(always.out_lower, kInfinity<S>);
  const LineResult<S> never = line(box, {.shape = Sphere<S>{1}, .position = {S(2.5), 0, 0}});
  EXPECT_EQ(never.outcome, Outcome::miss);
  // It separates: h of the box and of the ball along it do not reach the offset.
  const Vec3<S> n = never.normal_in;
  EXPECT_LT(n.cwiseAbs().sum() + n.norm(), n.dot(Vec3<S>(S(2.5), 0, 0)));
}

TYPED_TEST(Line, RoundedBodiesByTheirQuadratic) {
  using S = TypeParam;
  Draw draw{82};
  int hits = 0;
  for (int round = 0; round < 300; ++round) {
    const Body<S> a{.shape = Sphere<S>{S(0.75)}};
    Body<S> b{.shape = Sphere<S>{S(0.5)}, .position = draw.vector<S>(3), .displacement = draw.vector<S>(2)};
    LineOptions<S> options;
    options.target_distance = S(0.25);
    const LineResult<S> r = line(a, b, options);
    const Vec3<double> p = widened<S>(b.position), v = widened<S>(b.displacement);
    const double half = p.dot(v), root_sq = half * half - v.squaredNorm() * (p.squaredNorm() - 1.5 * 1.5);
    if (std::abs(root_sq) < 1e-2) continue;  // grazes
    ASSERT_EQ(r.outcome, root_sq > 0 ? Outcome::hit : Outcome::miss) << round;
    if (root_sq < 0) continue;
    ++hits;
    const double root = std::sqrt(root_sq);
    // A graze of 1e-2 magnifies by |v| r / root, 60 at most.
    const double slack = 64 * 60 * double(kUnitRoundoff<S>) * 4 / v.norm();
    EXPECT_NEAR(r.in_upper, (-half - root) / v.squaredNorm(), slack) << round;
    EXPECT_NEAR(r.out_lower, (-half + root) / v.squaredNorm(), slack) << round;
  }
  EXPECT_GT(hits, 50);
}

// A hull of one point beside a body of the least floats: its own exponent says nothing.
TEST(LineRange, APointGivenAsAHullBesideTheLeastFloats) {
  const float least = 0x1p-147f;
  const Body<float> a{.shape = Cylinder<float>{4 * least, 4 * least}};
  Body<float> b{.shape = Hull<float>({Vec3<float>::Zero(), Vec3<float>::Zero()}),
                .position = {-8 * least, 0, 0},
                .displacement = {2 * least, 0, 0}};
  const auto r = line(a, b);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_NEAR(r.in_upper, 2, 1e-5);
  EXPECT_NEAR(r.out_lower, 6, 1e-5);
  b.position[1] = 16 * least;
  EXPECT_EQ(line(a, b).outcome, Outcome::miss);
}

TEST(LineDoor, BadInputIsRefused) {
  EXPECT_EQ(line<double>({.shape = Hull<double>()}, {}).invalid, Invalid::empty_hull);
  LineOptions<double> options;
  options.target_distance = -1;
  EXPECT_EQ(line<double>({}, {}, options).invalid, Invalid::bad_target);
}

TEST(LineBudget, RunningOutIsSaid) {
  Draw draw{83};
  int stalls = 0;
  for (int round = 0; round < 50; ++round) {
    const Body<double> a{.shape = draw.hull<double>(100, 1)};
    const Body<double> b{.shape = draw.hull<double>(100, 1), .displacement = draw.vector<double>(1)};
    LineOptions<double> options;
    options.max_iterations = 2;
    stalls += line(a, b, options).outcome == Outcome::not_converged;
  }
  EXPECT_GT(stalls, 25);
}

}  // namespace
}  // namespace graze
