// Sums of two roots, where they cancel and where they do not.
#include "oracles/arithmetic/root_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace graze::oracle {
namespace {

bool is(const Enclosure& x, double value) { return x.low == value && x.high == value; }

TEST(RootSum, RootsOfSquaresAreExact) {
  EXPECT_TRUE(is(enclose(RootSum{1, 1, Rational(9, 4), -1, 4}), 0.5));
  EXPECT_EQ(sign(RootSum{Rational(1, 2), 1, Rational(9, 4), -1, 4}), 0);
  EXPECT_TRUE(is(enclose(RootSum{3, -1, 0, 0, 0}), 3));
}

TEST(RootSum, RootsInARationalRatioCancelExactly) {
  EXPECT_TRUE(is(enclose(RootSum{0, 1, 8, -1, 8}), 0));
  EXPECT_EQ(sign(RootSum{0, 1, 2, -1, 8}), -1);
  EXPECT_TRUE(is(enclose(RootSum{5, 1, Rational(2, 9), -1, Rational(2, 9)}), 5));
  const Enclosure root = enclose(RootSum{0, -1, 2, 1, 8});  // sqrt 2
  EXPECT_EQ(root.high, std::sqrt(2.0));                     // the double nearest to it is above it
  EXPECT_EQ(root.low, std::nextafter(std::sqrt(2.0), 1));
}

// sqrt(x^2 + 1) - x = 1 / (2 x) nearly, at x = 2^300: 600 bits cancel.
TEST(RootSum, WhatIsLeftOfACancellationIsStillTwoNeighbours) {
  Integer x = 1;
  x <<= 300;
  const Enclosure rest = enclose(RootSum{Rational(-x), 1, Rational(x * x + 1), 0, 0});
  EXPECT_EQ(rest.high, 0x1p-301);
  EXPECT_EQ(rest.low, std::nextafter(0x1p-301, 0));
  EXPECT_EQ(sign(RootSum{Rational(-x), 1, Rational(x * x + 1), 0, 0}), 1);
  EXPECT_EQ(sign(RootSum{Rational(-x), 1, Rational(x * x - 1), 0, 0}), -1);
  const RootSum independent{0, 1, Rational(2 * x * x + 1), -1, Rational(2 * x * x + 3)};
  EXPECT_EQ(sign(independent), -1);
  EXPECT_NEAR(enclose(independent).high * 0x1p300, -1 / std::sqrt(2.0), 1e-15);
}

TEST(RootSum, MagnitudeAndNearestDouble) {
  const Enclosure size = enclose_magnitude(RootSum{0, 1, 2, -1, 3});
  EXPECT_NEAR(size.low, std::sqrt(3.0) - std::sqrt(2.0), 1e-15);
  EXPECT_EQ(size.high, std::nextafter(size.low, 1));
  EXPECT_EQ(nearest_double(RootSum{0, 1, 2, 0, 0}), std::sqrt(2.0));
  EXPECT_EQ(nearest_double(RootSum{Rational(1, 3), 0, 7, 0, 7}), 1.0 / 3);
}

}  // namespace
}  // namespace graze::oracle
