// Bodies on arms, or out in their own frames, by many times their size: what rounding leaves of a difference
// of long vectors is a part of every bound. Each test was a wrong answer of tiers standard and certified.
#include <gtest/gtest.h>
#include <graze/cast.hpp>
#include <graze/detail/rotating/mobility.hpp>

#include <graze/rotating_cast.hpp>

namespace graze {
namespace {

RotatingResult<double> certified(const RotatingBody<double>& a, const RotatingBody<double>& b) {
  RotatingOptions<double> options;
  options.tier = Tier::certified;
  return cast(a, b, options);
}

RotatingBody<double> cube() { return {.body = {.shape = Box<double>{{0.5, 0.5, 0.5}}}}; }
RotatingBody<double> ball() { return {.body = {.shape = Sphere<double>{0.5}}}; }

// Two cubes, one above the other by more than they are high, turn alike by (1, 1, 0). B's pivot is (x, next
// after x, .) from A's: one unit in the last place of x off the axis, so B dips by as much, 2.4e-4. In plain
// doubles the pivots' difference was parallel to w, and the plan let both stand still.
struct AsOne {
  const char* name;
  double height, x;
  double toi;  // to 17 digits, by arithmetic of 60
};

TEST(FarArms, PivotsAnUlpOffTheAxisAreNotAsOne) {
  for (const AsOne& scene : {AsOne{"arm 2^40", 1.000030517578125, 1708361461167.5671, 0.12566037094631432},
                             AsOne{"arm 2e6", 1.0000000000291038, 1826166.423356417, 0.12566037094631432}}) {
    RotatingBody<double> a = cube(), b = cube();
    a.rotation = b.rotation = {1, 1, 0};
    b.body.position = {0, 0, scene.height};
    b.pivot = {scene.x, std::nextafter(scene.x, 2 * scene.x), -scene.height};
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      RotatingOptions<double> options;
      options.tier = tier;
      const auto r = cast(a, b, options);
      EXPECT_FALSE(r.plan.has(PlanReason::as_one)) << scene.name;
      ASSERT_EQ(r.outcome, Outcome::hit) << scene.name;
      EXPECT_LE(r.toi_lower, scene.toi) << scene.name;
      // In the standard tier, bodies within 4,096 u of their scale, here the arm, are in contact.
      const double early = tier == Tier::certified ? 0 : 1e-3;
      EXPECT_GE(r.toi_upper, scene.toi - early) << scene.name;
      EXPECT_LT(r.counters.supports, 200) << scene.name;
    }
  }
}

// If the difference of far pivots is exactly parallel to w, nothing moves, rounded to doubles or not.
TEST(FarArms, PivotsOnOneAxisAreAsOne) {
  RotatingBody<double> a = cube(), b = cube();
  a.rotation = b.rotation = {0.1, 0.3, -0.7};
  a.pivot = {3, 4, 5};
  b.body.position = {0, 0, 1.25};
  // c_B - c_A = 2^43 (0.1, 0.3, -0.7): powers of two are exact, and so is the sum with few bits.
  b.pivot = 0x1p43 * b.rotation;
  a.body.position = -a.pivot;
  b.body.orientation = {0, 0, 0, 3};  // half a turn about z
  b.pivot = {-b.pivot[0], -b.pivot[1], b.pivot[2]};
  b.body.position = {0, 0, 0};
  EXPECT_TRUE(plan(a, b, {.tier = Tier::certified}).has(PlanReason::as_one));
  b.pivot[0] = std::nextafter(b.pivot[0], 0);
  EXPECT_FALSE(plan(a, b, {.tier = Tier::certified}).has(PlanReason::as_one));
}

Hull<double> far_bar(double from, double to, double half) {
  std::vector<Vec3<double>> vertices;
  for (const double x : {from, to}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) vertices.push_back({x, y, z});
    }
  }
  return Hull<double>(std::span<const Vec3<double>>(vertices));
}

