// Support values against points of the shapes, and boxes that hold them.
#include "corpus/support_value.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

#include "corpus/random.hpp"

namespace graze::corpus {
namespace {

const Vec3<double> kUp(0, 0, 1);

TEST(SupportValue, OfRoundShapesIsTheClosedForm) {
  const Vec3<double> n(3, 0, 4);
  EXPECT_DOUBLE_EQ(support_value(Sphere<double>{2}, n), 10);
  EXPECT_DOUBLE_EQ(support_value(Capsule<double>{2, 1}, n), 14);
  EXPECT_DOUBLE_EQ(support_value(Cylinder<double>{2, 1}, n), 10);
  EXPECT_DOUBLE_EQ(support_value(Cone<double>{2, 1}, n), 4);
  EXPECT_DOUBLE_EQ(support_value(Cone<double>{2, 1}, -n), 10);
  EXPECT_DOUBLE_EQ(support_value(Cone<double>{2, 1}, Vec3<double>(3, 0, 0)), 6);
  EXPECT_DOUBLE_EQ(support_value(Ellipsoid<double>{{4, 9, 0}}, n), 12);
  EXPECT_DOUBLE_EQ(support_value(Ellipsoid<double>{{1, 9, 1}}, n), 5);
}

TEST(SupportValue, OfCombinatorsFollowsFromTheParts) {
  const Vec3<double> n(3, 0, 4);
  const Shape<double> box = Box<double>{{1, 1, 1}}, ball = Sphere<double>{2};
  EXPECT_DOUBLE_EQ(support_value(box, n), 7);
  EXPECT_DOUBLE_EQ(support_value(sum<double>(box, ball), n), 17);
  EXPECT_DOUBLE_EQ(support_value(hull_of<double>(box, ball), n), 10);
  EXPECT_DOUBLE_EQ(support_value(rounded<double>(box, 2), n), 17);
  EXPECT_DOUBLE_EQ(support_value(translated<double>(box, Vec3<double>(0, 5, 1)), n), 11);
  EXPECT_DOUBLE_EQ(support_value(swept<double>(box, Vec3<double>(2, 0, 0)), n), 13);
  // A quarter turn about x brings (0, 1, 0) to (0, 0, 1).
  const Shape<double> turned = posed<double>(Segment<double>{Vec3<double>::Zero(), Vec3<double>(0, 7, 0)},
                                             Vec3<double>::Zero(), {1, 1, 0, 0});
  EXPECT_DOUBLE_EQ(support_value(turned, kUp), 7);
  EXPECT_DOUBLE_EQ(support_value(turned, -kUp), 0);
}

TEST(SupportValue, OfNothingIsMinusInfinity) {
  EXPECT_EQ(support_value(Hull<double>(), kUp), -kInfinity<double>);
  EXPECT_EQ(support_value(Sum<double>(), kUp), -kInfinity<double>);
  EXPECT_EQ(support_value(HullOf<double>(), kUp), -kInfinity<double>);
  EXPECT_EQ(support_value(Posed<double>(), kUp), -kInfinity<double>);
}

TEST(Bounds, HoldTheTurnedVertices) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const auto vector = [&] {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      return Vec3<double>(x, y, random.uniform(-1, 1));
    };
    const Vec3<double> a = vector(), b = vector(), c = vector(), v = vector();
    const Quaternion<double> q{random.uniform(-1, 1), v[0], v[1], v[2]};
    const Bounds box = bounds(Triangle<double>{a, b, c}, q);
    const Eigen::Quaterniond unit = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
    Vec3<double> low = unit * a, high = low;
    for (const Vec3<double>& x : {b, c}) {
      low = low.cwiseMin(unit * x);
      high = high.cwiseMax(unit * x);
    }
    EXPECT_LE((box.low - low).cwiseAbs().maxCoeff(), 1e-14);  // 50 roundings of numbers up to 1
    EXPECT_LE((box.high - high).cwiseAbs().maxCoeff(), 1e-14);
  }
}

}  // namespace
}  // namespace graze::corpus
