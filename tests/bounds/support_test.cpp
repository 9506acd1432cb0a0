// Support points against balls: how far below the farthest vertex the chosen one may be, and the error of a curved
// leaf's point (leaf.hpp, scan.hpp, hull_graph.hpp). The directions make vertices tie except for last places, on hulls
// far out and on hulls that are climbed.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <graze/detail/shapes/leaf.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using oracle::WorkingPrecision;

template <Scalar S>
struct DrawnHull {
  std::vector<Vec3<S>> points;
  Ball diameter;        // of the box of the points
  Vec3<double> facing;  // half of the points tie along it, up to rounding

  // On a sphere, in a slab, or half of them in a plane above the others. Some hulls are far out.
  DrawnHull(HostileDraw& draw, std::size_t count) {
    const std::uint64_t kind = draw.below(4);
    facing = unit(draw.plain().template vector<double>(1));
    const Vec3<double> at =
        draw.chance(0.5)
            ? Vec3<double>(Vec3<double>::Zero())
            : Vec3<double>(draw.power(2, sizeof(S) == 8 ? 40 : 16) * draw.plain().template vector<double>(1));
    for (std::size_t i = 0; i < count; ++i) {
      Vec3<double> x = draw.plain().template vector<double>(1);
      if (kind == 0) x = unit(x);
      if (kind == 1) x[2] *= 0x1p-30;
      if (kind >= 2 && draw.chance(0.5)) x += (2 - x.dot(facing)) * facing;
      points.push_back((x + at).template cast<S>());
    }
    Vec3<double> low = points[0].template cast<double>(), high = low;
    for (const Vec3<S>& x : points) {
      low = low.cwiseMin(x.template cast<double>());
      high = high.cwiseMax(x.template cast<double>());
    }
    diameter = norm(BallVec(high) - BallVec(low));
  }
  // Along which two of the points are as high as doubles tell, or any.
  [[nodiscard]] Vec3<double> direction(HostileDraw& draw) const {
    const auto any = [&] { return Vec3<double>(points[draw.below(points.size())].template cast<double>()); };
    Vec3<double> n = draw.plain().template vector<double>(1);
    if (draw.chance(0.4)) return facing * draw.power(-20, 20);
    if (draw.chance(0.7)) {
      const Vec3<double> edge = any() - any();
      if (edge.norm() > 0) n = edge.cross(n);
    }
    return n.norm() > 0 ? Vec3<double>(unit(n) * draw.power(-20, 20)) : Vec3<double>(Vec3<double>::UnitX());
  }
  // How far the k-th is below the greatest.
  [[nodiscard]] Ball below(std::size_t k, const Vec3<double>& n) const {
    const BallVec along(n);
    Ball most = dot(along, BallVec(Vec3<double>(points[0].template cast<double>())));
    for (const Vec3<S>& x : points) {
      most = max(most, dot(along, BallVec(Vec3<double>(x.template cast<double>()))));
    }
    return most - dot(along, BallVec(Vec3<double>(points[k].template cast<double>())));
  }
};

template <Scalar S>
void check_hulls(const std::string& name, std::uint64_t seed) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(seed);
  Tally scanned("hull_support, below 8 u |d| diameter, " + name);
  int mapped = 0;
  for (int i = 0; i < rounds(300); ++i) {
    const bool large = i % 6 == 0;
    const DrawnHull<S> drawn(draw, large ? 200 + draw.below(200) : 8 + draw.below(80));
    const Hull<S> hull = large ? with_adjacency(drawn.points) : Hull<S>(drawn.points);
    mapped += hull.has_adjacency() && !hull.graph().map.empty();
    for (int k = 0; k < 4; ++k) {
      const Vec3<S> d = drawn.direction(draw).template cast<S>();
      const Vec3<double> n = d.template cast<double>();
      const auto with = [&] {
        std::string text = "  d " + describe(n) + "\n ";
        for (const Vec3<S>& x : drawn.points) text += describe(Vec3<double>(x.template cast<double>()));
        return text + "\n";
      };
      const Ball size = norm(BallVec(n)) * drawn.diameter;
      scanned.add(8 * kUnitRoundoff<S>,
                  drawn.below(detail::hull_support<S, S>(hull, d), n) / max(size, two_to(-900)), with);
    }
  }
  scanned.finish(50);
  EXPECT_GT(mapped, 10);
}

