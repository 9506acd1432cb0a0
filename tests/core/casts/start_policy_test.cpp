// pass_over: which starts in contact leave or slide, by every method, in both scalars.
#include <gtest/gtest.h>
#include <graze/cast.hpp>
#include <graze/distance.hpp>

namespace graze {
namespace {

template <class S>
class StartPolicyTest : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(StartPolicyTest, Scalars);

// Unit boxes and balls of radius 1. B at `position` moves by `v`.
template <Scalar S>
struct Start {
  const char* what;
  Shape<S> a, b;
  Vec3<S> position, v;
  S target;
  bool passes;
};

TYPED_TEST(StartPolicyTest, PassesOverWhatLeavesOrSlides) {
  using S = TypeParam;
  const Shape<S> box = Box<S>{{1, 1, 1}}, ball = Sphere<S>{1}, cone = Cone<S>{1, 1}, disk = Cylinder<S>{1, 0};
  const Start<S> starts[] = {
      {"faces, moving off", box, box, {2, 0, 0}, {1, 0, 0}, 0, true},
      {"faces, sliding", box, box, {2, 0, 0}, {0, 1, 0}, 0, true},
      {"faces, moving in", box, box, {2, 0, 0}, {-1, 0, 0}, 0, false},
      {"faces, moving in aslant", box, box, {2, 0, 0}, {S(-0.25), 1, 0}, 0, false},
      {"edges, past each other", box, box, {2, 2, 0}, {-1, 1, 0}, 0, true},
      {"edges, one along the other's face", box, box, {2, 2, 0}, {-1, 0, 0}, 0, true},
      {"edges, moving in", box, box, {2, 2, 0}, {-1, -1, 0}, 0, false},
      {"deep, moving off", box, box, {1, 0, 0}, {1, 0, 0}, 0, false},
      {"deep, moving in", box, box, {1, 0, 0}, {-1, 0, 0}, 0, false},
      {"balls, sliding", ball, ball, {2, 0, 0}, {0, 1, 0}, 0, true},
      {"balls, moving in", ball, ball, {2, 0, 0}, {-1, 1, 0}, 0, false},
      {"cone's rim along a face", cone, box, {2, 0, 0}, {0, 1, 0}, 0, true},
      {"apex on a face, moving off", cone, box, {0, 0, 2}, {0, 0, 1}, 0, true},
      {"apex on a face, moving in", cone, box, {0, 0, 2}, {0, S(0.125), -1}, 0, false},
      {"flat disk in a flat disk, along both", disk, disk, {0, 0, 0}, {1, 0, 0}, 0, true},
      {"within the target distance, moving off", box, box, {S(2.25), 0, 0}, {1, 0, 0}, S(0.5), true},
      {"within the target distance, along", box, box, {S(2.25), 0, 0}, {0, 1, 0}, S(0.5), true},
      {"within the target distance, moving in", box, box, {S(2.25), 0, 0}, {-1, 0, 0}, S(0.5), false},
      {"touching, at rest", box, box, {2, 0, 0}, {0, 0, 0}, 0, true},
      {"deep, at rest", box, box, {1, S(0.5), 0}, {0, 0, 0}, 0, false},
  };
  for (const Start<S>& start : starts) {
    for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
      SCOPED_TRACE(testing::Message() << start.what << ", method " << static_cast<int>(method));
      const Body<S> a{.shape = start.a},
          b{.shape = start.b, .position = start.position, .displacement = start.v};
      CastOptions<S> options;
      options.method = method;
      options.target_distance = start.target;
      options.request = Request::everything;
      EXPECT_NE(cast(a, b, options).outcome, Outcome::miss);
      options.start_policy = StartPolicy::pass_over;
      const CastResult<S> result = cast(a, b, options);
      EXPECT_EQ(result.passed_over, start.passes);
      if (start.passes) {
        EXPECT_EQ(result.outcome, Outcome::miss);
        EXPECT_EQ(result.toi_lower, kInfinity<S>);
        EXPECT_FALSE(result.proof);
      } else {
        EXPECT_NE(result.outcome, Outcome::miss);
        EXPECT_LE(result.toi_lower, 64 * kUnitRoundoff<S>);
      }
    }
  }
}

TYPED_TEST(StartPolicyTest, ChangesNothingForAStartApart) {
  using S = TypeParam;
  const Body<S> a{.shape = Box<S>{{1, 1, 1}}},
      b{.shape = Sphere<S>{1}, .position = {5, S(0.5), 0}, .displacement = {-8, 0, 0}};
  CastOptions<S> options;
  const CastResult<S> report = cast(a, b, options);
  options.start_policy = StartPolicy::pass_over;
  const CastResult<S> pass = cast(a, b, options);
  EXPECT_EQ(report.outcome, Outcome::hit);
  EXPECT_EQ(pass.outcome, Outcome::hit);
  EXPECT_EQ(pass.toi_lower, report.toi_lower);
  EXPECT_EQ(pass.counters.supports, report.counters.supports);
}

// A start in contact of which the budget does not tell whether it leaves is no answer, and no verdict is
// wrong.
TYPED_TEST(StartPolicyTest, IsOpenWhereTheBudgetEnds) {
  using S = TypeParam;
  const Body<S> a{.shape = Box<S>{{1, 1, 0}}},
      b{.shape = Segment<S>{{-1, 0, 0}, {0, 0, 0}}, .position = {0, 0, -2}, .displacement = {0, 2, -2}};
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    CastOptions<S> options;
    options.method = method;
    options.target_distance = 3;
    options.start_policy = StartPolicy::pass_over;
    EXPECT_TRUE(cast(a, b, options).passed_over);
    int open = 0;
    for (int budget = 1; budget < 12; ++budget) {
      options.max_iterations = budget;
      const CastResult<S> result = cast(a, b, options);
      EXPECT_TRUE(result.passed_over || result.outcome == Outcome::not_converged) << budget;
      if (result.outcome != Outcome::not_converged) continue;
      ++open;
      EXPECT_EQ(result.toi_lower, 0);
      EXPECT_EQ(result.toi_upper, kInfinity<S>);
    }
    EXPECT_GT(open, 0);
  }
}

