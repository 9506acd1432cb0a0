// BallMotion and SweptBody bound a moving body of any shape. The reference is supports that other code
// computes (ball_body.hpp), in balls, so that no tolerance is needed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "oracles/curved/ball_motion.hpp"
#include "oracles/curved/whole_turns.hpp"
#include "tests/oracles/curved/any_body.hpp"

namespace graze::oracle {
namespace {

using Vec = Vec3<double>;

constexpr int kBodies = 2000;

// A point of a body, or a support value, is known to some 2^-100 of the body's size. If two values are equal,
// neither is certainly less.
void expect_at_most(const Ball& l, const Ball& r, const char* what, int seed) {
  EXPECT_FALSE(certainly_less(r, l)) << what << ", body " << seed << ": " << l.mid_double() << " beyond "
                                     << r.mid_double();
}

TEST(BodyBounds, NoPointIsFartherFromAxisAndPivotThanTheCoreAndItsBall) {
  AnyBody any(11);
  int near_axis = 0, near_pivot = 0;
  for (int i = 0; i < kBodies; ++i) {
    const MovingBody moving = any.body(i % 4);
    const BallMotion motion(moving.body, moving.spin);
    const BallVec u = (Ball(1) / norm(motion.rotation())) * motion.rotation();
    const Ball from_axis = motion.axis_reach() + motion.ball(),
               from_pivot = motion.pivot_reach() + motion.ball();
    for (int k = 0; k < 12; ++k) {
      const BallVec n(any.make.vector(1));
      const BallVec x = motion.support(n, 0).point - motion.pivot();
      const Ball across = norm(cross(u, x));
      expect_at_most(across, from_axis, "distance from the axis", i);
      expect_at_most(norm(x), from_pivot, "distance from the pivot", i);
      expect_at_most(dot(u, x), motion.axis_high() + motion.ball(), "height", i);
      expect_at_most(motion.axis_low() - motion.ball(), dot(u, x), "depth", i);
      near_axis += across.mid_double() > 0.9 * from_axis.mid_double() ? 1 : 0;
      near_pivot += norm(x).mid_double() > 0.9 * from_pivot.mid_double() ? 1 : 0;
    }
  }
  EXPECT_GT(near_axis, 12 * kBodies / 4);
  EXPECT_GT(near_pivot, 12 * kBodies / 4);
}

TEST(BodyBounds, NoAngleLeavesWhatAWholeTurnSweeps) {
  AnyBody any(12);
  int near = 0, beyond_core = 0;
  for (int i = 0; i < kBodies; ++i) {
    const MovingBody moving = any.body(i % 4);
    const BallMotion motion(moving.body, moving.spin);
    const std::optional<SweptBody> swept = SweptBody::of(motion);
    ASSERT_TRUE(swept);
    const BallVec n(any.make.vector(1));
    Ball most;
    const double t = any.make.random.uniform(0, 2);
    const Ball all = swept->reach(motion, n, t, 0, 2) - dot(n, motion.pivot() + Ball(t) * motion.velocity());
    // The same angles at any time: the pivot's way is taken out.
    for (int k = 0; k < 12; ++k) {
      const Ball at = any.make.random.uniform(0, 2);
      const Ball one = motion.support(n, at).reach - dot(n, motion.pivot() + at * motion.velocity());
      expect_at_most(one, all, "support", i);
      most = k == 0 ? one : max(most, one);
    }
    near += most.mid_double() > 0.9 * all.mid_double() ? 1 : 0;
    const Ball core = all - norm(n) * motion.ball();
    beyond_core += certainly_less(core, most) ? 1 : 0;
  }
  EXPECT_GT(near, kBodies / 20);         // it gives away what a cylinder is more than the body,
  EXPECT_GT(beyond_core, kBodies / 20);  // and without the ball it would be wrong
}

// Over any span. A wheel that spins about its own axis hardly changes, whatever its points do.
TEST(BodyBounds, NoTimeOfASpanLeavesTheReachOfASolidOfRevolution) {
  AnyBody any(15);
  int spans = 0;
  std::vector<double> tight;
  for (int i = 0; i < 2 * kBodies; ++i) {
    MovingBody moving = any.body(i % 2);
    const Vec3<double> own = BallRotation(moving.body.orientation).mid_double().col(2);
    if (i % 4 == 0) {
      moving.body.shape = i % 3 == 0   ? Shape<double>(Cylinder<double>{1, 0.5})
                          : i % 3 == 1 ? Shape<double>(Cone<double>{1, 0.5})
                                       : Shape<double>(Ellipsoid<double>{{1, 1, 0.5}});
      moving.spin.pivot = Vec(0, 0, any.make.number(1));
      moving.spin.rotation = 50 * own + any.make.vector(1e-4);
    }
    const BallMotion motion(moving.body, moving.spin);
    const double begin = any.make.random.uniform(0, 1), end = any.make.random.uniform(begin, 2);
    const BallVec n = i % 8 == 0 ? BallVec(Vec(own.cross(any.make.vector(1)))) : BallVec(any.make.vector(1));
    const std::optional<Ball> reach = motion.own_reach(n, begin, end);
    if (!reach) continue;
    ++spans;
    Ball least(kInfinity<double>);
    for (int k = 0; k <= 16; ++k) {
      const Ball t = Ball(begin) + Ball(k / 16.0) * (Ball(end) - Ball(begin));
      const Ball one = motion.support(n, t).reach - dot(n, motion.pivot() + t * motion.velocity()) -
                       norm(n) * motion.ball();
      expect_at_most(one, *reach, "reach", i);
      least = min(least, *reach - one);
    }
    if (i % 8 == 0) tight.push_back(least.mid_double());
  }
  std::sort(tight.begin(), tight.end());
  EXPECT_GT(spans, kBodies / 2);
  EXPECT_LT(tight[tight.size() / 2], 1e-7);
}

// A ball is one whatever it is called.
TEST(BodyBounds, ABallByAnyNameSweepsTheSame) {
  const Shape<double> balls[] = {
      Sphere<double>{2},
      Ellipsoid<double>{Vec(2, 2, 2)},
      Capsule<double>{2, 0},
      rounded<double>(Point<double>{}, 2),
      rounded<double>(Cylinder<double>{0, 0}, 2),
      sum<double>(Sphere<double>{1.5}, Ellipsoid<double>{Vec(0.5, 0.5, 0.5)}),
      hull_of<double>(Sphere<double>{2}, Sphere<double>{1}),
      posed<double>(Ellipsoid<double>{Vec(2, 2, 2)}, Vec(0, 0, 0), Quaternion<double>{1, 2, 3, 4}),
  };
  for (const Shape<double>& shape : balls) {
    Body<double> body;
    body.shape = shape;
    const BallMotion motion(body, {Vec(0, 0, 7), Vec(-5, 0, 3)});
    EXPECT_EQ(motion.ball().mid_double(), 2);
    EXPECT_NEAR(motion.axis_reach().mid_double(), 5, 1e-30);
    EXPECT_EQ(SweptBody::of(motion)->reach(motion, BallVec(Vec(0, 1, 0)), 0, 0, 1).mid_double(), 7);
    EXPECT_EQ(SweptBody::of(motion)->reach(motion, BallVec(Vec(0, 0, 1)), 0, 0, 1).mid_double(), 2);
    // From the pivot, at (-5, 0, 3).
    EXPECT_NEAR(motion.pivot_reach().mid_double(), std::sqrt(34), 1e-15);
  }
}

// A maximum of functions that bend by no more than M lies above its chord by no more than M d^2 / 8 in the
// middle. It changes by no more than the first bound.
TEST(BodyBounds, SupportsBendAndChangeNoFasterAlongAxesOfTheWorld) {
  AnyBody any(13);
  double least_slack = kInfinity<double>;
  for (int i = 0; i < kBodies; ++i) {
    MovingBody moving = any.body(i % 4);
    if (i % 3 == 0) {  // nearly about the own axis of a solid of revolution
      moving.spin.pivot = Vec(0, 0, any.make.number(1));
      const Vec3<double> own = BallRotation(moving.body.orientation).mid_double().col(2);
      moving.spin.rotation = 5 * own + any.make.vector(1e-2);
    }
    const BallMotion motion(moving.body, moving.spin);
    const BallVec n(any.make.vector(1));
    const double t = any.make.random.uniform(0, 2), d = std::ldexp(1.0, -any.make.random.integer(0, 20));
    const auto reach = [&](double at) {
      return motion.support(n, at).reach - Ball(at) * dot(n, motion.velocity());
    };
    const Ball first = reach(t), last = reach(t + d), middle = reach(t + d / 2);
    expect_at_most(abs(last - first), Ball(d) * motion.first_bound(n), "first difference", i);
    const Ball above = middle - Ball(0.5) * (first + last), room = Ball(d * d / 8) * motion.second_bound(n);
    expect_at_most(above, room, "second difference", i);
    if (room.is_positive()) least_slack = std::min(least_slack, 1 - (above / room).mid_double());
  }
  EXPECT_LT(least_slack, 0.05);
}

TEST(BodyBounds, SupportsBendNoFasterAlongAxesThatTurn) {
  AnyBody any(14);
  double least_slack = kInfinity<double>;
  for (int i = 0; i < kBodies; ++i) {
    const MovingBody x = any.body(0);
    MovingBody y = any.body(i % 4);
    if (i % 4 == 0) y.spin.rotation.setZero();
    if (i % 4 == 1) y.spin.rotation = x.spin.rotation;
    const BallMotion of_x(x.body, x.spin), of_y(y.body, y.spin);
    const BallVec n(any.make.vector(1));
    const double t = any.make.random.uniform(0, 2), d = std::ldexp(1.0, -any.make.random.integer(0, 20));
    const auto reach = [&](double at) {
      const BallVec m = of_x.at(at).turn(n);
      return of_y.support(m, at).reach - dot(m, of_x.pivot() + Ball(at) * of_x.velocity());
    };
    const Ball above = reach(t + d / 2) - Ball(0.5) * (reach(t) + reach(t + d));
    const Ball room = Ball(d * d / 8) * second_bound_turning(of_x, of_y, n, t, t + d);
    expect_at_most(above, room, "second difference", i);
    if (room.is_positive()) least_slack = std::min(least_slack, 1 - (above / room).mid_double());
  }
  EXPECT_LT(least_slack, 0.5);
}

// In the world the body is the same. Its motion is bounded about a pivot amid the body, so neither the place of
// its own frame nor the case's pivot enters the bounds.
TEST(BodyBounds, ABodyAtRestIsBoundedByItsOwnSizeWhereverItsFrameIs) {
  AnyBody any(15);
  for (int i = 0; i < kBodies; ++i) {
    MovingBody near = any.body(i % 4), far = near;
    near.spin.rotation.setZero();
    const Vec3<double> out = std::ldexp(1.0, any.make.random.integer(0, 30)) * Vec(3, -5, 7);
    far.body.shape = posed<double>(near.body.shape, out, Quaternion<double>{});
    far.body.orientation = near.body.orientation = Quaternion<double>{};
    far.body.position = near.body.position - out;
    far.spin = {Vec::Zero(), any.make.vector(1e9)};
    const BallMotion one(near.body, near.spin), other(far.body, far.spin);
    Ball size;
    for (int k = 0; k < 3; ++k) {
      const BallVec n(Vec(Vec::Unit(k)));
      const Ball width = one.support(n, 0).reach + one.support(-n, 0).reach;
      size = size + width * width;
    }
    // The middle of the bounds is a double, rounded where it is farther out.
    const Ball rounding = Ball(0x1p-51) * norm(BallVec(out));
    expect_at_most(one.pivot_reach(), sqrt(size), "reach", i);
    expect_at_most(other.pivot_reach(), sqrt(size) + rounding, "reach far out", i);
  }
}

TEST(BodyBounds, SlopesStayPositiveWhereNoLineBelowThemCrossesZero) {
  AnyBody any(16);
  int positive = 0;
  for (int i = 0; i < 2000; ++i) {
    const double s0 = any.make.random.uniform(-0.1, 1), s1 = any.make.random.uniform(-0.1, 1);
    const double d = any.make.random.uniform(0.1, 1.5), f = any.make.random.uniform(-1, 4);
    const double r = any.make.random.uniform(-1, 4);
    double least = std::min(s0, s1);
    for (int k = 0; k <= 4000; ++k) {
      const double x = d * k / 4000;
      least = std::min(least, std::max(s0 - f * x, s1 - r * (d - x)));
    }
    if (std::abs(least) < 1e-2) continue;
    EXPECT_EQ(slopes_stay_positive(s0, s1, f, r, d), least > 0) << s0 << " " << s1 << " " << f << " " << r;
    positive += least > 0 ? 1 : 0;
  }
  EXPECT_GT(positive, 200);
}

}  // namespace
}  // namespace graze::oracle
