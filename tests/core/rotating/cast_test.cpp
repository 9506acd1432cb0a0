#include <gtest/gtest.h>
#include <graze/detail/rotating/slice.hpp>

#include <graze/cast.hpp>
#include <graze/rotating_cast.hpp>
#include <numbers>

#include "tests/shared/turning_bodies.hpp"

namespace graze {
namespace {

using test::Draw;

constexpr RotatingMethod kSafe[] = {RotatingMethod::conservative_advancement,
                                    RotatingMethod::bilateral_advancement};
constexpr RotatingMethod kAll[] = {
    RotatingMethod::time_steps, RotatingMethod::bounding_spheres, RotatingMethod::conservative_advancement,
    RotatingMethod::bilateral_advancement, RotatingMethod::bilateral_published};

template <class S>
RotatingOptions<S> with(std::optional<RotatingMethod> method, Tier tier = Tier::standard) {
  RotatingOptions<S> out;
  out.tier = tier;
  out.method = method;
  out.request = Request::everything;
  return out;
}

// A rod of length 1 about its end, and a ball: the rod's line is the ball's radius off its centre at the hit.
struct RodAndBall {
  RotatingBody<double> rod{.body = {.shape = Segment<double>{{0, 0, 0}, {1, 0, 0}}}, .rotation = {0, 0, 2}};
  RotatingBody<double> ball{.body = {.shape = Sphere<double>{0.25}, .position = {0, 0.75, 0}}};
  double toi = (std::numbers::pi / 2 - std::asin(0.25 / 0.75)) / 2;
};

// The corner of a cube of half extent 1 about z reaches a wall at x = 1.25.
struct CornerAndWall {
  RotatingBody<double> cube{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {0, 0, 1}};
  RotatingBody<double> wall{.body = {.shape = Box<double>{{1, 50, 50}}, .position = {2.25, 0.125, 0.25}}};
  double toi = std::numbers::pi / 4 - std::acos(1.25 / std::numbers::sqrt2);
};

void expect_hit(const RotatingResult<double>& r, double toi, double length_per_time, double width) {
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_LE(r.toi_lower, toi * (1 + 4e-16));
  EXPECT_GE(r.toi_upper, toi * (1 - 4e-16));
  EXPECT_LE((r.toi_upper - r.toi_lower) * length_per_time, width);
}

TEST(RotatingCast, ClosedAnswers) {
  const RodAndBall one;
  const CornerAndWall two;
  for (const RotatingMethod method : kSafe) {
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      // From the bracket's width: twice a length over scale, as the speeds are below 2 and the sines above
      // 1/2.
      const double width = tier == Tier::standard ? 1e-11 : 1e-8;
      expect_hit(cast(one.rod, one.ball, with<double>(method, tier)), one.toi, 2, width);
      expect_hit(cast(two.cube, two.wall, with<double>(method, tier)), two.toi, 1, width * 100);
    }
  }
  const auto r = cast(one.rod, one.ball, with<double>({}));
  EXPECT_LT((r.point_a - r.point_b).norm(), 1e-11);
  EXPECT_NEAR((r.point_b - one.ball.body.position).norm(), 0.25, 1e-12);
  EXPECT_NEAR(r.normal.norm(), 1, 1e-14);
  const double angle = 2 * one.toi;
  EXPECT_LT((r.normal - Vec3<double>(-std::sin(angle), std::cos(angle), 0)).norm(), 1e-5);
}

// Brackets in float hold the float input's answer, which is in double here.
TEST(RotatingCast, FloatBracketsHoldTheAnswerInDouble) {
  Draw draw{81};
  int hits = 0;
  for (int round = 0; round < 200; ++round) {
    const auto narrow = [](const RotatingBody<double>& x) {
      RotatingBody<float> out;
      out.body.shape = Box<float>{Vec3<float>{0.5F, 0.25F, 0.75F}};
      out.body.position = x.body.position.cast<float>();
      out.body.displacement = x.body.displacement.cast<float>();
      const auto& q = x.body.orientation;
      out.body.orientation = {float(q.w), float(q.x), float(q.y), float(q.z)};
      out.rotation = x.rotation.cast<float>();
      out.pivot = x.pivot.cast<float>();
      return out;
    };
    const auto widened = [](const RotatingBody<float>& x) {
      RotatingBody<double> out;
      out.body.shape = Box<double>{{0.5, 0.25, 0.75}};
      out.body.position = x.body.position.cast<double>();
      out.body.displacement = x.body.displacement.cast<double>();
      const auto& q = x.body.orientation;
      out.body.orientation = {q.w, q.x, q.y, q.z};
      out.rotation = x.rotation.cast<double>();
      out.pivot = x.pivot.cast<double>();
      return out;
    };
    auto a = test::turning_body(draw), b = test::turning_body(draw);
    b.body.displacement = 1.5 * (a.body.position - b.body.position);
    const auto fa = narrow(a), fb = narrow(b);
    const auto single = cast(fa, fb, with<float>({}));
    const auto fine = cast(widened(fa), widened(fb), with<double>({}));
    EXPECT_EQ(single.outcome, fine.outcome);
    if (fine.outcome != Outcome::hit) continue;
    ++hits;
    EXPECT_LE(double(single.toi_lower), fine.toi_lower);
    EXPECT_GE(double(single.toi_upper), fine.toi_lower);
    EXPECT_LE(single.toi_upper - single.toi_lower, 1e-4F);
  }
  EXPECT_GT(hits, 50);
}

// Safe methods never pass the first contact, whatever the bodies do between the ends of the step: sampled.
TEST(RotatingCast, NoContactBeforeTheLowerEnd) {
  Draw draw{82};
  int hits = 0, misses = 0;
  for (int round = 0; round < 400; ++round) {
    auto a = test::turning_body(draw), b = test::turning_body(draw);
    if (round % 2 == 0) b.body.displacement = 1.5 * (a.body.position - b.body.position);
    RotatingOptions<double> options = with<double>({});
    if (round % 5 == 0) options.target_distance = 0.125;
    const auto r = cast(a, b, options);
    ASSERT_NE(r.outcome, Outcome::invalid_input);
    if (r.outcome == Outcome::initially_overlapping) continue;
    ASSERT_NE(r.outcome, Outcome::not_converged) << round;
    ++(r.outcome == Outcome::hit ? hits : misses);
    const double end = r.outcome == Outcome::hit ? r.toi_lower : 1.0;
    detail::MovingPair pair(a, b, options.target_distance);
    Counters counters;
    for (int k = 0; k < 50; ++k) {
      pair.place(end * k / 50);
      EXPECT_GT(detail::nearest(pair, detail::Simplex<double>{}, 0, 1e-12, 256, counters).apart,
                2 * pair.error());
    }
    if (r.outcome != Outcome::hit) continue;
    EXPECT_LE(r.distance, 1e-11);
    // The witnesses are the target distance apart, and on the two sides of each other that the normal says.
    EXPECT_NEAR(r.normal.dot(r.point_b - r.point_a), options.target_distance, 1e-10);
    for (const RotatingMethod method : kSafe) {
      const auto other = cast(a, b, [&] {
        auto o = options;
        o.method = method;
        return o;
      }());
      ASSERT_EQ(other.outcome, Outcome::hit);
      EXPECT_LE(other.toi_lower, r.toi_upper);
      EXPECT_GE(other.toi_upper, r.toi_lower);
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 100);
}

// A gear's tooth that touches and leaves within the step: apart at both ends, and by 0.03 at every one of
// eight tests. Steps and the published bilateral advancement miss it.
TEST(RotatingCast, EntersAndLeavesWithinTheStep) {
  RotatingBody<double> gear{.body = {.shape = Box<double>{{1, 0.125, 0.5}}}, .rotation = {0, 0, 20}};
  const RotatingBody<double> stop{
      .body = {.shape = Box<double>{{0.25, 0.03125, 0.5}}, .position = {0, 1.03125, 0}}};
  auto options = with<double>(RotatingMethod::bilateral_advancement);
  options.t_max = 0.125;  // 2.5 radians
  const auto safe = cast(gear, stop, options);
  ASSERT_EQ(safe.outcome, Outcome::hit);
  EXPECT_LT(safe.toi_upper, 0.1);
  options.method = RotatingMethod::bilateral_published;
  EXPECT_EQ(cast(gear, stop, options).outcome, Outcome::miss);
  options.method = RotatingMethod::time_steps;
  options.time_steps = 2;
  const auto steps = cast(gear, stop, options);
  EXPECT_EQ(steps.outcome, Outcome::miss);
  // The cast reports the motion that it may miss: the tip moves by 20 * 1.13 * 1/16.
  EXPECT_NEAR(steps.hidden_motion, 20 * std::sqrt(1 + 0.125 * 0.125) / 16, 1e-6);
  options.time_steps = 64;
  EXPECT_EQ(cast(gear, stop, options).outcome, Outcome::hit);
}

// When bodies graze, the angular bound alone advances in small steps, but the chord bound steps over the
// graze.
TEST(RotatingCast, BilateralGoesOverGrazes) {
  CornerAndWall scene;
  scene.wall.body.position[0] = 1 + std::numbers::sqrt2 + 0x1p-20;
  auto options = with<double>(RotatingMethod::conservative_advancement);
  const auto slow = cast(scene.cube, scene.wall, options);
  options.method = RotatingMethod::bilateral_advancement;
  const auto quick = cast(scene.cube, scene.wall, options);
  EXPECT_EQ(slow.outcome, Outcome::miss);
  EXPECT_EQ(quick.outcome, Outcome::miss);
  EXPECT_GT(slow.counters.supports, 20 * quick.counters.supports);
}

// A fan that rotates fast beside a body that it never reaches is clear by its swept cylinder, whatever its
// angle. A face that two bodies rotate with is clear by an axis that rotates as well. Both take few slices
// for many radians.
TEST(RotatingCast, ManyRadiansInFewSlices) {
  const RotatingBody<double> fan{.body = {.shape = Box<double>{{0.0625, 1, 0.125}}},
                                 .rotation = {0, 0, 5000}};
  RotatingBody<double> wall{.body = {.shape = Box<double>{{1, 4, 4}}, .position = {2.015625, 0, 0}}};
  const auto beside = cast(fan, wall, with<double>({}));
  EXPECT_EQ(beside.outcome, Outcome::miss);
  ASSERT_TRUE(beside.proof);
  EXPECT_LE(beside.proof->chain.size(), 4u);
  wall.body.position[0] = 1.99;
  EXPECT_EQ(cast(fan, wall, with<double>({})).outcome, Outcome::hit);

  RotatingBody<double> left{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {0, 0, 500}};
  RotatingBody<double> right{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {2.0001, 0, 0}},
                             .rotation = {0, 0, 500},
                             .pivot = {-2.0001, 0, 0}};
  right.body.displacement = {0, 0, 1e-6};  // as one, except for a slow slide along the axis
  const auto slide = cast(left, right, with<double>({}));
  EXPECT_EQ(slide.outcome, Outcome::miss);
  ASSERT_TRUE(slide.proof);
  EXPECT_LE(slide.proof->chain.size(), 32u);
}

// The cylinder that stands for all angles reaches no less far than the body, along its axis as well, where
// the direction across is rounding alone.
TEST(RotatingCast, SweptCylindersHoldTheirBodies) {
  Draw draw{84};
  for (int round = 0; round < 200; ++round) {
    auto a = test::turning_body(draw), b = test::turning_body(draw);
    detail::MovingPair pair(a, b, 0.0);
    Counters counters;
    for (int k = 0; k < 20; ++k) {
      pair.place(draw.between(0, 1));
      Vec3<double> n = unit(draw.vector<double>(1));
      if (k % 4 == 0) n = unit(Vec3<double>(k % 8 == 0 ? a.rotation : b.rotation));
      const double gap = pair.gap(n, counters);
      for (const detail::WholeTurns whole : {detail::WholeTurns{true, false}, {false, true}, {true, true}})
        EXPECT_LE(detail::swept_gap(pair, whole, n, counters), gap + 4 * pair.error());
    }
  }
}

// A slice ends at a double, and not later than what was proved, where steps are a few units in the last place
// of t.
TEST(RotatingCast, SlicesEndNoLaterThanProved) {
  Draw draw{85};
  for (int round = 0; round < 2000; ++round) {
    const double t = draw.between(0, 2), h = std::exp2(draw.between(-53, -1));
    const double end = detail::not_after(t, h);
    EXPECT_LE(end - t, h);
    EXPECT_GT(std::nextafter(end, 4) - t, h);
  }
}

// The spheres are about the pivots: a body far off its pivot is in them at every angle.
TEST(RotatingCast, SpheresAboutOffCentrePivots) {
  const RotatingBody<double> arm{.body = {.shape = Box<double>{{0.25, 0.25, 0.25}}, .position = {4, 0, 0}},
                                 .rotation = {0, 0, 3},
                                 .pivot = {-4, 0, 0}};
  const RotatingBody<double> post{.body = {.shape = Capsule<double>{0.25, 1}, .position = {0, 4, 0}}};
  const auto spheres = cast(arm, post, with<double>(RotatingMethod::bounding_spheres));
  const auto march = cast(arm, post, with<double>(RotatingMethod::bilateral_advancement));
  ASSERT_EQ(spheres.outcome, Outcome::hit);
  ASSERT_EQ(march.outcome, Outcome::hit);
  EXPECT_NEAR(spheres.toi_lower, march.toi_lower, 1e-11);
}

TEST(RotatingCast, FlatBodiesByCrossing) {
  const RotatingBody<double> plate{.body = {.shape = Triangle<double>{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}},
                                   .rotation = {0.5, 0, 0}};
  const RotatingBody<double> bullet{
      .body = {.shape = Point<double>{}, .position = {0.1, 0, 3}, .displacement = {0, 0, -6}}};
  for (const RotatingMethod method : kSafe) {
    const auto r = cast(plate, bullet, with<double>(method));
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_LE(r.toi_lower, 0.5);
    EXPECT_GE(r.toi_upper, 0.5);
    EXPECT_LT(r.toi_upper - r.toi_lower, 1e-11);
  }
  RotatingBody<double> aside = bullet;
  aside.body.position[0] = 2;
  EXPECT_EQ(cast(plate, aside, with<double>({})).outcome, Outcome::miss);
}

TEST(RotatingCast, StartsInContact) {
  const RotatingBody<double> floor{.body = {.shape = Box<double>{{4, 4, 1}}, .position = {0, 0, -1}}};
  RotatingBody<double> box{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {0.25, 0, 0.5}},
                           .rotation = {0.3, 0.2, 1}};
  for (const Tier tier : {Tier::standard, Tier::certified}) {
    const auto r = cast(floor, box, with<double>({}, tier));
    EXPECT_EQ(r.outcome, Outcome::initially_overlapping);
    EXPECT_EQ(r.toi_upper, 0);
  }
  // Touching: contact in tier standard, and in tier certified too, since nothing has turned yet and all is
  // exact.
  box.body.position[2] = 1;
  EXPECT_EQ(cast(floor, box, with<double>({})).outcome, Outcome::initially_overlapping);
  const auto certified = cast(floor, box, with<double>({}, Tier::certified));
  EXPECT_EQ(certified.outcome, Outcome::initially_overlapping);
  EXPECT_EQ(certified.toi_upper, 0);
  // A last place higher they touch a little later, as a corner goes down.
  box.body.position[2] = 1 + 0x1p-52;
  const auto later = cast(floor, box, with<double>({}, Tier::certified));
  ASSERT_EQ(later.outcome, Outcome::hit);
  EXPECT_LT(later.toi_upper, 1e-8);
}

