// Eigen's quaternions and isometries are taken as orientations and poses.
#include <gtest/gtest.h>

#include <graze/cast.hpp>
#include <graze/eigen.hpp>
#include <graze/line.hpp>
#include <graze/rotating_body.hpp>
#include <numbers>

namespace graze {
namespace {

template <class S>
class EigenTypes : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(EigenTypes, Scalars);

TYPED_TEST(EigenTypes, AQuaternionIsTakenNumberByNumber) {
  using S = TypeParam;
  const Eigen::Quaternion<S> q(S(0.25), S(-1), S(2), S(3));  // not of length one
  const Body<S> body{.shape = Box<S>{{1, 2, 3}}, .orientation = q};
  EXPECT_EQ(body.orientation.w, S(0.25));
  EXPECT_EQ(body.orientation.x, S(-1));
  EXPECT_EQ(body.orientation.y, S(2));
  EXPECT_EQ(body.orientation.z, S(3));

  const S numbers[] = {1, 2, 3, 4};  // x, y, z, w
  const Quaternion<S> mapped = Eigen::Map<const Eigen::Quaternion<S>>(numbers);
  EXPECT_EQ(mapped.w, S(4));
  EXPECT_EQ(mapped.x, S(1));

  const RotatingBody<S> turning{.body = {.orientation = Eigen::Quaternion<S>::UnitRandom()}};
  EXPECT_FALSE(turning.body.orientation.is_identity());
  EXPECT_TRUE(Quaternion<S>(Eigen::Quaternion<S>::Identity()).is_identity());
}

// No number changes its scalar unseen.
template <class To, class From>
constexpr bool kConverts = std::is_convertible_v<From, To>;
static_assert(kConverts<Quaternion<double>, Eigen::Quaterniond> &&
              kConverts<Quaternion<float>, Eigen::Quaternionf>);
static_assert(!kConverts<Quaternion<double>, Eigen::Quaternionf> &&
              !kConverts<Quaternion<float>, Eigen::Quaterniond>);
static_assert(!kConverts<Quaternion<double>, double> && !kConverts<Quaternion<double>, Eigen::Vector4d>);
static_assert(std::is_trivially_copyable_v<Quaternion<double>> && std::is_aggregate_v<Body<double>>);

// How long a body is along x, through its middle.
template <class S>
S length_in_x(const Body<S>& body) {
  const LineResult<S> through =
      line(body, Body<S>{.shape = Point<S>{}, .position = body.position, .displacement = {1, 0, 0}});
  EXPECT_EQ(through.outcome, Outcome::hit);
  return through.out_upper - through.in_lower;
}

TYPED_TEST(EigenTypes, AnIsometryPlacesABody) {
  using S = TypeParam;
  Eigen::Transform<S, 3, Eigen::Isometry> pose = Eigen::Transform<S, 3, Eigen::Isometry>::Identity();
  pose.translate(Vec3<S>(4, 5, 6));
  pose.rotate(Eigen::AngleAxis<S>(std::numbers::pi_v<S> / 3, Vec3<S>(0, 0, 1)));
  const Body<S> body = body_at(Box<S>{{1, 2, 3}}, pose, {0, 0, -7});
  EXPECT_EQ(body.position, Vec3<S>(4, 5, 6));
  EXPECT_EQ(body.displacement, Vec3<S>(0, 0, -7));
  // By 60 degrees about z: cos 30 and sin 30.
  const S near = 4 * kUnitRoundoff<S>;
  EXPECT_NEAR(body.orientation.w, std::sqrt(S(0.75)), near);
  EXPECT_NEAR(body.orientation.x, 0, near);
  EXPECT_NEAR(body.orientation.y, 0, near);
  EXPECT_NEAR(body.orientation.z, S(0.5), near);

  // The box is 2 / cos 60 long along x.
  Body<S> still = body;
  still.displacement = Vec3<S>::Zero();
  EXPECT_NEAR(length_in_x(still), S(4), 64 * kUnitRoundoff<S>);
  const Body<S> shape{.shape = posed(Box<S>{{1, 2, 3}}, pose)};
  const LineResult<S> through =
      line(shape, Body<S>{.shape = Point<S>{}, .position = {0, 5, 6}, .displacement = {1, 0, 0}});
  ASSERT_EQ(through.outcome, Outcome::hit);
  EXPECT_NEAR(through.in_lower, S(2), 64 * kUnitRoundoff<S>);
  EXPECT_NEAR(through.out_upper, S(6), 64 * kUnitRoundoff<S>);
}

TYPED_TEST(EigenTypes, AHalfTurnIsOneToo) {
  using S = TypeParam;
  Eigen::Transform<S, 3, Eigen::Isometry> pose = Eigen::Transform<S, 3, Eigen::Isometry>::Identity();
  pose.linear() = Vec3<S>(-1, 1, -1).asDiagonal();  // about y
  const Quaternion<S> q = orientation_of(pose);
  EXPECT_EQ(std::abs(q.y), S(1));
  EXPECT_EQ(q.w, S(0));
}

}  // namespace
}  // namespace graze
