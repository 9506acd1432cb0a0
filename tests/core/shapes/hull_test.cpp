#include <gtest/gtest.h>
#include <graze/hull.hpp>

#include <array>
#include <limits>

namespace graze {
namespace {

TEST(Hull, KeepsEveryVertexAsGivenDuplicatesToo) {
  const Hull<double> hull{{1, 2, 3}, {1, 2, 3}, {0, 0, 0}};
  ASSERT_EQ(hull.size(), 3u);
  EXPECT_EQ(hull.vertex(1), Vec3<double>(1, 2, 3));
}

// Every list of points names its scalar, and a hull does not keep the list.
TEST(Hull, IsMadeOfAnyListOfPointsAndOwnsThem) {
  std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Hull hull(points);
  static_assert(std::same_as<decltype(hull), const Hull<double>>);
  points.assign(4, Vec3<double>(7, 7, 7));
  ASSERT_EQ(hull.size(), 4u);
  EXPECT_EQ(hull.vertex(1), Vec3<double>(1, 0, 0));

  const std::array<Eigen::Vector3f, 2> ends = {Vec3<float>(1, 2, 3), Vec3<float>(4, 5, 6)};
  const Hull segment(ends);
  static_assert(std::same_as<decltype(segment), const Hull<float>>);
  EXPECT_EQ(segment.vertex(1), ends[1]);

  const Vec3<double> plain[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(Hull(plain).size(), 3u);
  EXPECT_EQ(Hull(std::span(plain).first(2)).size(), 2u);
  EXPECT_EQ(Hull(std::vector<Vec3<double>>(5, plain[0])).size(), 5u);
  const Hull copy(hull);  // of a hull: a copy, not a list
  EXPECT_EQ(&copy.vertex(0), &hull.vertex(0));
  const Hull braced{plain[0], plain[1]};
  EXPECT_EQ(braced.size(), 2u);
}

TEST(Hull, AdjacencyIsDerivedOfAnyListOfPoints) {
  const std::vector<Eigen::Vector3f> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Hull climbing = with_adjacency(corners);
  static_assert(std::same_as<decltype(climbing), const Hull<float>>);
  EXPECT_TRUE(climbing.has_adjacency());
  EXPECT_FALSE(Hull(corners).has_adjacency());
  EXPECT_TRUE(with_adjacency(std::span<const Vec3<float>>(corners)).has_adjacency());
  const std::vector<std::vector<std::uint32_t>> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EXPECT_TRUE(with_faces(corners, faces).has_adjacency());
  EXPECT_FALSE(with_faces(corners, {}).has_adjacency());
}

template <class T>
concept ShowsVertices = requires(T&& hull) {
  std::forward<T>(hull).vertices();
};
static_assert(ShowsVertices<Hull<double>&> && ShowsVertices<const Hull<float>&>);
static_assert(!ShowsVertices<Hull<double>>, "a view of a hull that is gone");
static_assert(!PointList<std::vector<Eigen::Vector3i>> && !PointList<std::vector<double>> &&
              !PointList<Hull<double>>);
static_assert(!std::constructible_from<Hull<double>, std::vector<Vec3<float>>>, "a scalar changes unseen");

TEST(Hull, PadsItsScanWithVertexZero) {
  const Hull<float> hull{{1, 2, 3}, {4, 5, 6}};
  ASSERT_EQ(hull.padded_size() % Hull<float>::kBlock, 0u);
  for (std::size_t k = 2; k < hull.padded_size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(hull.scan(axis)[k], hull.scan(axis)[0]);
  }
}

TEST(Hull, LargeCommonOffsetIsRemovedExactly) {
  // 1e8 + 1/8 is a double, and the vertices differ by eighths.
  const Hull<double> hull{{1e8, 0, 0}, {1e8 + 0.125, 1, 0}, {1e8 + 0.25, 0, 1}};
  const double unit = std::ldexp(1.0, hull.exponent());
  for (std::size_t k = 0; k < hull.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(hull.scan(axis)[k] * unit + hull.center()[axis], hull.vertex(k)[axis]);
    }
  }
  EXPECT_NE(hull.center()[0], 0);
  EXPECT_EQ(hull.center()[1], 0);  // y reaches from 0 to 1: nothing to remove
}

TEST(Hull, ScanIsNearOneForEveryMagnitude) {
  for (const double size : {1e-60, 1e-30, 1.0, 1e30, 1e60}) {
    const Hull<double> hull{{size, 0, 0}, {0, -size, 0}, {0, 0, size / 3}};
    double most = 0;
    for (std::size_t k = 0; k < hull.padded_size(); ++k) most = std::max(most, std::abs(hull.scan(0)[k]));
    EXPECT_GE(most, 1) << size;
    EXPECT_LT(most, 2) << size;
  }
}

TEST(Hull, NotANumberAndInfinityAreSeen) {
  EXPECT_FALSE((Hull<double>{{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}).finite());
  EXPECT_FALSE((Hull<double>{{0, 0, -kInfinity<double>}}).finite());
  EXPECT_TRUE((Hull<double>{{0, 0, std::numeric_limits<double>::max()}}).finite());
  EXPECT_FALSE(Hull<double>().finite());
}

}  // namespace
}  // namespace graze