TEST(RotatingCast, RefusesWhatItCannotAnswer) {
  const CornerAndWall scene;
  auto options = with<double>({});
  const auto invalid = [&] {
    const auto r = cast(scene.cube, scene.wall, options);
    EXPECT_TRUE(std::isnan(r.toi_lower) || r.outcome != Outcome::invalid_input);
    return r.invalid;
  };
  options.t_max = kInfinity<double>;
  EXPECT_EQ(invalid(), Invalid::not_linear);
  options = with<double>({});
  for (const auto method :
       {RotatingMethod::time_steps, RotatingMethod::bounding_spheres, RotatingMethod::bilateral_published}) {
    options = with<double>(method);
    options.start_policy = StartPolicy::pass_over;
    EXPECT_EQ(invalid(), Invalid::not_followed);
  }
  options = with<double>({}, Tier::exact);
  EXPECT_EQ(invalid(), Invalid::not_exact);
  options = with<double>({});
  options.time_steps = 0;
  EXPECT_EQ(invalid(), Invalid::bad_tolerance);
  CornerAndWall broken;
  broken.cube.rotation[1] = std::nan("");
  EXPECT_EQ(cast(broken.cube, broken.wall).invalid, Invalid::not_finite);
  broken.cube.rotation = {0, 0, 0x1p31};
  EXPECT_EQ(cast(broken.cube, broken.wall).invalid, Invalid::out_of_range);
  // A rotation without effect on the shape does not restrict a linear motion.
  const RotatingBody<double> ball{.body = {.shape = Sphere<double>{1}, .displacement = {1, 0, 0}},
                                  .rotation = {0, 0, 7}};
  const RotatingBody<double> wall{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {50, 0, 0}}};
  options = with<double>({});
  options.t_max = kInfinity<double>;
  const auto ray = cast(ball, wall, options);
  EXPECT_EQ(ray.outcome, Outcome::hit);
  EXPECT_NEAR(ray.toi_lower, 48, 1e-10);
}

