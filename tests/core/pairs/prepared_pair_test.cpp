// One body of a quick search: few points, where they are kept and which is farthest.
#include <gtest/gtest.h>

#include <graze/detail/pairs/prepared_pair.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

constexpr double kU = kUnitRoundoff<double>;

std::vector<V> points_of(const Shape<double>& shape) {
  if (const auto* segment = std::get_if<Segment<double>>(&shape)) return {segment->a, segment->b};
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape))
    return {triangle->a, triangle->b, triangle->c};
  return {V::Zero()};
}
Shape<double> few(Draw& draw, int kind, const V& place, double size) {
  const auto point = [&] { return V(place + size * draw.vector<double>(1)); };
  if (kind % 3 == 0) return Segment<double>{point(), point()};
  if (kind % 3 == 1) return Triangle<double>{point(), point(), point()};
  return Point<double>{};
}

// Nothing of where the points are is lost, and the bounds hold them, however far out they lie.
TEST(PreparedCore, FewPointsAreWhereTheyAre) {
  Draw draw{81};
  int centered = 0, kept = 0;
  for (int round = 0; round < 3000; ++round) {
    const double out = round % 2 == 0 ? 0.0 : std::ldexp(1.0, int(draw.bits() % 60) - 4);
    const Shape<double> shape = few(draw, round, V(out * draw.vector<double>(1)), 1);
    const Body<double> body{.shape = shape, .orientation = draw.turn<double>()};
    const detail::PreparedCore<double> core(body);
    const V center = core.center().vector();
    (center == V::Zero() ? kept : centered) += 1;
    const std::vector<V> points = points_of(shape);
    double most = 0, apart = 0;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const V own = core.own(k).vector();
      EXPECT_EQ(V(own + center), points[k]);
      EXPECT_EQ(own, V(points[k] - center));
      EXPECT_LE(own.norm(), core.reach());
      most = std::max(most, own.cwiseAbs().maxCoeff());
      for (const V& other : points) apart = std::max(apart, (points[k] - other).cwiseAbs().maxCoeff());
    }
    EXPECT_GE(core.size(), most * (1 - 4 * kU));
    // Within 3.5 times the larger half extent: the noise of contact is measured by this.
    EXPECT_LE(core.size(), 3.5 * apart / 2 * (1 + 8 * kU));
  }
  EXPECT_GT(centered, 500);
  EXPECT_GT(kept, 1000);
}

// A triangle that is thin along one axis, and lies aside along it, has no centre to rotate.
TEST(PreparedCore, AThinTriangleNearTheOriginHasNoCentre) {
  const Body<double> body{.shape = Triangle<double>{{0.3, 1, 0}, {0.31, -1, 0.5}, {0.3, 0, -0.5}}};
  EXPECT_EQ(detail::PreparedCore<double>(body).center().vector(), V::Zero());
}

// support() finds a point that is farthest within 16 u, ties or not.
TEST(PreparedCore, OfFewPointsTheFarthestIsFound) {
  Draw draw{82};
  for (int round = 0; round < 6000; ++round) {
    Shape<double> shape = few(draw, round, V::Zero(), 1);
    V n = draw.vector<double>(1);
    if (round % 4 == 0) {
      // Small integers: many tie.
      const auto small = [&] { return V(draw.vector<double>(3).array().round()); };
      shape = Triangle<double>{small(), small(), small()};
      n = small();
    }
    if (n == V::Zero()) continue;
    const Body<double> body{.shape = shape};
    const detail::PreparedCore<double> core(body);
    const std::vector<V> points = points_of(shape);
    std::uint32_t vertex = 99;
    const V found = core.support(detail::triple(n), vertex).vector();
    ASSERT_LT(vertex, points.size());
    EXPECT_EQ(found, core.own(vertex).vector());
    for (const V& x : points)
      EXPECT_GE(n.dot(found), n.dot(V(x - core.center().vector())) - 16 * kU * core.reach() * n.norm());
  }
}

}  // namespace
}  // namespace graze
