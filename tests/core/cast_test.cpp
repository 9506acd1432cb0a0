#include <gtest/gtest.h>
#include <graze/cast.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

constexpr Method kMethods[] = {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep};

template <class S>
CastOptions<S> with(Method method, Request request = Request::everything) {
  CastOptions<S> out;
  out.method = method;
  out.request = request;
  return out;
}

template <class S>
class Cast : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Cast, Scalars);

// bevy_rapier 119's scene, a ball on a floor a thousand metres wide: cancellation on the wide axes.
TYPED_TEST(Cast, BallOnAWideFloor) {
  using S = TypeParam;
  const Body<S> floor{.shape = Box<S>{{500, 500, 500}}, .position = {0, -500, 0}};
  const Body<S> ball{.shape = Sphere<S>{S(0.5166)}, .position = {3, 10, -7}, .displacement = {0, -20, 0}};
  const double toi = (10 - double(S(0.5166))) / 20;
  for (const Method method : kMethods) {
    const CastResult<S> r = cast(floor, ball, with<S>(method));
    ASSERT_EQ(r.outcome, Outcome::hit);
    // 64 u scale over |v|.
    const double slack = 64 * double(kUnitRoundoff<S>) * 1800 / 20;
    EXPECT_NEAR(r.toi_lower, toi, slack);
    EXPECT_LE(r.toi_lower, r.toi_upper);
    EXPECT_LT((r.normal - Vec3<S>(0, 1, 0)).norm(), 1e-3);
    EXPECT_NEAR(r.point_a[1], 0, slack * 20);
    EXPECT_NEAR(r.point_b[1], 0, slack * 20);
    const Vec3<S> center = ball.position + r.toi_lower * ball.displacement;
    EXPECT_NEAR((r.point_b - center).norm(), S(0.5166), slack * 20);
    // The proof is about the true shapes, and it is in double whatever the scalar.
    ASSERT_TRUE(r.proof.has_value());
    EXPECT_LE(r.proof->toi_lower, toi);
    EXPECT_GE(r.proof->toi_upper, toi);
    EXPECT_LT(r.proof->toi_upper - r.proof->toi_lower, 1e-11);
  }
}

TYPED_TEST(Cast, SpheresByTheirQuadratic) {
  using S = TypeParam;
  Draw draw{41};
  int hits = 0;
  for (int round = 0; round < 500; ++round) {
    Body<S> a{.shape = Sphere<S>{S(draw.between(0.1, 1))}}, b{.shape = Sphere<S>{S(draw.between(0.1, 1))}};
    a.position = draw.vector<S>(3);
    b.position = draw.vector<S>(3);
    b.displacement = S(1.5) * (a.position - b.position) + draw.vector<S>(1.5);
    const double R =
        double(std::get<Sphere<S>>(a.shape).radius) + double(std::get<Sphere<S>>(b.shape).radius);
    const Vec3<double> p = b.position.template cast<double>() - a.position.template cast<double>();
    const Vec3<double> v = b.displacement.template cast<double>();
    const double half_b = p.dot(v), c = p.squaredNorm() - R * R,
                 root_sq = half_b * half_b - v.squaredNorm() * c;
    if (c <= 1e-3 || std::abs(root_sq) < 1e-3 * half_b * half_b) continue;  // grazes: tests/corpus has those
    const double toi = root_sq < 0 ? kInfinity<double> : (-half_b - std::sqrt(root_sq)) / v.squaredNorm();
    const bool hit = toi >= 0 && toi <= 1;
    if (std::abs(toi - 1) < 1e-3) continue;
    hits += hit;
    for (const Method method : kMethods) {
      const CastResult<S> r = cast(a, b, with<S>(method));
      ASSERT_EQ(r.outcome, hit ? Outcome::hit : Outcome::miss) << round;
      if (!hit) continue;
      EXPECT_NEAR(r.toi_lower, toi, 2000 * double(kUnitRoundoff<S>)) << round;
    }
  }
  EXPECT_GT(hits, 50);
}