// A product of two doubles splits its factors, and from 2^996 on a time has no halves.
TEST(RotatingCast, TimesOfAnySize) {
  const RotatingBody<double> a{.body = {.shape = Box<double>{{1, 1, 1}}}};
  RotatingBody<double> b{.body = {.shape = Box<double>{{1, 1, 1}}, .position = {0, 4, 0}}};
  for (const RotatingMethod method : kAll) {
    auto options = with<double>(method);
    options.t_max = 0x1p997;
    EXPECT_EQ(cast(a, b, options).outcome, Outcome::miss);
  }
  b.body.displacement = {0, -0x1p-190, 0};
  for (const RotatingMethod method :
       {RotatingMethod::conservative_advancement, RotatingMethod::bilateral_advancement}) {
    auto options = with<double>(method);
    options.t_max = 0x1p997;
    const auto r = cast(a, b, options);
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_NEAR(r.toi_lower, 0x1p191, 0x1p150);
  }
}

// Report: a box flew through another, and time steps said miss after the fifth test. Mechanism: the next step's number was
// found from the time, by a quotient and a product that round, and was the same step again, which was taken for the last.
TEST(RotatingCast, StepsReachTheEndOfAnyHorizon) {
  const RotatingBody<double> a{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {0, 0, 0.5}};
  for (int k = 1; k <= 1000; ++k) {
    const double t_max = k / 1000.0;
    const RotatingBody<double> b{.body = {.shape = Box<double>{{1, 1, 1}},
                                          .position = {14, 0, 0},
                                          .displacement = {-28 / t_max, 0, 0}}};
    for (const RotatingMethod method : {RotatingMethod::time_steps, RotatingMethod::bounding_spheres}) {
      const RotatingResult<double> r = cast(a, b, {.method = method, .t_max = t_max});
      EXPECT_EQ(r.outcome, Outcome::hit) << to_text(method) << " until " << t_max;
      // The steps, the start, and halving down to neighbouring doubles.
      EXPECT_LE(r.counters.iterations, 64 + 1 + 60) << to_text(method) << " until " << t_max;
    }
  }
}

