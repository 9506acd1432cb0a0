// Balls that touch a shape from inside, against its support function.
#include <graze/detail/search/smooth/inner_ball.hpp>

#include <gtest/gtest.h>

#include <array>

#include "tests/shared/generate.hpp"

namespace graze::test {
namespace {

using detail::SolidCore;
using Kind = SolidCore::Kind;

double support_value(const SolidCore& core, const Vec3<double>& n) {
  const Vec3<double>& h = core.half;
  const double flat = std::hypot(n[0], n[1]);
  switch (core.kind) {
    case Kind::flat:
      return 0;
    case Kind::box:
      return h.dot(n.cwiseAbs());
    case Kind::ellipsoid:
      return h.cwiseProduct(n).norm();
    case Kind::cylinder:
      return h[0] * flat + h[2] * std::abs(n[2]);
    case Kind::cone:
      return std::max(h[2] * n[2], h[0] * flat - h[2] * n[2]);
  }
  return 0;
}

struct Touch {
  Vec3<double> x, n;
  Vec3<double> other;  // normal of another place that the largest ball touches, or zero if not known
};

// A place on a face or a smooth part, with its normal.
Touch touch(const SolidCore& core, Draw& draw) {
  const Vec3<double>& h = core.half;
  Touch out{Vec3<double>::Zero(), Vec3<double>::Zero(), Vec3<double>::Zero()};
  const double angle = draw.between(0, 6.28), sign = draw.between(-1, 1) < 0 ? -1 : 1,
               part = draw.between(0, 1);
  const Vec3<double> around(std::cos(angle), std::sin(angle), 0);
  switch (core.kind) {
    case Kind::flat:
      break;
    case Kind::box: {
      const int i = static_cast<int>(draw.between(0, 2.999));
      for (int k = 0; k < 3; ++k) out.x[k] = draw.between(-h[k], h[k]);
      out.x[i] = sign * h[i];
      out.n[i] = sign;
      break;
    }
    case Kind::ellipsoid: {
      out.n = unit(draw.vector<double>(1));
      const Vec3<double> y = h.cwiseProduct(out.n);
      out.x = h.cwiseProduct(y) / y.norm();
      int least = 0;
      h.minCoeff(&least);
      out.other = out.n;
      out.other[least] = -out.n[least];
      break;
    }
    case Kind::cylinder:
      out.n = part < 0.5 ? around : Vec3<double>(0, 0, sign);
      out.x = part < 0.5 ? Vec3<double>(h[0] * around + Vec3<double>(0, 0, draw.between(-h[2], h[2])))
                         : Vec3<double>(draw.between(0, h[0]) * around + Vec3<double>(0, 0, sign * h[2]));
      break;
    case Kind::cone: {
      const double slant = std::hypot(h[0], 2 * h[2]), down = draw.between(0, 1);
      out.n = part < 0.5 ? Vec3<double>(2 * h[2] / slant * around + Vec3<double>(0, 0, h[0] / slant))
                         : Vec3<double>(0, 0, -1);
      out.x = part < 0.5 ? Vec3<double>(down * h[0] * around + Vec3<double>(0, 0, h[2] * (1 - 2 * down)))
                         : Vec3<double>(draw.between(0, h[0]) * around - Vec3<double>(0, 0, h[2]));
      break;
    }
  }
  return out;
}

// The least that is left between the ball and the shape, along many directions.
double room(const SolidCore& core, const Touch& at, double r, Draw& draw) {
  const Vec3<double> center = at.x - r * at.n;
  double least = kInfinity<double>;
  const auto look = [&](const Vec3<double>& n) {
    least = std::min(least, support_value(core, n) - center.dot(n) - r);
  };
  for (int i = 0; i < 400; ++i) look(unit(draw.vector<double>(1)));
  // Away from the axis through the centre, and back: where a cylinder or a cone is touched on its other side.
  const Vec3<double> flat(center[0], center[1], 0);
  const double up = core.kind == Kind::cone ? core.half[0] / std::hypot(core.half[0], 2 * core.half[2]) : 0;
  if (flat != Vec3<double>::Zero()) {
    for (const double sign : {1.0, -1.0})
      look(Vec3<double>(sign * std::sqrt(1 - up * up) * unit(flat) + Vec3<double>(0, 0, up)));
  }
  for (int i = 0; i < 3; ++i) {
    look(Vec3<double>(Vec3<double>::Unit(i)));
    look(Vec3<double>(-Vec3<double>::Unit(i)));
  }
  if (at.other != Vec3<double>::Zero()) look(at.other);
  return least;
}

constexpr std::array kKinds = {Kind::box, Kind::ellipsoid, Kind::cylinder, Kind::cone};

TEST(InnerBall, IsInTheShape) {
  Draw draw{71};
  for (int round = 0; round < 4000; ++round) {
    const double ratio = std::pow(10.0, draw.between(-3, 0));
    SolidCore core{kKinds[std::size_t(round) % 4],
                   {draw.between(0.2, 2), draw.between(0.2, 2), ratio * draw.between(0.2, 2)}};
    if (core.kind == Kind::cylinder || core.kind == Kind::cone) core.half[1] = core.half[0];
    const Touch at = touch(core, draw);
    const double r = detail::inner_ball(core, at.x, at.n);
    ASSERT_GE(r, 0) << round;
    ASSERT_LE(r, core.half.maxCoeff() * (1 + 1e-9)) << round;
    ASSERT_GE(room(core, at, r, draw), -0x1p-46 * core.half.maxCoeff()) << round;
  }
}

// On the flat end of a long cylinder or cone, near the axis: the ball nearly fills the shape there, all around.
TEST(InnerBall, NearTheAxisIsInTheShape) {
  Draw draw{73};
  for (int round = 0; round < 2000; ++round) {
    const double radius = draw.between(0.2, 2), away = radius * std::pow(10.0, draw.between(-16, 0));
    const SolidCore core{round % 2 ? Kind::cone : Kind::cylinder,
                         {radius, radius, radius * draw.between(1, 4)}};
    const double angle = draw.between(0, 6.28);
    const Touch at{{away * std::cos(angle), away * std::sin(angle), -core.half[2]}, {0, 0, -1}, {0, 0, 0}};
    const double r = detail::inner_ball(core, at.x, at.n);
    ASSERT_GT(r, 0) << round;
    ASSERT_GE(room(core, at, r, draw), -0x1p-46 * core.half.maxCoeff()) << round << " at " << away;
  }
}

// A thousandth more, and it is out: where the largest ball touches is among the directions that are looked along.
TEST(InnerBall, IsTheLargest) {
  Draw draw{72};
  for (int round = 0; round < 4000; ++round) {
    SolidCore core{kKinds[std::size_t(round) % 4],
                   {draw.between(0.5, 2), draw.between(0.5, 2), draw.between(0.5, 2)}};
    if (core.kind == Kind::cylinder || core.kind == Kind::cone) core.half[1] = core.half[0];
    const Touch at = touch(core, draw);
    const double r = detail::inner_ball(core, at.x, at.n) * 1.001 + 1e-9;
    ASSERT_LT(room(core, at, r, draw), 0) << round << " kind " << int(core.kind);
  }
}

// For a point that is not in the shape the result gives no depth: a cone's base, at its apex.
TEST(InnerBall, IsLessThanAnyOfPointsOutside) {
  const Vec3<double> one(1, 1, 1), up(0, 0, 1);
  EXPECT_EQ(detail::inner_ball({Kind::box, one}, {1.1, 0, 1}, up), -kInfinity<double>);
  EXPECT_EQ(detail::inner_ball({Kind::cylinder, one}, {1.1, 0, 1}, up), -kInfinity<double>);
  EXPECT_EQ(detail::inner_ball({Kind::cone, one}, {0.25, 0, 1}, up), -kInfinity<double>);
  EXPECT_EQ(detail::inner_ball({Kind::cone, one}, {0.25, 0, -1.1}, Vec3<double>(-up)), -kInfinity<double>);
}

TEST(InnerBall, IsNoneAtEdgesAndOfFlatCores) {
  const Vec3<double> one(1, 1, 1), edge = unit(Vec3<double>(1, 1, 0));
  EXPECT_EQ(detail::inner_ball({Kind::box, one}, {1, 1, 0.25}, edge), 0);
  EXPECT_EQ(detail::inner_ball({Kind::cylinder, one}, {1, 0, 1}, unit(Vec3<double>(1, 0, 1))), 0);
  EXPECT_EQ(detail::inner_ball({Kind::cone, one}, {0, 0, 1}, Vec3<double>(0, 0, 1)), 0);
  EXPECT_EQ(detail::inner_ball({Kind::flat, one}, {1, 0, 0}, Vec3<double>(1, 0, 0)), 0);
  EXPECT_EQ(detail::inner_ball({Kind::ellipsoid, {1, 1, 0}}, {1, 0, 0}, Vec3<double>(1, 0, 0)), 0);
}

}  // namespace
}  // namespace graze::test
