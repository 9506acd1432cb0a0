#include "reports/pages/mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

namespace graze {
namespace {

using draw::Pose;
using draw::Real;
using draw::Vec;
using show::Mesh;

// Closed, convex, seen from outside: every triangle has all vertices behind it, and every edge two triangles.
void expect_convex(const Mesh& mesh, double size) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3<double> a = mesh.vertices[static_cast<std::size_t>(i)],
                       b = mesh.vertices[static_cast<std::size_t>(j)],
                       c = mesh.vertices[static_cast<std::size_t>(k)];
    const Vec3<double> n = (b - a).cross(c - a).normalized();
    for (const Vec3<double>& x : mesh.vertices) ASSERT_LE(n.dot(x - a), 1e-6 * size);
    for (const auto& side : {std::pair(i, j), std::pair(j, k), std::pair(k, i)}) ++sides[side];
  }
  for (const auto& [side, times] : sides) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(sides.count({side.second, side.first}), 1U);
  }
}

TEST(Mesh, OfABoxHasItsCornersAndEdgesAndNoDiagonal) {
  const Mesh mesh = show::mesh_of(Box<double>{{1, 2, 3}}, Vec::Zero());
  EXPECT_FALSE(mesh.curved);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(mesh.edges.size(), 12U);
  expect_convex(mesh, 4);
}

TEST(Mesh, OfFlatShapesAndPointsIsWhatTheyAre) {
  EXPECT_EQ(show::mesh_of(Point<double>{}, Vec::Zero()).vertices.size(), 1U);
  const Mesh segment = show::mesh_of(Segment<double>{{0, 0, 0}, {1, 2, 3}}, Vec::Zero());
  EXPECT_EQ(segment.edges.size(), 1U);
  EXPECT_TRUE(segment.triangles.empty());
  const Mesh triangle = show::mesh_of(Triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Vec::Zero());
  EXPECT_EQ(triangle.edges.size(), 3U);
  EXPECT_EQ(triangle.triangles.size(), 2U);  // both sides
  EXPECT_EQ(show::mesh_of(Sphere<double>{0}, Vec::UnitX()).vertices.size(), 1U);
}

TEST(Mesh, OfCurvedShapesLiesInThemAndComesNearTheirSupports) {
  const std::vector<Shape<double>> shapes = {
      Sphere<double>{2},
      Capsule<double>{0.5, 3},
      Ellipsoid<double>{{4, 1, 0.02}},
      Cylinder<double>{2, 0.1},
      Cone<double>{1, 5},
      rounded<double>(Box<double>{{1, 1, 1}}, 0.5),
      sum<double>(Cone<double>{1, 1}, Sphere<double>{1}),
      hull_of<double>(Sphere<double>{1}, translated<double>(Sphere<double>{0.2}, {4, 0, 0}))};
  for (const Shape<double>& shape : shapes) {
    const Mesh mesh = show::mesh_of(shape, Vec(1, 2, 2));
    EXPECT_TRUE(mesh.curved);
    const auto size = static_cast<double>(draw::extent(shape).diagonal);
    expect_convex(mesh, size);
    for (const Vec& n :
         {Vec(1, 0, 0), Vec(0, -1, 0), Vec(0, 0, 1), Vec(1, 1, 1), Vec(-3, 1, 2), Vec(1, 2, 2)}) {
      const Vec unit = n.normalized();
      const auto true_height = static_cast<double>(unit.dot(draw::support_point(shape, unit)));
      double height = -1e300;
      for (const Vec3<double>& x : mesh.vertices) height = std::max(height, unit.cast<double>().dot(x));
      EXPECT_LE(height, true_height + 2e-6 * size);  // no further out than its rounding to six digits
      EXPECT_GE(height, true_height - 0.02 * size);  // 40 by 20 directions
    }
  }
}

TEST(Mesh, IsFinestWhereTheShapeTouches) {
  const Vec towards = Vec(1, 2, 2).normalized();
  const Mesh mesh = show::mesh_of(Sphere<double>{1}, towards);
  // Between two rings a direction is within 0.42 of its angle of a vertex. With the place of contact as the
  // only vertex it would be the angle off, and the height short by half its square.
  const Vec side = towards.unitOrthogonal();
  for (const Real angle : {Real(1e-5), Real(1e-3), Real(0.1)}) {
    const Vec3<double> n = (std::cos(angle) * towards + std::sin(angle) * side).cast<double>();
    double height = 0;
    for (const Vec3<double>& x : mesh.vertices) height = std::max(height, n.dot(x));
    EXPECT_GE(height, 1 - 0.15 * static_cast<double>(angle * angle)) << static_cast<double>(angle);
  }
}

TEST(Mesh, HasAsManyRingsAsALengthAsksFor) {
  const Vec towards = Vec(1, 2, 2).normalized();
  const Vec side = towards.unitOrthogonal();
  std::size_t last = 0;
  for (const double length : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const int rings = show::rings_for(length, 2);
    const Mesh mesh = show::mesh_of(Sphere<double>{1}, towards, {32, 16, rings});
    EXPECT_GE(mesh.vertices.size(), last);
    last = mesh.vertices.size();
    // Anywhere within a hundredth of the first ring, and at the contact, it is off by less.
    for (Real angle = 1e-7L; angle < 0.003L; angle *= 2) {
      const Vec3<double> n = (std::cos(angle) * towards + std::sin(angle) * side).cast<double>();
      double height = 0;
      for (const Vec3<double>& x : mesh.vertices) height = std::max(height, n.dot(x));
      const auto square = static_cast<double>(angle * angle);
      EXPECT_GE(height, 1 - length - 0.15 * square) << length << " at " << static_cast<double>(angle);
    }
  }
  EXPECT_EQ(show::rings_for(1, 1), 4);
  EXPECT_EQ(show::rings_for(0, 1), 20);
}

TEST(Mesh, OfADifferenceIsTheSumOfOneAndTheOtherReflected) {
  Pose a, b;
  b.position = Vec(0, 0, 10);
  const Mesh boxes =
      show::mesh_of_difference(Box<double>{{1, 1, 1}}, a, Box<double>{{2, 3, 4}}, b, 0, Vec::Zero());
  EXPECT_EQ(boxes.vertices.size(), 8U);
  std::set<double> heights;
  for (const Vec3<double>& x : boxes.vertices) heights.insert(x[2]);
  EXPECT_EQ(heights, (std::set<double>{-15, -5}));
  const Mesh round =
      show::mesh_of_difference(Box<double>{{1, 1, 1}}, a, Box<double>{{2, 3, 4}}, b, 0.5, Vec::UnitZ());
  EXPECT_TRUE(round.curved);
  double top = -100;
  for (const Vec3<double>& x : round.vertices) top = std::max(top, x[2]);
  EXPECT_DOUBLE_EQ(top, -4.5);
}

}  // namespace
}  // namespace graze