TEST(RotatingCast, WithoutATurnEveryMethodGivesTheLinearAnswer) {
  Draw draw{83};
  int hits = 0;
  for (int round = 0; round < 100; ++round) {
    auto a = test::turning_body(draw), b = test::turning_body(draw);
    a.rotation = b.rotation = Vec3<double>::Zero();
    b.body.displacement = 1.5 * (a.body.position - b.body.position);
    const CastResult<double> linear = cast(a.body, b.body);
    for (const RotatingMethod method : kAll) {
      if (method == RotatingMethod::bilateral_published) continue;  // its contact is a slop away
      const auto r = cast(a, b, with<double>(method));
      if (r.outcome == Outcome::miss && linear.outcome == Outcome::hit) {
        // Steps may jump over a body.
        EXPECT_TRUE(method == RotatingMethod::time_steps || method == RotatingMethod::bounding_spheres);
        continue;
      }
      ASSERT_EQ(r.outcome, linear.outcome);
      if (linear.outcome != Outcome::hit) continue;
      ++hits;
      // The distance is small by GJK's upper bound, which is rougher on a cone's rim. If the path grazes,
      // times differ by the root of that.
      EXPECT_LE(r.distance, 1e-10);
      EXPECT_NEAR(r.toi_lower, linear.toi_lower, 1e-6);
    }
  }
  EXPECT_GT(hits, 100);
}

