// The quick search for the distance of two placed bodies, beside the robust one and beside every vertex.
#include <gtest/gtest.h>

#include <algorithm>

#include <graze/detail/rotating/nearest.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

// The farthest of a box's eight corners along n, of A - B with B at d.
double farthest(const Vec3<double>& half_a, const Vec3<double>& half_b, const Vec3<double>& d,
                const Vec3<double>& n) {
  return n.cwiseAbs().dot(half_a + half_b) - n.dot(d);
}

struct Boxes {
  RotatingBody<double> a, b;
  detail::MovingPair pair;
  Vec3<double> half_a, half_b;

  Boxes(const Vec3<double>& of_a, const Vec3<double>& of_b, const Vec3<double>& d)
      : a{.body = {.shape = Box<double>{of_a}}, .rotation = {0, 0, 1}},
        b{.body = {.shape = Box<double>{of_b}, .position = d}, .rotation = {0, 0, 1}},
        pair(a, b, 0),
        half_a(of_a),
        half_b(of_b) {}
  Boxes(const Boxes&) = delete;
};

TEST(FastNearest, ItsBoundsAreThoseOfBoxesSideBySide) {
  Draw draw{311};
  int apart = 0, inside = 0, quick = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto half = [&] {
      return Vec3<double>(draw.between(0.5, 1), draw.between(0.5, 1), draw.between(0.5, 1));
    };
    const Vec3<double> h_a = half(), h_b = half(), d = draw.vector<double>(3);
    const Boxes boxes(h_a, h_b, d);
    const double unit = power_of_two(-boxes.pair.cso().length_exponent());
    // The distance of boxes along the axes is that of the gaps along each.
    const double truth = unit * (d.cwiseAbs() - h_a - h_b).cwiseMax(0).norm();
    detail::Simplex<double> simplex;
    detail::Distance<double> found;
    Counters counters;
    const double gap = 0x1p-40, noise = boxes.pair.error();
    if (!detail::fast_distance(boxes.pair.cso(), simplex, gap, 0, 256, found, counters)) continue;
    ++quick;
    EXPECT_LE(found.lower, truth + noise) << round;
    double sum = 0;
    Vec3<double> v = Vec3<double>::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) {
      EXPECT_GE(simplex.lambda[i], 0) << round;
      sum += simplex.lambda[i];
      v += simplex.lambda[i] * simplex.point[i].w;
    }
    EXPECT_NEAR(sum, 1, 8 * kUnitRoundoff<double>) << round;
    EXPECT_NEAR(v.norm(), found.upper, noise) << round;
    if (simplex.size == 4) {
      ++inside;
      EXPECT_EQ(truth, 0) << round;
      continue;
    }
    ++apart;
    EXPECT_GE(found.upper, truth - noise) << round;
    // Known to the requested gap, or to a sixteenth of itself.
    EXPECT_LE(found.upper - found.lower, std::max(gap, found.lower / 16)) << round;
    EXPECT_NEAR(found.n.norm(), 1, 4 * kUnitRoundoff<double>) << round;
    EXPECT_LE(found.lower, -unit * farthest(h_a, h_b, d, found.n) + noise) << round;
  }
  EXPECT_GT(apart, 800);
  EXPECT_GT(inside, 100);
  EXPECT_GT(quick, 1800);
}

// With a warm start from another time, and where the fast search gives up, the result is that of the robust
// search.
TEST(FastNearest, FromAnotherTimeItFindsTheSame) {
  Draw draw{312};
  for (int round = 0; round < 300; ++round) {
    RotatingBody<double> a{.body = {.shape = Box<double>{{1, 0.75, 0.5}}},
                           .rotation = draw.vector<double>(2)};
    RotatingBody<double> b{.body = {.shape = Box<double>{{0.5, 0.5, 1}}, .position = draw.vector<double>(3)},
                           .rotation = draw.vector<double>(2)};
    detail::MovingPair pair(a, b, 0);
    Counters counters;
    const double stop = 16 * pair.error();
    const detail::Nearest before = detail::nearest(pair, {}, 0, stop, 256, counters);
    pair.place(draw.between(0, 1));
    const detail::Nearest warm = detail::nearest(pair, before.simplex, 0, stop, 256, counters);
    detail::Simplex<double> simplex;
    const detail::Distance<double> robust = detail::gjk_distance(
        pair.cso(), Vec3<double>(Vec3<double>::Zero()), simplex, stop / 16, 0.0, 256, counters);
    EXPECT_LE(warm.gap, robust.upper) << round;
    EXPECT_GE(warm.apart, robust.lower) << round;
    if (robust.lower > stop) {
      // upper is not below the distance, and lower within a sixteenth of itself of it.
      EXPECT_GE(warm.gap, robust.lower * (16.0 / 17) - stop) << round;
    }
  }
}

// Three corners at 1e-8 of the origin and one far from it: the volume has a sign, but the weights have hardly
// a digit. Weights confirm every claim that the origin is inside. If they leave it far from the origin,
// the search gives up.
TEST(FastNearest, ATetrahedronWithoutWeightsIsGivenUp) {
  Draw draw{313};
  const Boxes boxes({1, 1, 1}, {1, 1, 1}, {0, 0, 0});
  int inside = 0, given_up = 0;
  for (int round = 0; round < 4000; ++round) {
    detail::Simplex<double> simplex;
    for (int i = 0; i < 3; ++i) {
      detail::CsoPoint<double> near;
      near.w = 1e-8 * draw.vector<double>(1);
      simplex.add(near);
    }
    detail::CsoPoint<double> far;
    far.w = draw.vector<double>(0.5);
    simplex.add(far);
    detail::Distance<double> found;
    Counters counters;
    if (detail::FastClosest(simplex).size() != 4) continue;
    if (!detail::fast_distance(boxes.pair.cso(), simplex, 0, 0, 0, found, counters)) {
      ++given_up;
      continue;
    }
    ++inside;
    EXPECT_LE(detail::combination(simplex).norm(), 0x1p-46) << round;
  }
  EXPECT_GT(given_up, 20);
}

}  // namespace
}  // namespace graze
