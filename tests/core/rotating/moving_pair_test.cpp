// Tests the foundations of a rotating cast, namely the rotation, the placed pair and the bounds of its
// motion, against arithmetic of 50 digits.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <graze/detail/rotating/moving_pair.hpp>

#include "tests/shared/generate.hpp"
#include "tests/shared/turning_bodies.hpp"

namespace graze {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Real3 = std::array<Real, 3>;
using test::Draw;

Real3 real(const Vec3<double>& x) { return {Real(x[0]), Real(x[1]), Real(x[2])}; }
Real3 cross(const Real3& a, const Real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(const Real3& a, const Real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real3 operator+(const Real3& a, const Real3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Real3 operator-(const Real3& a, const Real3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real3 operator*(const Real& s, const Real3& a) { return {s * a[0], s * a[1], s * a[2]}; }

// q x conj(q) / |q|^2
Real3 posed(const Quaternion<double>& q, const Real3& x) {
  const Real3 v = {Real(q.x), Real(q.y), Real(q.z)};
  const Real w = q.w, norm = w * w + dot(v, v);
  const Real3 once = cross(v, x), twice = cross(v, once);
  return x + (Real(2) / norm) * (w * once + twice);
}
// Rodrigues.
Real3 turned(const Vec3<double>& w, double t, const Real3& x) {
  const Real3 omega = real(w);
  const Real rate = sqrt(dot(omega, omega));
  if (rate == 0) return x;
  const Real angle = rate * Real(t);
  const Real3 k = (Real(1) / rate) * omega;
  return cos(angle) * x + sin(angle) * cross(k, x) + ((Real(1) - cos(angle)) * dot(k, x)) * k;
}
Real3 world(const RotatingBody<double>& moving, const Vec3<double>& x, double t) {
  const Body<double>& body = moving.body;
  const Real3 center = real(body.position) + posed(body.orientation, real(moving.pivot));
  const Real3 start = real(body.position) + posed(body.orientation, real(x));
  return turned(moving.rotation, t, start - center) + center + Real(t) * real(body.displacement);
}

TEST(Turn, SineAndCosineAreWithin2ToMinus90) {
  Draw draw{71};
  for (int round = 0; round < 3000; ++round) {
    const double size = std::exp2(draw.between(-60, 29));
    const detail::TwoDoubles x = detail::two_sum(size, size * draw.between(-1, 1) * 0x1p-54);
    const detail::SineCosine seen = detail::sine_cosine(x);
    const Real angle = Real(x.hi) + Real(x.lo);
    EXPECT_LT(abs(Real(seen.sine.hi) + Real(seen.sine.lo) - sin(angle)), Real(0x1p-90)) << size;
    EXPECT_LT(abs(Real(seen.cosine.hi) + Real(seen.cosine.lo) - cos(angle)), Real(0x1p-90)) << size;
  }
}

// Every support point that the pair gives is a point of the true CSO, within its own bound. Far pivots and
// large common positions are in the draw.
TEST(MovingPair, PlacesThePointsWhereTheyAre) {
  Draw draw{72};
  double worst = 0;
  for (int round = 0; round < 400; ++round) {
    auto a = test::turning_body(draw), b = test::turning_body(draw);
    const double far = round % 3 == 0 ? 1e6 : 0.0, arm = round % 4 == 0 ? 100.0 : 1.0;
    a.body.shape = Box<double>{draw.vector<double>(1).cwiseAbs()};
    b.body.shape = Box<double>{draw.vector<double>(1).cwiseAbs()};
    a.body.position += Vec3<double>::Constant(far);
    b.body.position += Vec3<double>::Constant(far);
    a.pivot *= arm;
    detail::MovingPair pair(a, b, 0.0);
    const double unit = power_of_two(pair.cso().length_exponent());
    for (int k = 0; k < 4; ++k) {
      const double t = draw.between(0, 1);
      pair.place(t);
      const detail::CsoPoint<double> p = pair.cso().support(draw.vector<double>(1));
      const Real3 truth =
          world(a, detail::box_vertex(std::get<Box<double>>(a.body.shape).half_extents, p.vertex_a), t) -
          world(b, detail::box_vertex(std::get<Box<double>>(b.body.shape).half_extents, p.vertex_b), t);
      for (std::size_t i = 0; i < 3; ++i) {
        const Real off = abs(Real(p.w[static_cast<int>(i)]) * Real(unit) - truth[i]) / Real(unit);
        worst = std::max(worst, off.convert_to<double>() / pair.cso().point_error());
      }
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 1e-3);  // the bound is of the right size
}

// The bounds of speed and acceleration along n hold for the sets, sampled. They vanish for a ball about its
// centre, and for a capsule and a cylinder about their own axes.
TEST(Mobility, BoundsTheMotionOfTheSet) {
  Draw draw{73};
  for (int round = 0; round < 300; ++round) {
    auto a = test::turning_body(draw), b = test::turning_body(draw);
    b.body.shape = Point<double>{};
    b.rotation = b.body.displacement = Vec3<double>::Zero();
    a.body.displacement = Vec3<double>::Zero();
    detail::MovingPair pair(a, b, 0.0);
    Counters counters;
    const Vec3<double> n = unit(draw.vector<double>(1));
    const double speed = pair.mobility_a().speed(n), bend = pair.mobility_a().acceleration(n);
    constexpr int kSteps = 64;
    constexpr double kStep = 1.0 / kSteps;
    std::array<double, kSteps + 1> gap{};
    for (std::size_t k = 0; k <= kSteps; ++k) {
      pair.place(static_cast<double>(k) * kStep);
      gap[k] = pair.gap(n, counters);
    }
    const double rounding = 4 * pair.error();
    for (std::size_t k = 0; k + 1 <= kSteps; ++k) {
      EXPECT_LE(std::abs(gap[k + 1] - gap[k]), speed * kStep + rounding);
    }
    for (std::size_t k = 0; k + 2 <= kSteps; ++k) {
      // A least over points may bend down by any amount, up by no more than its points do.
      EXPECT_GE(gap[k + 1], (gap[k] + gap[k + 2]) / 2 - bend * kStep * kStep / 2 - rounding);
    }
  }
}

TEST(Mobility, OwnTurnsCannotBeSeen) {
  const auto top_speed = [](const Shape<double>& shape, const Vec3<double>& pivot, const Vec3<double>& spin) {
    const RotatingBody<double> a{.body = {.shape = shape}, .rotation = spin, .pivot = pivot};
    const RotatingBody<double> b{.body = {.shape = Point<double>{}, .position = {0, 0, 9}}};
    return detail::MovingPair(a, b, 0.0).top_speed();
  };
  const Vec3<double> zero = Vec3<double>::Zero(), along{0, 0, 50};
  EXPECT_EQ(top_speed(Sphere<double>{2}, zero, {3, 4, 5}), 0);
  EXPECT_GT(top_speed(Sphere<double>{2}, {0.5, 0, 0}, {3, 4, 5}), 0);
  EXPECT_LT(top_speed(Capsule<double>{1, 2}, {0, 0, 1}, along), 1e-13);
  EXPECT_EQ(top_speed(Cylinder<double>{1, 2}, {0, 0, 1}, along), 0);
  EXPECT_EQ(top_speed(Cone<double>{1, 2}, zero, along), 0);
  EXPECT_EQ(top_speed(Ellipsoid<double>{{1, 1, 2}}, zero, along), 0);
  EXPECT_GT(top_speed(Ellipsoid<double>{{1, 2, 2}}, zero, along), 1);
  EXPECT_EQ(top_speed(Ellipsoid<double>{{2, 2, 2}}, zero, {3, 4, 5}), 0);
  EXPECT_GT(top_speed(Ellipsoid<double>{{2, 2, 2}}, {0.5, 0, 0}, {3, 4, 5}), 0.1);
  EXPECT_GT(top_speed(Cylinder<double>{1, 2}, zero, {1, 0, 50}), 0.1);
  EXPECT_GT(top_speed(Box<double>{{1, 1, 2}}, zero, along), 1);
}

}  // namespace
}  // namespace graze
