// Moving bodies in balls: poses against plain formulas, named points, and the bounds of derivatives against
// differences.
#include "oracles/curved/ball_motion.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/oracles/truth/curved_pairs.hpp"

namespace graze::oracle {
namespace {

using Vec = Vec3<double>;

Vec turned(const Vec& w, const Vec& x) {
  return w.isZero(0) ? x : Vec(Eigen::AngleAxisd(w.norm(), w.normalized()) * x);
}
Vec oriented(const Quaternion<double>& q, const Vec& x) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized() * x;
}

struct Moving {
  Body<double> body;
  corpus::Spin spin;
};

Moving random_body(CurvedPairs& make, Kind kind) {
  Moving moving;
  make.lattice = false;
  moving.body.shape = make.shape(kind);
  moving.body.position = make.vector(3);
  moving.body.orientation = make.quaternion();
  moving.body.displacement = make.vector(2);
  moving.spin = {make.vector(5), make.vector(2)};
  return moving;
}

// The position of the body's own point x at time t.
Vec world(const Moving& m, const Vec& x, double t) {
  const Vec arm = oriented(m.body.orientation, m.spin.pivot);
  const Vec from_pivot = oriented(m.body.orientation, x) - arm;
  return turned(t * m.spin.rotation, from_pivot) + m.body.position + arm + t * m.body.displacement;
}

TEST(BallMotion, PlacesPointsWhereTheFormulaDoes) {
  CurvedPairs make(1);
  const Vec reference(100, -50, 7);
  for (int i = 0; i < 50; ++i) {
    const Moving m = random_body(make, Kind::box);
    const BallMotion motion(m.body, m.spin, reference);
    const double t = make.random.uniform(0, 2);
    const BallMotion::Pose pose = motion.at(t);
    const Vec& e = std::get<Box<double>>(m.body.shape).half_extents;
    for (std::uint32_t k = 0; k < 8; ++k) {
      const Vec x(k & 1u ? e[0] : -e[0], k & 2u ? e[1] : -e[1], k & 4u ? e[2] : -e[2]);
      const NamedPoint named = motion.named({.vertex = k});
      EXPECT_EQ(named.radius.mid_double(), 0);
      EXPECT_EQ(named.inside, Answer::yes);
      const Vec at = pose.place(named).mid_double() + reference;
      EXPECT_LT((at - world(m, x, t)).norm(), 1e-12);
    }
    EXPECT_LT((pose.origin().mid_double() + reference - world(m, Vec::Zero(), t)).norm(), 1e-12);
    EXPECT_LT((pose.frame() * e + pose.origin().mid_double() + reference - world(m, e, t)).norm(), 1e-12);
    const BallVec n(make.vector(1));
    EXPECT_LT((pose.turn_back(pose.turn(n)) - n).mid_double().norm(), 1e-30);
  }
}

TEST(BallMotion, SmallAndManyTurns) {
  Body<double> body;
  body.shape = Segment<double>{Vec(0, 0, 0), Vec(2, 0, 0)};
  for (const double w : {0.0, 1e-300, 1e-20, 1e-5, 1.0, 513.0, 1e4}) {
    const BallMotion motion(body, {.rotation = Vec(0, 0, w), .pivot = Vec::Zero()});
    const BallVec at = motion.at(1).place(motion.named({.vertex = 1}));
    EXPECT_NEAR(at.mid_double()[0], 2 * std::cos(w), 1e-15);
    EXPECT_NEAR(at.mid_double()[1], 2 * std::sin(w), 2e-15);
    EXPECT_LT((at.y.high() - at.y.low()).high_double(), 1e-30);
  }
}

TEST(BallMotion, NamesPointsOfCombinators) {
  Body<double> body;
  const Quaternion<double> quarter{1, 0, 0, 1};
  body.shape = rounded<double>(
      sum<double>(Capsule<double>{0.25, 2}, posed<double>(Cylinder<double>{1, 3}, Vec(5, 0, 0), quarter)),
      0.5);
  const BallMotion motion(body, {.rotation = Vec(0, 0, 3), .pivot = Vec(1, 0, 0)});
  EXPECT_EQ(motion.vertex_count(), 2u);
  Feature feature{.vertex = 1, .offset = Vec::Zero(), .curved = {Vec(0.5, 0, 3), Vec::Zero()}};
  const NamedPoint point = motion.named(feature);
  EXPECT_EQ(point.curved_parts, 1u);
  EXPECT_EQ(point.inside, Answer::yes);
  EXPECT_EQ(point.radius.mid_double(), 0.75);
  EXPECT_LT((point.from_pivot.mid_double() - Vec(4, 0.5, 5)).norm(), 1e-15);
  feature.curved[0] = Vec(0.5, 0, 3.0001);
  EXPECT_EQ(motion.named(feature).inside, Answer::no);
  feature.vertex = 2;
  EXPECT_THROW(static_cast<void>(motion.named(feature)), std::invalid_argument);
}

// A body that does not turn is as it is about any point: nothing is measured from a pivot far out, but from
// the middle of the body.
TEST(BallMotion, ThePivotOfABodyThatDoesNotTurnIsIdle) {
  Body<double> body;
  body.shape = Segment<double>{Vec(0, 0, 0), Vec(2, 0, 0)};
  const corpus::Spin turning{.rotation = Vec(0, 0, 1), .pivot = Vec(1e9, 0, 0)};
  const corpus::Spin resting{.rotation = Vec::Zero(), .pivot = turning.pivot};
  EXPECT_EQ(BallMotion(body, turning).named({.vertex = 1}).from_pivot.mid_double(), Vec(2 - 1e9, 0, 0));
  EXPECT_EQ(BallMotion(body, resting).named({.vertex = 1}).from_pivot.mid_double(), Vec(1, 0, 0));
  EXPECT_EQ(BallMotion(body, resting).spin().pivot, Vec(1, 0, 0));
  EXPECT_EQ(BallMotion(body, turning).spin().pivot, turning.pivot);
  EXPECT_GT(BallMotion(body, turning).magnitude(), 1e9);
  EXPECT_LT(BallMotion(body, resting).magnitude(), 10);
}

// Supports along n at three times. Their second difference is that of a maximum, so it is no less than minus
// the bound (and exceeds no bound where the support jumps). The first difference is within the first bound.
TEST(BallMotion, BoundsHoldForDifferencesOfSupports) {
  CurvedPairs make(2);
  double least_slack = kInfinity<double>;
  for (int i = 0; i < 1000; ++i) {
    Moving m = random_body(make, static_cast<Kind>(i % kKinds));
    if (i % 3 == 0) {  // nearly about an own axis
      m.spin.pivot = Vec(0, 0, 1);
      m.spin.rotation = 5 * oriented(m.body.orientation, Vec(0, 0, 1)) + make.vector(1e-2);
    }
    if (i % 6 == 0) {
      m.body.shape = Ellipsoid<double>{Vec(1.5, 1.5, 0.5)};
    }
    const BallMotion motion(m.body, m.spin);
    const BallVec n(make.vector(1));
    const double t = make.random.uniform(0, 2), h = 1e-4;
    std::array<double, 3> reach;
    for (int k = 0; k < 3; ++k) {
      const Ball time = t + (k - 1) * h;
      const Ball linear = dot(n, time * motion.velocity());
      reach[static_cast<std::size_t>(k)] = (motion.support(n, time).reach - linear).mid_double();
    }
    const double first = (reach[2] - reach[0]) / (2 * h);
    const double second = (reach[2] - 2 * reach[1] + reach[0]) / (h * h);
    const double m1 = motion.first_bound(n).high_double(), m2 = motion.second_bound(n).high_double();
    EXPECT_LE(std::abs(first), m1 * (1 + 1e-9) + 1e-9);
    EXPECT_GE(second, -m2 * (1 + 1e-3) - 1e-5);
    if (m2 > 1e-3) least_slack = std::min(least_slack, (m2 + second) / m2);
  }
  EXPECT_LT(least_slack, 0.1);  // some come near
}

TEST(BallMotion, ReachIsTight) {
  const auto reach = [](const Shape<double>& shape, const Vec& pivot, const Vec& w) {
    Body<double> body;
    body.shape = shape;
    return BallMotion(body, {w, pivot}).axis_reach().high_double();
  };
  const Vec z(0, 0, 2);
  EXPECT_NEAR(reach(Box<double>{Vec(3, 4, 9)}, Vec::Zero(), z), 5, 1e-12);
  EXPECT_NEAR(reach(Box<double>{Vec(3, 4, 9)}, Vec(-3, 4, 100), z), 10, 1e-12);
  EXPECT_NEAR(reach(Sphere<double>{2}, Vec(0, 3, 0), z), 3, 1e-12);  // its ball does not turn
  EXPECT_NEAR(reach(Capsule<double>{2, 1}, Vec::Zero(), Vec(1, 0, 0)), 1, 1e-12);
  EXPECT_NEAR(reach(Cylinder<double>{2, 1}, Vec(1, 0, 0), z), 3, 1e-12);
  EXPECT_NEAR(reach(Cone<double>{2, 5}, Vec(0, 0, 1), Vec(0, 1, 0)), std::sqrt(40.0), 1e-12);
  EXPECT_NEAR(reach(Ellipsoid<double>{Vec(2, 3, 7)}, Vec::Zero(), z), 3, 1e-12);
  EXPECT_NEAR(reach(sum<double>(Box<double>{Vec(1, 0, 0)}, Box<double>{Vec(0, 1, 0)}), Vec::Zero(), z),
              std::sqrt(2.0), 1e-12);
}

TEST(BallMotion, AnOwnAxisMovesNothing) {
  for (const Shape<double>& shape : {Shape<double>(Cylinder<double>{1, 2}), Shape<double>(Cone<double>{1, 2}),
                                     Shape<double>(Ellipsoid<double>{Vec(1, 1, 3)})}) {
    Body<double> body;
    body.shape = shape;
    body.orientation = {1, 2, 3, 4};  // z goes to (22, 20, 4) / 30
    const BallMotion motion(body, {Vec(2200, 2000, 400), Vec(0, 0, 1)});
    const BallVec n(Vec(0.3, -0.7, 0.2));
    EXPECT_LT(motion.second_bound(n).high_double(), 1e-25);
    EXPECT_LT(motion.first_bound(n).high_double(), 1e-25);
  }
}

// A point of Y seen from X's turning axes, against second differences.
TEST(BallMotion, BoundsHoldForAxesThatTurn) {
  CurvedPairs make(5);
  for (int i = 0; i < 300; ++i) {
    const Moving x = random_body(make, Kind::box), y = random_body(make, Kind::segment);
    const BallMotion of_x(x.body, x.spin), of_y(y.body, y.spin);
    const NamedPoint end = of_y.named({.vertex = 1});
    const BallVec n(make.vector(1));
    const double t = make.random.uniform(0, 1), h = 1e-4;
    std::array<double, 3> value;
    for (int k = 0; k < 3; ++k) {
      const Ball time = t + (k - 1) * h;
      const BallMotion::Pose pose = of_x.at(time);
      const BallVec pivot = of_x.pivot() + time * of_x.velocity();
      value[static_cast<std::size_t>(k)] = dot(pose.turn(n), of_y.at(time).place(end) - pivot).mid_double();
    }
    const double second = (value[2] - 2 * value[1] + value[0]) / (h * h);
    const double bound = second_bound_turning(of_x, of_y, n, t - h, t + h).high_double();
    EXPECT_LE(std::abs(second), bound * (1 + 1e-3) + 1e-4);
  }
}

TEST(ChordBound, IsTheLeastOfTheParabola) {
  CurvedPairs make(9);
  int positive = 0;
  for (int i = 0; i < 2000; ++i) {
    const double s0 = make.random.uniform(-0.1, 1), s1 = make.random.uniform(-0.1, 1);
    const double bound = make.random.uniform(0, 12), d = make.random.uniform(0.1, 1.5);
    double least = kInfinity<double>;
    for (int k = 0; k <= 4000; ++k) {
      const double x = d * k / 4000;
      least = std::min(least, s0 + (s1 - s0) * x / d - bound * x * (d - x) / 2);
    }
    EXPECT_NEAR(chord_minimum(s0, s1, bound, d).mid_double(), least, 1e-5);
    EXPECT_LE(chord_minimum(s0, s1, bound, d).mid_double(), least + 1e-12);
    if (std::abs(least) > 1e-5) {
      EXPECT_EQ(chord_stays_positive(s0, s1, bound, d), least > 0);
      positive += least > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(positive, 200);
}

}  // namespace
}  // namespace graze::oracle
