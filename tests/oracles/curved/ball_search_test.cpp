// Nearest points without a shift: where the origin is inside the set, the search ends with four points.
#include "oracles/curved/ball_search.hpp"

#include <gtest/gtest.h>

#include <random>

namespace graze::oracle {
namespace {

using Vec = Vec3<double>;

// The hull of points, as a set in balls.
ConvexSet hull(std::vector<Vec> points) {
  return [points = std::move(points)](const BallVec& n) {
    CsoPoint best;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const BallVec point(points[i]);
      const Ball reach = dot(n, point);
      if (i > 0 && !mid_less(best.reach, reach)) continue;
      best.reach = reach;
      best.point = point;
    }
    return best;
  };
}

TEST(BallSearch, NearestWithoutAShift) {
  std::mt19937_64 engine(5);
  const auto coordinate = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; };
  int around = 0, apart = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Vec> points;
    const Vec middle = Vec(coordinate(), coordinate(), coordinate()) / (1 + round % 4);
    for (int i = 0; i < 4 + round % 9; ++i)
      points.push_back(middle + Vec(coordinate(), coordinate(), coordinate()));
    const WorkingPrecision working(round % 2 == 0 ? 128 : 330);
    const Nearest3 found = nearest(hull(points), BallVec(), {.relative = Ball(1e-12)});
    EXPECT_TRUE(certainly_at_most(found.lower, found.upper));
    ASSERT_LE(found.inner.points.size(), 4U);
    if (found.around) {
      ++around;
      ASSERT_EQ(found.inner.points.size(), 4U);
      // The four points hold the origin: proved from them alone.
      const Depth3 depth = least_depth(hull(points), found.inner.points, {.relative = Ball(1e-6)});
      EXPECT_TRUE(depth.lower.is_positive());
      EXPECT_LT(found.upper.mid_double(), 1e-25);
    } else {
      ++apart;
      EXPECT_TRUE(found.lower.is_positive());
      EXPECT_GT(found.lower.mid_double(), found.upper.mid_double() * (1 - 1e-11));
    }
  }
  EXPECT_GT(around, 500);
  EXPECT_GT(apart, 500);
}

// The origin on a face, an edge, a vertex: x is exactly zero, or rounding.
TEST(BallSearch, NearestWithoutAShiftOnTheBoundary) {
  std::vector<Vec> cube;
  for (unsigned k = 0; k < 8; ++k) cube.emplace_back(k & 1u ? 2 : 0, k & 2u ? 2 : 0, k & 4u ? 2 : 0);
  for (const Vec& at : {Vec(0, 0, 0), Vec(2, 1, 2), Vec(0.3, 1.7, 2), Vec(1, 1, 1)}) {
    std::vector<Vec> points = cube;
    for (Vec& x : points) x -= at;
    const Nearest3 found = nearest(hull(points), BallVec(), {.relative = Ball(1e-12)});
    EXPECT_FALSE(found.lower.is_positive());
    EXPECT_LT(found.upper.mid_double(), 1e-15);
    EXPECT_LE(found.inner.points.size(), 4U);
  }
}

}  // namespace
}  // namespace graze::oracle
