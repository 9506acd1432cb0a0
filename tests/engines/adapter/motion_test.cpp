// The position of a body at time t: the pivot moves evenly, and the body rotates about it.
#include <gtest/gtest.h>

#include <cmath>
#include <graze_adapter.hpp>

namespace graze::adapter {
namespace {

constexpr double kRounding = 1e-14;

void expect_near(const Vector& x, const Vector& y) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(x[i], y[i], kRounding);
}

TEST(Motion, TurnsAboutItsPivot) {
  Body body;
  body.position = {1, 0, 0};
  body.orientation = rotation_of({0, 0, std::acos(-1.0) / 2});  // its x is the world's y
  body.pivot = {2, 0, 0};                                       // at (1, 2, 0)
  body.rotation = {0, 0, std::acos(-1.0)};
  body.displacement = {0, 0, 8};
  const Pose pose = pose_at(body, 0.5);
  // A quarter turn about (1, 2, 0) takes (1, 0, 0) to (3, 2, 0).
  expect_near(pose.position, {3, 2, 4});
  expect_near(rotate(pose.orientation, {1, 0, 0}), {-1, 0, 0});
  expect_near(pose.position + rotate(pose.orientation, body.pivot), {1, 2, 4});
}

TEST(Motion, WithoutATurnItIsExact) {
  Body body;
  body.position = {0.1, 0.2, 0.3};
  body.orientation = {0.6, 0.8, 0, 0};
  body.displacement = {1, 0, 0};
  const Pose pose = pose_at(body, 0);
  EXPECT_EQ(pose.position, body.position);
  EXPECT_EQ(pose.orientation.w, 0.6);
  EXPECT_EQ(pose.orientation.x, 0.8);
}

TEST(Motion, ASmallTurnIsNotLost) {
  const Quaternion q = rotation_of({1e-200, 0, 0});
  EXPECT_EQ(q.w, 1);
  EXPECT_NEAR(q.x / 5e-201, 1, kRounding);
}

TEST(Vertices, OfPolytopesAlone) {
  Shape box;
  box.type = ShapeType::box;
  box.half_extents = {1, 2, 3};
  EXPECT_EQ(vertices_of(box).size(), 8U);
  Shape ball;
  ball.type = ShapeType::sphere;
  EXPECT_TRUE(vertices_of(ball).empty());
}

}  // namespace
}  // namespace graze::adapter