TYPED_TEST(Cast, EveryStartInContactIsReported) {
  using S = TypeParam;
  const Body<S> box{.shape = Box<S>{{1, 1, 1}}};
  for (const Vec3<S>& at : {Vec3<S>(0, 0, 0), Vec3<S>(S(0.5), 1, 0), Vec3<S>(2, 0, 0), Vec3<S>(2, 2, 0)}) {
    for (const Vec3<S>& v : {Vec3<S>(0, 0, 0), Vec3<S>(-1, 0, 0), Vec3<S>(1, 0, 0), Vec3<S>(0, 0, 5)}) {
      const Body<S> other{.shape = Box<S>{{1, 1, 1}}, .position = at, .displacement = v};
      for (const Method method : kMethods) {
        const CastResult<S> r = cast(box, other, with<S>(method));
        EXPECT_EQ(r.outcome, Outcome::initially_overlapping) << at.transpose() << " v " << v.transpose();
        EXPECT_EQ(r.toi_lower, 0);
        EXPECT_EQ(r.toi_upper, 0);
      }
    }
  }
}

TYPED_TEST(Cast, HorizonDecides) {
  using S = TypeParam;
  const Body<S> box{.shape = Box<S>{{1, 1, 1}}};
  const Body<S> ray{.shape = Point<S>{}, .position = {5, 0, 0}, .displacement = {-2, 0, 0}};
  for (const Method method : kMethods) {
    CastOptions<S> options = with<S>(method);
    for (const S t_max : {S(1), S(1.9375), S(0)}) {
      options.t_max = t_max;
      EXPECT_EQ(cast(box, ray, options).outcome, Outcome::miss) << t_max;
    }
    for (const S t_max : {S(2), S(3), kInfinity<S>}) {
      options.t_max = t_max;
      const CastResult<S> r = cast(box, ray, options);
      EXPECT_EQ(r.outcome, Outcome::hit) << t_max;
      EXPECT_NEAR(r.toi_lower, 2, 16 * kUnitRoundoff<S>) << t_max;
    }
    options.t_max = kInfinity<S>;
    const Body<S> away{.shape = Point<S>{}, .position = {5, 0, 0}, .displacement = {2, S(0.1), 0}};
    const CastResult<S> r = cast(box, away, options);
    EXPECT_EQ(r.outcome, Outcome::miss);
    EXPECT_EQ(r.proof->toi_lower, kInfinity<double>);
  }
}

TYPED_TEST(Cast, TargetDistanceRoundsTheShapes) {
  using S = TypeParam;
  const Body<S> a{.shape = Sphere<S>{1}};
  const Body<S> b{.shape = Sphere<S>{1}, .position = {10, 0, 0}, .displacement = {-10, 0, 0}};
  for (const Method method : kMethods) {
    CastOptions<S> options = with<S>(method);
    options.target_distance = 3;
    const CastResult<S> r = cast(a, b, options);
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_NEAR(r.toi_lower, 0.5, 64 * kUnitRoundoff<S>);
    // On the shapes themselves, not on the rounded ones.
    EXPECT_NEAR(r.point_a[0], 1, 64 * 10 * kUnitRoundoff<S>);
    EXPECT_NEAR(r.point_b[0], 4, 64 * 10 * kUnitRoundoff<S>);
  }
}

TYPED_TEST(Cast, RayAgainstARotatedBoxFindsTheFace) {
  using S = TypeParam;
  // (1, 0, 0, 1) rotates by exactly 90 degrees about z: half extents 1, 3, 2 stand as 3, 1, 2.
  const Body<S> box{.shape = Box<S>{{1, 3, 2}}, .orientation = {1, 0, 0, 1}};
  const Body<S> ray{.shape = Point<S>{}, .position = {8, S(0.25), S(0.5)}, .displacement = {-10, 0, 0}};
  for (const Method method : kMethods) {
    const CastResult<S> r = cast(box, ray, with<S>(method));
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_NEAR(r.toi_lower, 0.5, 64 * kUnitRoundoff<S>);
    EXPECT_NEAR(r.normal[0], 1, 64 * kUnitRoundoff<S>);
  }
}