// A piece of a level, 2e6 out in its own frame and at rest: what the middle of its bounds lost in rounding is
// a part of its reach. Forgotten, the bounds never met, and bodies that overlap at t = 0 were a miss.
TEST(FarArms, BodiesAtRestFarOutInTheirOwnFramesReachAsFarAsTheyDo) {
  struct Scene {
    const char* name;
    Box<double> box;
    double at, turn;
    Hull<double> bar;
    double back;
  };
  const std::array scenes = {
      Scene{"2e6 out",
            {{0.25, 1e-9, 1e-9}},
            1.2606262743838714,
            0.001,
            far_bar(1972337.2896865364, 1972338.3003128108, 1e-9),
            -1972337.2896865364},
      Scene{"2^53 out", {{0.25, 0.25, 0.25}}, 2, 1, far_bar(0x1p53, 0x1p53 + 2, 0.01), -0x1p53}};
  for (const Scene& scene : scenes) {
    RotatingBody<double> a{.body = {.shape = scene.box, .position = {scene.at, 0, 0}},
                           .rotation = {0, 0, scene.turn}};
    RotatingBody<double> b{.body = {.shape = scene.bar, .position = {scene.back, 0, 0}}};
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      RotatingOptions<double> options;
      options.tier = tier;
      EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping) << scene.name;
      EXPECT_EQ(cast(b, a, options).outcome, Outcome::initially_overlapping) << scene.name;
    }
  }
}

// Two balls on long arms rotate about axes an ulp apart, which point along the line between the balls to
// within the rounding of a product of doubles. n x w was 0, and so were the bounds of speed and acceleration
// along n.
TEST(FarArms, AxesParallelButForAnUlpMoveFarBodies) {
  const double more = 1.7578748123442727, less = 1.757874812344273;
  struct Scene {
    double arm, apart, toi;  // as above
  };
  for (const auto& [arm, apart, toi] : {Scene{0x1p40, 0.7071774918646662, 0.32334502610191778},
                                        Scene{0x1p20, 0.7071067812572581, 0.34418804432948796}}) {
    RotatingBody<double> a = ball(), b = ball();
    a.rotation = {more, less, 0};
    a.pivot = {0, 0, -arm};
    b.rotation = {less, more, 0};
    b.body.position = {apart, apart, 0};
    b.pivot = {-apart, -apart, -arm};
    const auto r = certified(a, b);
    ASSERT_EQ(r.outcome, Outcome::hit) << arm;
    EXPECT_LE(r.toi_lower, toi) << arm;
    EXPECT_GE(r.toi_upper, toi) << arm;
  }
}

// A ball put 2^36 out in its own frame and rotated back. The rounding of a quick walk through its poses,
// 6e-6, made its bounds those of a point at the origin, which no rotation of the body moves. The certified
// bracket of a linear cast then began 7e-7 after the contact.
TEST(FarArms, PartsPutOutAndTurnedBackAreWhereTheyAre) {
  const Vec3<double> there{-32985348833.28, 41231686041.6, 43980465111.04},
      back{4773817793.885956, 32747595716.898575, 60226008678.16984};
  Body<double> a{
      .shape = posed<double>(translated<double>(Sphere<double>{0.5}, there), back, {0.1, 0.73, -0.44, 0.51}),
      .orientation = {0.6, -0.3, 0.7, 0.1}};
  const Body<double> b{.shape = Sphere<double>{0.25}, .position = {4, 0, 0}, .displacement = {-8, 0, 0}};
  const double toi = 0.4062500570927631;  // closed form
  CastOptions<double> options;
  options.tier = Tier::certified;
  const auto r = cast(a, b, options);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_LE(r.toi_lower, toi);
  EXPECT_GE(r.toi_upper, toi);
  EXPECT_LT(r.toi_upper - r.toi_lower, 1e-12);
}

TEST(FarArms, ALengthOfACrossProductIsNeverBelowIt) {
  using detail::length_of_cross;
  const Vec3<double> w{1.7578748123442727, 1.757874812344273, 0};
  const Vec3<double> n = unit(w);
  EXPECT_EQ(length_of_cross({0.5, 0.5, 0}, {3, 3, 0}), 0);
  EXPECT_GT(length_of_cross(n, {w[1], w[0], 0}), 1e-17);
  EXPECT_GE(length_of_cross({1e-300, 0, 1}, {0, 0, 1e60}), 1e-240);
  EXPECT_GE(length_of_cross({0, 0, 1}, {1e-60, 1e-60, 1}), 1.414e-60);
}

}  // namespace
}  // namespace graze
