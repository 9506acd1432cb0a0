// Rationals and their roots come back as the right doubles, at the ends of the range too.
#include "oracles/arithmetic/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace graze::oracle {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

TEST(RationalRounding, AThirdLiesBetweenNeighbours) {
  const Rational third(1, 3);
  EXPECT_EQ(nearest_double(third), 1.0 / 3);
  EXPECT_EQ(ceil_double(third), std::nextafter(floor_double(third), 1));
  EXPECT_LT(Rational(floor_double(third)), third);
  EXPECT_GT(Rational(ceil_double(third)), third);
  EXPECT_EQ(floor_double(-third), -ceil_double(third));
}

TEST(RationalRounding, ADoubleIsItself) {
  for (const double x : {0.0, 1.0, 0.1, -kLeast, 3 * kLeast, 0x1.fffffffffffffp-1023, kMost}) {
    EXPECT_EQ(floor_double(Rational(x)), x);
    EXPECT_EQ(ceil_double(Rational(x)), x);
    EXPECT_EQ(nearest_double(Rational(x)), x);
  }
}

TEST(RationalRounding, SubnormalsAndTheEndsOfTheRange) {
  const Rational below(Rational(kLeast) * Rational(2, 5));
  EXPECT_EQ(floor_double(below), 0);
  EXPECT_EQ(ceil_double(below), kLeast);
  EXPECT_EQ(nearest_double(below), 0);
  EXPECT_EQ(nearest_double(Rational(kLeast) / 2), 0) << "a tie, to even";
  EXPECT_EQ(nearest_double(Rational(kLeast) * 3 / 2), 2 * kLeast) << "a tie, to even";
  const Rational above(Rational(kMost) + 1);
  EXPECT_EQ(floor_double(above), kMost);
  EXPECT_EQ(ceil_double(above), kInf);
  EXPECT_EQ(nearest_double(above), kMost);
  EXPECT_EQ(nearest_double(Rational(kMost) * 2), kInf);
  EXPECT_EQ(nearest_double(Rational(kMost) * -2), -kInf);
}

TEST(RationalRounding, TiesGoToEven) {
  const Rational one(1), step(0x1p-52);
  EXPECT_EQ(nearest_double(one + step / 2), 1);
  EXPECT_EQ(nearest_double(one + step * 3 / 2), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(one + step / 2 + Rational(kLeast)), 1 + 0x1p-52);
}

TEST(RootEnclosure, SquaresAreTightAndOthersHoldTheRoot) {
  const Enclosure nine = enclose_sqrt(9);
  EXPECT_EQ(nine.low, 3);
  EXPECT_EQ(nine.high, 3);
  for (int i = 2; i < 200; ++i) {
    const Rational q(i, 7);
    const Enclosure root = enclose_sqrt(q);
    ASSERT_LE(Rational(root.low) * Rational(root.low), q);
    ASSERT_GE(Rational(root.high) * Rational(root.high), q);
    ASSERT_LE(root.high, std::nextafter(root.low, kInf));
  }
}

// sqrt(r^2 - d) - r for a tiny d: in doubles nothing is left of it, here every bit is.
TEST(RootEnclosure, ADifferenceOfNearEqualsKeepsItsBits) {
  const Rational r(3), tiny(0x1p-200);
  const Enclosure gap = enclose_radius_and_sqrt(r, -1, r * r - tiny);
  EXPECT_LE(gap.high, std::nextafter(gap.low, kInf));
  EXPECT_NEAR(gap.low / (0x1p-200 / 6), 1, 1e-15);
  const Enclosure over = enclose_radius_and_sqrt(r, -1, r * r + tiny);
  EXPECT_NEAR(over.low / (-0x1p-200 / 6), 1, 1e-15);
  EXPECT_EQ(nearest_sqrt_minus(r * r + tiny, r), 0x1p-200 / 6);
  const Enclosure sum = enclose_radius_and_sqrt(r, 1, 16);
  EXPECT_EQ(sum.low, 7);
  EXPECT_EQ(sum.high, 7);
}

}  // namespace
}  // namespace graze::oracle
