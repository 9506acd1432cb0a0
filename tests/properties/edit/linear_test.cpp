// The exact edits that the laws of motion and symmetry ask about: each is the problem it says it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "corpus/support_value.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/integer_turn.hpp"
#include "properties/edit/motion.hpp"
#include "properties/edit/same_body.hpp"
#include "properties/generate/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {
namespace {

using corpus::Case;

// Two unit cubes, three apart, that meet at t = 2 and part at t = 6.
Case cubes() {
  Case problem;
  problem.a.shape = problem.b.shape = Box<double>{{0.5, 0.5, 0.5}};
  problem.b.position = {2, 0, 0};
  problem.b.displacement = {-0.5, 0, 0};
  problem.t_max = 8;
  return problem;
}

TEST(MotionEdit, ALaterStartSeesContactSooner) {
  const auto later = started_at(cubes(), 1.5);
  ASSERT_TRUE(later);
  EXPECT_EQ(truth_of(*later).toi_lower(), 0.5);
  EXPECT_FALSE(started_at(cubes(), 0.1));  // 0.1 * 0.5 from 2 is no double
}

TEST(MotionEdit, TheWayBackMeetsTheOtherEnd) {
  const auto back = reversed(cubes());
  ASSERT_TRUE(back);
  EXPECT_EQ(truth_of(*back).toi_lower(), 2);  // 8 - 6
  const auto there = reversed(*back);
  ASSERT_TRUE(there);
  EXPECT_TRUE(same_input(*there, cubes()));
  Case ray = cubes();
  ray.t_max = kInfinity<double>;
  EXPECT_FALSE(reversed(ray));
}

TEST(MotionEdit, AStartFartherBackDelaysContactByAsMuch) {
  for (std::uint64_t salt = 0; salt < 8; ++salt) {
    const auto longer = extended(cubes(), salt);
    ASSERT_TRUE(longer);
    EXPECT_EQ(truth_of(longer->longer).toi_lower(), 2 + longer->by);
    EXPECT_EQ(longer->longer.t_max, 8 + longer->by);
  }
}

TEST(MotionEdit, ASharedVelocityLeavesTheDifference) {
  bool rested = false, large = false;
  for (std::uint64_t salt = 0; salt < 32; ++salt) {
    const auto moved = moved_together(cubes(), salt);
    ASSERT_TRUE(moved);
    EXPECT_EQ(velocity(*moved), velocity(cubes()));
    EXPECT_NE(moved->a.displacement, cubes().a.displacement);
    large = large || moved->a.displacement.cwiseAbs().maxCoeff() == 0x1p20;
  }
  Case fine = cubes();
  fine.b.displacement[0] = 0x1.23456789abcdep-40;  // nothing can be added exactly but its own
  for (std::uint64_t salt = 0; salt < 32; ++salt) {
    const auto moved = moved_together(fine, salt);
    ASSERT_TRUE(moved);
    EXPECT_EQ(velocity(*moved), velocity(fine));
    rested = rested || moved->b.displacement[0] == 0;
  }
  EXPECT_TRUE(rested);
  EXPECT_TRUE(large);
}

TEST(IntegerTurn, ThereAre24PermutationsOfTheAxes) {
  std::vector<std::vector<double>> images;
  Case problem;
  problem.a.shape = Segment<double>{{1, 2, 3}, {4, 8, 16}};
  for (std::uint64_t k = 0; k < 24; ++k) {
    const auto turned = turned_by(problem, axis_permutation(k), true);
    ASSERT_TRUE(turned);
    const auto& segment = std::get<Segment<double>>(turned->a.shape);
    // With stretching the lengths grow by |p|^2. Without it the numbers are the same in another order and
    // with signs.
    const double norm = segment.a.norm() / Vec3<double>(1, 2, 3).norm();
    EXPECT_NEAR(std::abs(segment.a.dot(segment.b)), 68 * norm * norm, 1e-9);
    images.push_back({segment.a[0] / norm, segment.a[1] / norm, segment.a[2] / norm});
  }
  std::sort(images.begin(), images.end());
  EXPECT_EQ(std::adjacent_find(
                images.begin(), images.end(),
                [](const auto& l, const auto& r) {
                  return std::abs(l[0] - r[0]) + std::abs(l[1] - r[1]) + std::abs(l[2] - r[2]) < 1e-9;
                }),
            images.end());
}

TEST(IntegerTurn, VerticesOrOrientationTurnedAreOneBody) {
  corpus::Random random(11);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const Case problem = draw_case(random, i % 100);
    for (std::uint64_t k = 0; k < 8; ++k) {
      const auto in_place = turned_by(problem, pythagorean(k), true),
                 by_pose = turned_by(problem, pythagorean(k), false);
      if (!in_place || !by_pose || same_input(*in_place, *by_pose)) continue;
      const Vec3<double> n(1 + i % 3, -2 + i % 5, 1.5);
      for (const auto body : {&Case::a, &Case::b}) {
        const Body<double>&one = (*in_place).*body, &two = (*by_pose).*body;
        const corpus::Bounds left = corpus::bounds(one.shape, one.orientation),
                             right = corpus::bounds(two.shape, two.orientation);
        // The size of the farthest point, also for a body far from its origin.
        const double size = left.high.cwiseAbs().cwiseMax(left.low.cwiseAbs()).maxCoeff();
        EXPECT_LE((left.high - right.high).cwiseAbs().maxCoeff(), 1e-14 * size);
        EXPECT_LE((left.low - right.low).cwiseAbs().maxCoeff(), 1e-14 * size);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

// By support values along many directions.
void expect_same_set(const Shape<double>& one, const Shape<double>& two) {
  for (int i = 0; i < 40; ++i) {
    const Quaternion<double> q{2.0 + i % 3, i % 7 - 3.0, i % 5 - 2.0, i % 11 - 5.0};
    const corpus::Bounds left = corpus::bounds(one, q), right = corpus::bounds(two, q);
    const double size = std::max({left.high.cwiseAbs().maxCoeff(), left.low.cwiseAbs().maxCoeff()});
    EXPECT_LE((left.high - right.high).cwiseAbs().maxCoeff(), 1e-13 * size);
    EXPECT_LE((left.low - right.low).cwiseAbs().maxCoeff(), 1e-13 * size);
  }
}

TEST(SameBody, EveryDescriptionIsOfTheSameSet) {
  using Edit = std::optional<Shape<double>> (*)(const Shape<double>&, std::uint64_t);
  corpus::Random random(5);
  for (const Edit edit : {&reordered, &with_redundant_points, &described_otherwise}) {
    std::vector<std::size_t> kinds;
    for (int i = 0; i < 600; ++i) {
      const Case problem = draw_case(random, i % 100);
      const auto other = edit(problem.a.shape, static_cast<std::uint64_t>(i));
      if (!other) continue;
      expect_same_set(problem.a.shape, *other);
      kinds.push_back(problem.a.shape.index());
    }
    EXPECT_GT(kinds.size(), 150u);
    std::sort(kinds.begin(), kinds.end());
    EXPECT_GE(std::unique(kinds.begin(), kinds.end()) - kinds.begin(), 4);
  }
}

TEST(SameBody, AHullOfVerticesHasOtherNumbers) {
  const Shape<double> tetrahedron = Hull<double>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const auto shuffled = reordered(tetrahedron, 2), fuller = with_redundant_points(tetrahedron, 1);
  ASSERT_TRUE(shuffled && fuller);
  EXPECT_GE(std::get<Hull<double>>(*shuffled).size(), 4u);
  EXPECT_GT(std::get<Hull<double>>(*fuller).size(), 4u);
  EXPECT_FALSE(with_redundant_points(Point<double>{}, 0));
  EXPECT_FALSE(reordered(Sphere<double>{1}, 0));
}

}  // namespace
}  // namespace graze::law
