// No body reaches farther along an axis, at any time of a span, than gaps_between() says, and a solid of revolution
// hardly less (whole_turns.hpp, profile.hpp). The reference is supports in balls.
#include <gtest/gtest.h>

#include <graze/detail/rotating/whole_turns.hpp>

#include "oracles/curved/ball_motion.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using detail::MovingPair;
using oracle::BallMotion;
using oracle::WorkingPrecision;

// A wheel, a cone or an ellipsoid whose pivot is on its own axis, and which spins nearly about that, beside a point. n
// is nearly across its axis.
HostileScene rolling(Draw& draw, Vec3<double>& n) {
  HostileScene scene;
  scene.a.body.shape = Point<double>{};
  RotatingBody<double>& wheel = scene.b;
  const double radius = draw.between(0.25, 2), half = draw.between(0, 2);
  switch (draw.bits() % 3) {
    case 0:
      wheel.body.shape = Cylinder<double>{radius, half};
      break;
    case 1:
      wheel.body.shape = Cone<double>{radius, half};
      break;
    default:
      wheel.body.shape = Ellipsoid<double>{{radius, radius, half}};
  }
  wheel.body.position = draw.vector<double>(2);
  wheel.body.displacement = draw.vector<double>(2);
  wheel.body.orientation = draw.turn<double>();
  wheel.pivot = {0, 0, draw.bits() % 2 == 0 ? 0.0 : draw.between(-2, 2)};
  const Vec3<double> own = oracle::BallRotation(wheel.body.orientation).mid_double().col(2);
  const double off = std::ldexp(1.0, -static_cast<int>(draw.bits() % 40));
  wheel.rotation = draw.between(-40, 40) * (own + draw.vector<double>(off));
  n = graze::unit(Vec3<double>(draw.vector<double>(1).cross(own) + draw.vector<double>(off)));
  return scene;
}

TEST(ReachBounds, NoTimeOfASpanIsNearerThanTheGapsOfItsEnds) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(75);
  int wrong = 0, count = 0;
  std::vector<double> tight;  // of rolling solids: the least slack of a span over the scale
  std::string failures;
  for (int i = 0; i < rounds(2000); ++i) {
    Vec3<double> n;
    const bool rolls = draw.chance(0.5);
    const HostileScene scene = rolls ? rolling(draw.plain(), n) : draw.scene();
    if (!rolls) n = draw.direction(scene);
    MovingPair pair(scene.a, scene.b, scene.target);
    const detail::WholeTurns whole{pair.mobility_a().turns(), pair.mobility_b().turns()};
    const double t_0 = scene.t_end * draw.plain().between(0, 1),
                 t_1 = t_0 + (scene.t_end - t_0) * (draw.chance(0.5) ? 1 : draw.plain().between(0, 0.1));
    if (!whole.any() || !(t_0 < t_1)) continue;
    Counters counters;
    const auto [first, last] = gaps_between(pair, whole, n, t_0, t_1, counters);
    const Vec3<double>& reference = scene.a.body.position;
    const BallMotion a(scene.a.body, {scene.a.rotation, scene.a.pivot}, reference);
    const BallMotion b(scene.b.body, {scene.b.rotation, scene.b.pivot}, reference);
    Ball least(kInfinity<double>);
    for (int k = 0; k <= 32; ++k) {
      const Ball part = Ball(k) / Ball(32), t = Ball(t_0) + part * (Ball(t_1) - Ball(t_0));
      const Ball gap =
          (-(a.at(t).support(BallVec(n)).reach + b.at(t).support(-BallVec(n)).reach) - Ball(scene.target)) *
          two_to(-pair.cso().length_exponent());
      const Ball slack = gap - (Ball(first) + part * (Ball(last) - Ball(first)));
      least = min(least, slack);
    }
    ++count;
    if (!(first > -kInfinity<double>) || !least.is_positive()) {
      if (++wrong <= 3) failures += std::to_string(least.mid_double()) + "\n" + describe(scene, n, t_0);
    }
    if (rolls) tight.push_back(least.mid_double() / pair.scale());
  }
  std::sort(tight.begin(), tight.end());
  ASSERT_GE(tight.size(), 100u);
  std::printf("bound | gaps_between, slack of rolling solids over scale | %d | %d | %.3g | %.3g | %.3g\n",
              count, wrong, tight.front(), tight[tight.size() / 2], tight.back());
  EXPECT_EQ(wrong, 0) << failures;
  EXPECT_GE(count, rounds(1000));
  EXPECT_LT(tight[tight.size() / 4], 1e-12);
}

}  // namespace
}  // namespace graze::test
