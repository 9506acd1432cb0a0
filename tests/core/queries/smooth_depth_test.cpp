// Depths of smooth bodies against their support functions: no direction of many is less deep, and the points are as far apart
// as the depth. Shallow, deep, concentric and coaxial.
#include <graze/detail/numeric/offset.hpp>
#include <graze/penetration.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/shared/generate.hpp"
#include "tests/shared/primitives.hpp"

namespace graze::test {
namespace {

// The reach of the shape along n, about its centre.
double reach(const Body<double>& body, const Vec3<double>& n) {
  const Vec3<double> m = detail::rotation_matrix(body.orientation).transpose() * n;
  const double flat = std::hypot(m[0], m[1]);
  const Shape<double>& s = body.shape;
  if (const auto* one = std::get_if<Sphere<double>>(&s)) return one->radius;
  if (const auto* one = std::get_if<Capsule<double>>(&s))
    return one->radius + one->half_height * std::abs(m[2]);
  if (const auto* one = std::get_if<Box<double>>(&s)) return one->half_extents.dot(m.cwiseAbs());
  if (const auto* one = std::get_if<Ellipsoid<double>>(&s)) return one->radii.cwiseProduct(m).norm();
  if (const auto* one = std::get_if<Cylinder<double>>(&s))
    return one->radius * flat + one->half_height * std::abs(m[2]);
  const auto& cone = std::get<Cone<double>>(s);
  return std::max(cone.half_height * m[2], cone.radius * flat - cone.half_height * m[2]);
}

TEST(SmoothDepth, IsTheLeastAndItsPointsAreAsFarApart) {
  Draw draw{81};
  int contacts = 0;
  for (int round = 0; round < 6000; ++round) {
    const int i = round % kPrimitives, j = round / kPrimitives % kPrimitives;
    if (i == kBoxPrimitive && j == kBoxPrimitive) continue;
    Body<double> a{.shape = primitive(i, draw)}, b{.shape = primitive(j, draw)};
    const bool is_coaxial = round % 4 == 1;
    if (!is_coaxial) {
      a.orientation = draw.turn<double>();
      b.orientation = draw.turn<double>();
    }
    const Vec3<double> towards = is_coaxial ? Vec3<double>(0, 0, 1) : unit(draw.vector<double>(1));
    b.position = (round % 64 == 2 ? 0.0 : draw.between(0, 1.6)) * towards;
    const auto r = penetration(a, b);
    if (r.outcome != Outcome::initially_overlapping) continue;
    ++contacts;
    const auto depth_along = [&](const Vec3<double>& n) {
      return reach(a, n) + reach(b, Vec3<double>(-n)) - n.dot(b.position);
    };
    constexpr double kSlack = 0x1p-44;
    ASSERT_NEAR(r.normal.norm(), 1, 1e-14) << round;
    ASSERT_NEAR(depth_along(r.normal), r.upper, kSlack) << round;
    ASSERT_NEAR((r.point_a - r.point_b).norm(), r.upper, r.stalled ? 1e-3 : 1e-12) << round;
    if (!r.stalled) {
      ASSERT_LE(r.upper - r.lower, kSlack) << round;
    }
    // Near the best of many directions as well.
    Vec3<double> best = r.normal;
    double least = r.upper;
    for (int k = 0; k < 600; ++k) {
      const double size = k < 300 ? 0 : std::pow(10.0, -(k - 300) / 75.0);
      const Vec3<double> about = draw.vector<double>(1);
      const Vec3<double> n = unit(Vec3<double>(k < 300 ? about : Vec3<double>(best + size * about)));
      const double depth = depth_along(n);
      ASSERT_GE(depth, r.lower - kSlack) << round;
      if (depth < least || k == 0) {
        least = depth;
        best = n;
      }
    }
  }
  EXPECT_GT(contacts, 3000);
}

// It holds no ball, as a cylinder of no height does not, and is as deep.
TEST(SmoothDepth, OfAConeWithoutHeightIsThatOfADisc) {
  Draw draw{82};
  const auto size = [&] { return draw.between(0.2, 1); };
  int contacts = 0;
  for (int round = 0; round < 4000; ++round) {
    Body<double> a{.orientation = draw.turn<double>()};
    a.shape = round % 2 ? Shape<double>(Ellipsoid<double>{{size(), size(), size()}})
                        : Shape<double>(Cylinder<double>{size(), size()});
    const double radius = size();
    Body<double> cone{.shape = Cone<double>{radius, 0}, .orientation = draw.turn<double>()};
    cone.position = draw.vector<double>(0.6);
    Body<double> disc = cone;
    disc.shape = Cylinder<double>{radius, 0};
    const auto r = penetration(a, cone);
    ASSERT_EQ(r.outcome, penetration(a, disc).outcome) << round;
    if (r.outcome != Outcome::initially_overlapping) continue;
    ++contacts;
    ASSERT_NEAR(r.upper, penetration(a, disc).upper, 0x1p-44) << round;
  }
  EXPECT_GT(contacts, 2000);
}

}  // namespace
}  // namespace graze::test
