// The reach of a rotating body, and the speeds of its points and of the body as a set (mobility.hpp), against
// balls. Every field and every function of Mobility is a bound of the quantity that its header defines.
#include <gtest/gtest.h>

#include <graze/detail/rotating/moving_pair.hpp>
#include <graze/detail/rotating/spheres.hpp>

#include "oracles/curved/ball_motion.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/describe.hpp"
#include "tests/bounds/in_float.hpp"
#include "tests/bounds/true_mobility.hpp"

namespace graze::test {
namespace {

using detail::is_on_axis;
using detail::Mobility;
using oracle::WorkingPrecision;

// One body of a pair, as it is bounded and as it is.
struct Looked {
  const RotatingBody<double>& given;
  detail::MovingPair pair;
  const Mobility& m;
  Ball unit;  // internal length of one world length
  TrueBody truth;

  // `as_given`: the bodies in scalar S. `body`: the body that they stand for.
  template <Scalar S>
  Looked(const RotatingBody<S>& as_given, const RotatingBody<S>& other, double target,
         const RotatingBody<double>& body)
      : given(body),
        pair(as_given, other, target),
        m(pair.mobility_a()),
        unit(two_to(-pair.cso().length_exponent())),
        truth(body, pair.pivot_a()) {}
};

constexpr int kScenes = 1200;

template <class Visit>
void for_each_body(std::uint64_t seed, int scenes, const Visit& visit, long bits = kTruthBits) {
  const WorkingPrecision precision(bits);
  HostileDraw draw(seed);
  for (int i = 0; i < scenes; ++i) {
    const HostileScene scene = draw.scene();
    const std::optional<FloatScene> narrow = i % 3 == 0 ? FloatScene::of(scene) : std::nullopt;
    if (narrow) {
      const HostileScene& wide = narrow->scene;
      visit(Looked(narrow->a, narrow->b, wide.target, wide.a), wide, draw);
      visit(Looked(narrow->b, narrow->a, wide.target, wide.b), wide, draw);
    } else {
      visit(Looked(scene.a, scene.b, scene.target, scene.a), scene, draw);
      visit(Looked(scene.b, scene.a, scene.target, scene.b), scene, draw);
    }
  }
}

TEST(MobilityBounds, NoPointIsFartherOut) {
  Tally reach("Mobility::reach"), still("Mobility::reach, at rest"), rho("Mobility::rho"),
      high("Mobility::high"), low("-Mobility::low"), rate("Mobility::rate");
  for_each_body(1, rounds(kScenes), [&](const Looked& body, const HostileScene& scene, HostileDraw&) {
    const auto with = [&] { return describe(scene); };
    const TrueBody& truth = body.truth;
    (truth.turns ? reach : still).add(body.m.reach, body.unit * truth.reach(), with);
    if (!truth.turns) return;
    rate.add(body.m.rate, truth.rate, with);
    rho.add(body.m.rho, body.unit * truth.rho(), with);
    high.add(body.m.high, body.unit * truth.high(), with);
    low.add(-body.m.low, -(body.unit * truth.low()), with);
  });
  for (Tally* one : {&reach, &rho, &high, &low, &rate}) one->finish(500);
  still.finish(50);
}

// The corners of a bar are those of its bounds: half extents that round in float do not hold them.
TEST(MobilityBounds, ABarOfFloatsAtRestReachesItsCorners) {
  const WorkingPrecision precision(kTruthBits);
  Draw draw{18};
  Tally still("Mobility::reach, of a bar of floats at rest");
  const RotatingBody<float> other{.body = {}, .rotation = {0, 0, 1}};
  for (int i = 0; i < rounds(300); ++i) {
    RotatingBody<float> bar;
    std::vector<Vec3<float>> corners;
    Vec3<float> low, high;
    for (int k = 0; k < 3; ++k) {
      const double out = std::scalbn(draw.between(-1, 1), static_cast<int>(draw.between(-2, 22)));
      low[k] = static_cast<float>(out - draw.between(0, 4));
      high[k] = static_cast<float>(out + draw.between(0, 4));
    }
    for (unsigned k = 0; k < 8; ++k) {
      corners.emplace_back((k & 1u) != 0 ? high[0] : low[0], (k & 2u) != 0 ? high[1] : low[1],
                           (k & 4u) != 0 ? high[2] : low[2]);
    }
    bar.body.shape = Hull<float>(std::span<const Vec3<float>>(corners));
    HostileScene scene;
    scene.a.body.shape = engine::round_to<double>(bar.body.shape);
    const Looked body(bar, other, 0.0, scene.a);
    still.add(body.m.reach, body.unit * body.truth.reach(), [&] { return describe(scene); });
  }
  still.finish(100);
}

// The sphere that is cast before anything is prepared: about the pivot as it is rounded, all of the body at any angle.
TEST(MobilityBounds, TheOuterSphereHoldsTheBody) {
  Tally outer("OuterSphere::reach");
  for_each_body(7, rounds(kScenes), [&](const Looked& body, const HostileScene& scene, HostileDraw&) {
    const RotatingBody<double>& given = body.given;
    if (detail::is_combined(given.body.shape)) return;
    const detail::OuterSphere sphere = detail::outer_sphere(given);
    const Vec3<double>& pivot = body.pair.pivot_a();
    const BallVec off = BallVec(sphere.pivot) - BallVec(given.body.position) -
                        BallRotation(given.body.orientation).apply(BallVec(pivot));
    outer.add(sphere.bound(), body.truth.reach() + norm(off) + Ball(detail::common_radius(given.body.shape)),
              [&] { return describe(scene); });
  });
  outer.finish(500);
}

TEST(MobilityBounds, ASolidOfRevolutionTurnsAboutItsOwnAxisNoSlower) {
  Tally tilt("Mobility::tilt_rate"), own("Mobility::own_rate"), center("Mobility::center_rho"),
      around("Mobility::revolved_reach");
  for_each_body(2, rounds(kScenes), [&](const Looked& body, const HostileScene& scene, HostileDraw&) {
    if (!body.m.turns() || !body.m.revolves) return;
    const auto with = [&] { return describe(scene); };
    const Revolved truth(body.truth, body.given.body.shape, body.pair.pivot_a());
    tilt.add(body.m.tilt_rate, truth.tilt, with);
    own.add(body.m.own_rate, truth.own, with);
    center.add(body.m.center_rho, body.unit * truth.center, with);
    around.add(body.m.revolved_reach, body.unit * truth.around, with);
  });
  for (Tally* one : {&tilt, &own, &center, &around}) one->finish(100);
}

// By the header's formulas, in balls.
TEST(MobilityBounds, NoPointIsFasterThanItsFormula) {
  Tally speed("Mobility::speed"), acceleration("Mobility::acceleration"),
      rotation_displacement("Mobility::rotation_displacement"), top_speed("Mobility::top_speed"),
      top_acceleration("Mobility::top_acceleration");
  for_each_body(3, rounds(kScenes), [&](const Looked& body, const HostileScene& scene, HostileDraw& draw) {
    if (!body.truth.turns) return;
    const TrueMobility truth(body.truth, body.given, body.pair.pivot_a(), body.unit);
    for (int k = 0; k < 4; ++k) {
      const Vec3<double> n = draw.direction(scene);
      const double t = draw.time(scene);
      const auto with = [&] { return describe(scene, n, t); };
      speed.add(body.m.speed(n), truth.speed(BallVec(n)), with);
      acceleration.add(body.m.acceleration(n), truth.acceleration(BallVec(n)), with);
      rotation_displacement.add(body.m.rotation_displacement(t),
                                truth.rotation_displacement(body.truth.chord(t)), with);
    }
    const auto with = [&] { return describe(scene); };
    top_speed.add(body.m.top_speed(), truth.top_speed(), with);
    top_acceleration.add(body.m.top_acceleration(), truth.top_acceleration(), with);
  });
  for (Tally* one : {&speed, &acceleration, &rotation_displacement, &top_speed, &top_acceleration})
    one->finish(500);
}

// Whatever the formulas: how fast the set's greatest n.x goes, and how its slope falls, by differences. With
// h(t) = max n.x over the set, its common motion aside, |h'| <= speed, and h + acceleration t^2/2 is convex.
TEST(MobilityBounds, NoSetIsFasterByDifferences) {
  Tally speed("Mobility::speed, of the set"), acceleration("Mobility::acceleration, of the set"),
      rotation_displacement("Mobility::rotation_displacement, of the set");
  for_each_body(
      4, rounds(300),
      [&](const Looked& body, const HostileScene& scene, HostileDraw& draw) {
        if (!body.truth.turns) return;
        const oracle::BallMotion motion(body.given.body, {body.given.rotation, body.given.pivot});
        for (int k = 0; k < 2; ++k) {
          const Vec3<double> n = draw.direction(scene);
          const double t = draw.time(scene);
          const auto with = [&] { return describe(scene, n, t); };
          const BallVec along(n);
          const auto height = [&](const Ball& at) {
            return body.unit * (motion.support(along, at).reach - dot(along, at * body.truth.v));
          };
          const Ball d = two_to(-200), before = height(Ball(t) - d), now = height(t),
                     after = height(Ball(t) + d);
          speed.add(body.m.speed(n), abs(after - before) / (d + d), with);
          acceleration.add(body.m.acceleration(n), (now + now - before - after) / (d * d), with);
          rotation_displacement.add(body.m.rotation_displacement(t), abs(now - height(0)) / norm(along),
                                    with);
        }
      },
      kDifferenceBits);
  for (Tally* one : {&speed, &acceleration, &rotation_displacement}) one->finish(100);
}

// Does core claim that the body's point x is on the axis of rotation? By the arm where core uses it.
template <class Body>
bool is_said_on_axis(const Body& a, const Vec3<double>& x) {
  if constexpr (requires { is_on_axis(a, a.pivot, x); }) {
    return is_on_axis(a, a.pivot, x);
  } else {
    return is_on_axis(a, {x, Vec3<double>::Zero(), a.pivot});
  }
}

// A feature that is claimed to be on the axis of rotation, or along it, is exactly so.
TEST(MobilityBounds, WhatIsOnTheAxisIsExactlyOnIt) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(5);
  int on = 0, along = 0;
  for (int i = 0; i < rounds(4000); ++i) {
    const HostileScene scene = draw.scene();
    const RotatingBody<double>& a = scene.a;
    const BallRotation turn(a.body.orientation);
    Vec3<double> x = a.pivot;
    if (draw.chance(0.5)) x += draw.power(-3, 40) * unit(a.rotation);
    if (draw.chance(0.5)) x = draw.nudged(x);
    if (a.rotation != Vec3<double>::Zero() && is_said_on_axis(a, x)) {
      const BallVec off = cross(BallVec(a.rotation), turn.apply(BallVec(x) - BallVec(a.pivot)));
      EXPECT_FALSE(norm(off).is_positive()) << describe(scene) << " x " << describe(x);
      on += x != a.pivot;
    }
    const int own = static_cast<int>(draw.below(3));
    if (detail::is_along_own_axis(a, own)) {
      const BallVec axis = turn.apply(BallVec(Vec3<double>(Vec3<double>::Unit(own))));
      EXPECT_FALSE(norm(cross(axis, BallVec(a.rotation))).is_positive()) << describe(scene) << own;
      along += a.rotation != Vec3<double>::Zero();
    }
  }
  EXPECT_GT(on, 50);
  EXPECT_GT(along, 50);
}

}  // namespace
}  // namespace graze::test