TEST(CastCost, NothingIsComputedThatWasNotAskedFor) {
  Draw draw{42};
  const Body<double> a{.shape = draw.hull<double>(20, 1)};
  Body<double> b{.shape = draw.hull<double>(20, 1), .position = {4, 0, 0}, .displacement = {-5, 0, 0}};
  for (const Method method : kMethods) {
    const auto verdict = cast(a, b, with<double>(method, Request::verdict));
    const auto all = cast(a, b, with<double>(method, Request::everything));
    ASSERT_EQ(verdict.outcome, Outcome::hit);
    EXPECT_FALSE(verdict.proof.has_value());
    EXPECT_EQ(verdict.normal, Vec3<double>(Vec3<double>::Zero()));
    EXPECT_EQ(verdict.point_a, Vec3<double>(Vec3<double>::Zero()));
    EXPECT_EQ(verdict.toi_lower, all.toi_lower);
    EXPECT_LT(verdict.counters.supports, all.counters.supports) << "a proof costs support calls";
    const auto normal = cast(a, b, with<double>(method, Request::normal | Request::witnesses));
    EXPECT_EQ(normal.counters.supports, verdict.counters.supports) << "a normal and witnesses cost none";
    EXPECT_FALSE(normal.proof.has_value());
  }
  // GJK's casts never look for a portal where they meet contact, MPR never solves for a closest point.
  EXPECT_EQ(
      cast(a, b, with<double>(Method::conservative_advancement, Request::verdict)).counters.portal_steps, 0);
  EXPECT_EQ(cast(a, b, with<double>(Method::gjk_ray_cast, Request::verdict)).counters.portal_steps, 0);
  EXPECT_EQ(cast(a, b, with<double>(Method::mpr_sweep, Request::verdict)).counters.gjk_iterations, 0);
}

TEST(CastTolerance, LooserIsCheaperAndStillABracket) {
  Draw draw{43};
  long long loose_supports = 0, tight_supports = 0;
  for (int round = 0; round < 200; ++round) {
    const Body<double> a{.shape = draw.hull<double>(20, 1)};
    Body<double> b{.shape = Sphere<double>{0.5}, .position = {4, 0, 0}, .displacement = {-5, 0.2, 0}};
    for (const Method method : kMethods) {
      CastOptions<double> options = with<double>(method, Request::verdict);
      const auto tight = cast(a, b, options);
      options.tolerance = 1e-3;
      const auto loose = cast(a, b, options);
      if (tight.outcome != Outcome::hit || loose.outcome != Outcome::hit) continue;
      EXPECT_LE(loose.toi_lower, tight.toi_lower + 1e-12);
      EXPECT_GE(loose.toi_upper, tight.toi_lower - 1e-12);
      if (method == Method::mpr_sweep) {
        loose_supports += loose.counters.supports;
        tight_supports += tight.counters.supports;
      }
    }
  }
  EXPECT_LT(loose_supports, tight_supports);
}

TEST(CastBudget, RunningOutIsSaidAndKeepsABracket) {
  Draw draw{44};
  int stalled = 0;
  for (int round = 0; round < 100; ++round) {
    const Body<double> a{.shape = draw.hull<double>(60, 1)};
    const Body<double> b{
        .shape = draw.hull<double>(60, 1), .position = {4, 0.3, 0.2}, .displacement = {-8, 0, 0}};
    for (const Method method : kMethods) {
      CastOptions<double> options = with<double>(method, Request::verdict);
      const double toi = cast(a, b, options).toi_lower;
      options.max_iterations = 2;
      const auto r = cast(a, b, options);
      if (r.outcome != Outcome::not_converged) continue;
      ++stalled;
      EXPECT_LE(r.toi_lower, toi + 1e-12);
      EXPECT_GE(r.toi_upper, toi - 1e-12);
    }
  }
  EXPECT_GT(stalled, 100);
}

}  // namespace
}  // namespace graze