// Lower ends that a tolerance leaves at 0 imply nothing about the start.
TYPED_TEST(StartPolicyTest, ALateHitUnderALooseToleranceIsNoStart) {
  using S = TypeParam;
  const Body<S> a{.shape = Point<S>{}, .position = {4, 0, 0}},
      b{.shape = Hull<S>{{4, 0, 0}, {4, 6, 4}, {6, 4, -6}},
        .position = {S(0.5), -4, 0},
        .displacement = {0, 1, 0}};
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    CastOptions<S> options;
    options.method = method;
    options.t_max = 2;
    options.target_distance = 1;
    options.start_policy = StartPolicy::pass_over;
    for (const S tolerance : {S(0), S(0.125), S(0.5)}) {
      options.tolerance = tolerance;
      EXPECT_EQ(cast(a, b, options).outcome, Outcome::hit) << tolerance;
    }
  }
}

TYPED_TEST(StartPolicyTest, DistanceAtTheLowerEndIsWithinTheTolerance) {
  using S = TypeParam;
  const Body<S> a{.shape = Ellipsoid<S>{{1, 2, 3}}},
      b{.shape = Cylinder<S>{1, 2}, .position = {8, S(0.5), 1}, .displacement = {-16, 0, S(0.5)}};
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    for (const S tolerance : {S(1e-1), S(1e-3), S(1e-5), S(0)}) {
      CastOptions<S> options;
      options.method = method;
      options.tolerance = tolerance;
      const CastResult<S> r = cast(a, b, options);
      ASSERT_EQ(r.outcome, Outcome::hit);
      // The requested distance, beside 64 u of the scale, 11, and the true one.
      EXPECT_LE(r.distance, (tolerance + 64 * kUnitRoundoff<S>)*11) << tolerance;
      Body<S> there = b;
      there.position += r.toi_lower * b.displacement;
      EXPECT_LE(distance(a, there).lower, r.distance + 64 * kUnitRoundoff<S> * 11) << tolerance;
    }
  }
}

