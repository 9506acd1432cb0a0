#include <gtest/gtest.h>
#include <graze/hull.hpp>

#include <limits>

namespace graze {
namespace {

TEST(Hull, KeepsEveryVertexAsGivenDuplicatesToo) {
  const Hull<double> hull{{1, 2, 3}, {1, 2, 3}, {0, 0, 0}};
  ASSERT_EQ(hull.size(), 3u);
  EXPECT_EQ(hull.vertex(1), Vec3<double>(1, 2, 3));
}

TEST(Hull, PadsItsScanWithVertexZero) {
  const Hull<float> hull{{1, 2, 3}, {4, 5, 6}};
  ASSERT_EQ(hull.padded_size() % Hull<float>::kBlock, 0u);
  for (std::size_t k = 2; k < hull.padded_size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(hull.scan(axis)[k], hull.scan(axis)[0]);
  }
}

TEST(Hull, LargeCommonOffsetIsRemovedExactly) {
  // 1e8 + 1/8 is a double; the vertices differ by eighths.
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