// A box slides, yawing, onto a level tile: contact begins at the edge of its top, no deeper than rounding. It was left open
// in 452 supports.
TEST(RotatingCast, ABoxThatYawsOntoALevelTileIsAHit) {
  const RotatingBody<double> tile{.body = {.shape = Box<double>{{0.5, 0.5, 0.5}}, .position = {0, 0, -0.5}}};
  const RotatingBody<double> box{.body = {.shape = Box<double>{{0.25, 0.375, 0.25}},
                                          .position = {-0.76, 0, 0.25},
                                          .displacement = {0.025, 0, 0}},
                                 .rotation = {0, 0, 0.02}};
  for (const double tolerance : {0.0, 1e-6, 1e-3}) {
    const auto r = cast(tile, box, {.tolerance = tolerance});
    ASSERT_EQ(r.outcome, Outcome::hit) << tolerance;
    EXPECT_NEAR(r.normal.norm(), 1, 1e-14);
    EXPECT_LE(r.counters.supports, 64);
  }
  // With a proof, only proved contact counts as contact.
  EXPECT_NE(cast(tile, box, {.request = Request::everything}).outcome, Outcome::miss);
}

// A box slides off a tile, 2e-9 above it: a clear miss, which any tolerance left open.
TEST(RotatingCast, AToleranceOpensNoVerdict) {
  const RotatingBody<double> tile{.body = {.shape = Box<double>{{0.5, 0.5, 0.5}}, .position = {0, 0, -0.5}}};
  const RotatingBody<double> box{
      .body = {.shape = Box<double>{{0.12939735491557205, 0.14439176653823332, 0.10473686995885155}},
               .position = {0.7066296532644964, -0.05709759206675727, 0.10473687217360696},
               .displacement = {-0.27132833072228246, 0, 0}},
      .rotation = {0, 0, -1.2915332203490955}};
  const auto tight = cast(tile, box);
  EXPECT_EQ(tight.outcome, Outcome::miss);
  for (const double tolerance : {1e-6, 1e-4, 1e-3}) {
    const auto loose = cast(tile, box, {.tolerance = tolerance});
    EXPECT_EQ(loose.outcome, Outcome::miss) << tolerance;
    EXPECT_LE(loose.counters.supports, tight.counters.supports) << tolerance;
  }
}

// A cylinder rolls and yaws beside the edge of a tile, 3e-8 above it: line against line, whose axis of least distance
// moves on faster than they near each other. It took 4,764 supports.
TEST(RotatingCast, ACylinderThatRollsPastAnEdgeTakesFewSupports) {
  const RotatingBody<double> tile{.body = {.shape = Box<double>{{0.5, 0.5, 0.5}}, .position = {-2, 1, -0.5}}};
  const RotatingBody<double> cylinder{
      .body = {.shape = Cylinder<double>{0.42647954144209821, 0.27445053170059397},
               .position = {-1.9503013538105405, 0.48496857257425408, 0.42647957410290432},
               .orientation = {0.70710678118654757, 0.53327971582222611, 0.46434119426620507, 0},
               .displacement = {0.048240245556317354, 0.042004097603409736, 0}},
      .rotation = {-0.098490299115819371, 0.11311268388912105, 0.00063451642335309315}};
  const auto r = cast(tile, cylinder);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_NEAR(r.toi_lower, 0.42578, 1e-5);
  EXPECT_LE(r.counters.supports, 256);
}

}  // namespace
}  // namespace graze