// At rest, off the middle of C by so little that its square vanishes: the question has a direction all the
// same.
TYPED_TEST(StartPolicyTest, AStartInTheMiddleOfCStays) {
  using S = TypeParam;
  const S off = sizeof(S) == 8 ? S(1e-59) : S(1e-30);
  const Body<S> a{.shape = Box<S>{{1, 1, 1}}},
      b{.shape = Box<S>{{1, 1, S(0.5)}}, .position = {off, -off, off}};
  CastOptions<S> options;
  options.start_policy = StartPolicy::pass_over;
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    options.method = method;
    EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping);
  }
}

// Beside a target distance so far beyond the bodies that its square in their units would be infinite.
TYPED_TEST(StartPolicyTest, ATargetDistanceBeyondTheBodiesIsHeld) {
  using S = TypeParam;
  const S near = sizeof(S) == 8 ? S(1e-59) : S(0x1p-138), far = sizeof(S) == 8 ? S(1e59) : S(1e30);
  for (const S target : {S(1), far}) {
    for (const S off : {S(0), near, S(-3 * target)}) {
      const Body<S> a{.position = {off, near, 0}}, b{.displacement = {-4 * target, 0, 0}};
      for (const Method method :
           {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
        CastOptions<S> options;
        options.method = method;
        options.target_distance = target;
        const CastResult<S> r = cast(a, b, options);
        if (off == -3 * target) {
          ASSERT_EQ(r.outcome, Outcome::hit) << target;
          // From 3 apart to 1, at a speed of 4, within 64 u of 3 over 4.
          EXPECT_NEAR(r.toi_lower, S(0.5), 64 * kUnitRoundoff<S>);
        } else {
          EXPECT_EQ(r.outcome, Outcome::initially_overlapping) << target << ' ' << off;
        }
      }
    }
  }
}

// Report: for sums of segments and triangles with coordinates from 1e-60 to 1e60, moved to each other's
// origin, gjk and mpr did not converge in about 1 of 1,500 casts, although they always should. Mechanism: a
// corner was far beneath an end of a flat portal, and both were beside the line by less than rounding. The
// corner was found and dropped again without end, as neither edge to it had the line strictly between its ends.
// Threshold: all converge.
TEST(StartPolicy, MixedMagnitudesDoNotStall) {
  const Body<double> a{
      .shape = sum<double>(
          sum<double>(posed<double>(Segment<double>{{-1.4562858804233265e+42, -1.4646600986172666e+48,
                                                     -0.010199207971060012},
                                                    {1.4225270237096266e-12, 1e-13, 1}},
                                    {1.5e+36, 5.526309818934695e-36, -1.5e+31}, {1, 1e-16, 0, 1e-09}),
                      posed<double>(
                          Segment<double>{{7.273836240176188e-21, 1.2214289689896366e-56, 0},
                                          {-1e-09, -1.5e+32, 1.4999999999999998e-60}},
                          {1e-15, 1e+24, 0},
                          {1.0000000000000002, 0.9999999999999999, 1.0000000000000002, 0.9999999999999999})),
          Triangle<double>{
              {-1e+47, -1e+59, -1.2264027856171044e-21}, {0, -1.4182032060679929e+32, 1e-06}, {0, 0, 0}}),
      .position = {-1.5e-58, 0, -1e-11}},
      b{.shape = sum<double>(
            Triangle<double>{
                {-1.5, 1.5e+16, 1e+52}, {1e-18, 1.5e+39, -1.5e+51}, {-1e+28, -52129.95751653442, 1e+17}},
            Segment<double>{{0, 0, 0}, {1.5e-53, 0, 1.4999999999999999e+34}}),
        .position = {1.1384063708425916e+16, -1.5000000000000002e-05, -1.5e+28},
        .displacement = {-1.1384063708425916e+16, 1.5000000000000002e-05, 1.5e+28}};
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    const auto r = cast(a, b, {.method = method, .start_policy = StartPolicy::pass_over});
    EXPECT_EQ(r.outcome, Outcome::miss) << static_cast<int>(method);
    EXPECT_LE(r.counters.supports, 64) << static_cast<int>(method);
  }
}

}  // namespace
}  // namespace graze