TEST(SupportBounds, VerticesOfHullsInDouble) { check_hulls<double>("double", 61); }
TEST(SupportBounds, VerticesOfHullsInFloat) { check_hulls<float>("float", 62); }

// The point of a curved leaf that is farthest along d, exactly.
BallVec rim(double radius, double z, const BallVec& d) {
  const BallVec across{d.x, d.y, Ball(0)};
  if (!norm(across).is_positive()) return {Ball(0), Ball(0), Ball(z)};
  const BallVec u = unit_of(across);
  return {Ball(radius) * u.x, Ball(radius) * u.y, Ball(z)};
}

template <Scalar S>
void check_curved(const std::string& name, std::uint64_t seed) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(seed);
  Tally ellipsoids("ellipsoid_point, over 6 u, " + name), rims("cylinder_point, over 6 u, " + name),
      cones("cone_point, over 6 u, " + name), low("cone_point, height below 12 u, " + name);
  const double range = sizeof(S) == 8 ? 60 : 10;
  for (int i = 0; i < rounds(1500); ++i) {
    Vec3<S> d = draw.plain().template vector<S>(1), r = draw.plain().template vector<S>(1).cwiseAbs();
    for (int k = 0; k < 3; ++k) {
      if (draw.chance(0.2)) d[k] = draw.chance(0.5) ? S(0) : d[k] * S(draw.power(-range, 0));
      if (draw.chance(0.2)) r[k] = draw.chance(0.5) ? S(0) : r[k] * S(draw.power(-range, 0));
    }
    const S h = r[2], radius = r[0];
    // Along which the apex of a cone and its rim tie, nearly.
    if (draw.chance(0.3) && h > 0) {
      const double across = std::hypot(double(d[0]), double(d[1]));
      d[2] = S(draw.nudged(across * double(radius) / (2 * double(h))));
    }
    const Vec3<double> n = d.template cast<double>();
    if (!(n.norm() > 0) || !(n.norm() < 0x1p100)) continue;
    const BallVec along(n);
    const auto with = [&] {
      return "  d " + describe(n) + " r " + describe(Vec3<double>(r.template cast<double>())) + "\n";
    };
    const auto ball = [](const Vec3<S>& x) { return BallVec(Vec3<double>(x.template cast<double>())); };
    constexpr double kSix = 6 * kUnitRoundoff<S>;

    const Vec3<double> radii = r.template cast<double>();
    const BallVec e{Ball(radii[0]) * along.x, Ball(radii[1]) * along.y, Ball(radii[2]) * along.z};
    if (norm(e).is_positive()) {
      const BallVec f = unit_of(e), truth{Ball(radii[0]) * f.x, Ball(radii[1]) * f.y, Ball(radii[2]) * f.z};
      ellipsoids.add(kSix, norm(ball(detail::ellipsoid_point<S>(r, d)) - truth) / norm(BallVec(radii)), with);
    }
    const Ball reach = sqrt(Ball(radius) * Ball(radius) + Ball(h) * Ball(h));
    if (!reach.is_positive()) continue;
    const BallVec top = rim(radius, d[2] >= 0 ? h : -h, along), bottom = rim(radius, -double(h), along);
    rims.add(kSix, norm(ball(detail::cylinder_point<S>(radius, h, d)) - top) / reach, with);
    const BallVec seen = ball(detail::cone_point<S>(radius, h, d)), apex{Ball(0), Ball(0), Ball(h)};
    cones.add(kSix, min(norm(seen - apex), norm(seen - bottom)) / reach, with);
    const Ball most = max(dot(along, apex), dot(along, bottom));
    low.add(2 * kSix, (most - dot(along, seen)) / (norm(along) * reach), with);
  }
  for (Tally* one : {&ellipsoids, &rims, &cones, &low}) one->finish(300);
}

TEST(SupportBounds, PointsOfCurvedLeavesInDouble) { check_curved<double>("double", 63); }
TEST(SupportBounds, PointsOfCurvedLeavesInFloat) { check_curved<float>("float", 64); }

}  // namespace
}  // namespace graze::test
