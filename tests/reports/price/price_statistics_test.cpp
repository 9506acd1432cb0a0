// Statistics of planted values.
#include "reports/price/price_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graze::price {
namespace {

TEST(PriceStatistics, AQuantileIsTheNearestRankAndANanIsNoValue) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  values.push_back(kNone);
  EXPECT_EQ(quantile(values, 0.5), 50);
  EXPECT_EQ(quantile(values, 0.95), 95);
  EXPECT_EQ(quantile(values, 0.99), 99);
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 1), 100);
  EXPECT_TRUE(std::isnan(quantile({kNone}, 0.5)));
  EXPECT_TRUE(std::isnan(errors_of(std::vector<double>{}).worst));
}

TEST(PriceStatistics, ASpreadIsOfTheRoundsAndTellsWhatOverlaps) {
  const std::vector<double> rounds = {1.1, 0.9, 1.0, kNone, 1.3, 1.0};
  const std::optional<Spread> spread = spread_of(rounds);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->median, 1.0);
  EXPECT_EQ(spread->low, 0.9);
  EXPECT_EQ(spread->high, 1.3);
  EXPECT_TRUE(overlap({1, 0.9, 1.1}, {1.2, 1.1, 1.3}));
  EXPECT_FALSE(overlap({1, 0.9, 1.1}, {1.2, 1.11, 1.3}));
  EXPECT_FALSE(overlap({1.2, 1.11, 1.3}, {1, 0.9, 1.1}));
  EXPECT_FALSE(spread_of(std::vector<double>{kNone}));
}

TEST(PriceStatistics, AGeometricMeanOfInverseRatiosIsOne) {
  EXPECT_DOUBLE_EQ(geometric_mean(std::vector<double>{0.5, 2, kNone}), 1);
  EXPECT_DOUBLE_EQ(mean(std::vector<double>{0.5, 2, kNone}), 1.25);
}

TEST(PriceStatistics, TheFrontIsWhatNoOtherPointBeats) {
  // The second is beaten by the first in both, the fourth ties the third's cost with more error, the last two
  // have no number.
  const std::vector<Point> points = {{1, 1e-2}, {2, 1e-1},    {3, 1e-6}, {3, 1e-5},
                                     {9, 0},    {0.5, kNone}, {kNone, 0}};
  EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, false, true, false, true, false, false}));
  // Two that are the same are both on it.
  EXPECT_EQ(pareto_front(std::vector<Point>{{1, 1}, {1, 1}}), (std::vector<bool>{true, true}));
}

TEST(PriceStatistics, ADigitThatCostsATenthIsSaidTo) {
  std::vector<Point> points;
  for (int digit = 1; digit <= 12; ++digit)
    points.push_back({.cost = 100 * std::pow(1.1, digit), .error = std::pow(10.0, -digit)});
  const std::optional<DigitPrice> price = price_of_a_digit(points);
  ASSERT_TRUE(price);
  EXPECT_NEAR(price->factor, 1.1, 1e-14);
  EXPECT_NEAR(price->digits, 11, 1e-13);
  EXPECT_DOUBLE_EQ(price->from, 110);
  EXPECT_DOUBLE_EQ(price->to, 100 * std::pow(1.1, 12));
}

// A tolerance that has to be shown can cost more than the least. A coarser answer is not worth that price.
TEST(PriceStatistics, ADigitIsPaidOnTheMethodsOwnFront) {
  const std::vector<Point> points = {{1, 1e-2}, {9, 1e-8}, {2, 1e-16}};
  const std::optional<DigitPrice> price = price_of_a_digit(points);
  ASSERT_TRUE(price);
  EXPECT_NEAR(price->factor, std::pow(2.0, 1.0 / 14), 1e-9);
}

TEST(PriceStatistics, WhereTheErrorDoesNotChangeNoDigitHasAPrice) {
  EXPECT_FALSE(price_of_a_digit(std::vector<Point>{{100, 1e-16}, {101, 1e-16}, {99, 1.1e-16}}));
  EXPECT_FALSE(price_of_a_digit(std::vector<Point>{{100, 1e-3}}));
  // An error of 0 is the finest that counts.
  const std::optional<DigitPrice> to_zero = price_of_a_digit(std::vector<Point>{{1, 1e-7}, {2, 0}});
  ASSERT_TRUE(to_zero);
  EXPECT_NEAR(to_zero->digits, 10, 1e-9);
}

TEST(PriceStatistics, ASquareRootGrowsAsThePowerOneHalf) {
  std::vector<Point> points;
  for (const double x : {8.0, 64.0, 512.0, 4096.0}) points.push_back({.cost = x, .error = 7 * std::sqrt(x)});
  EXPECT_NEAR(power_of_growth(points), 0.5, 1e-9);
  EXPECT_TRUE(std::isnan(power_of_growth(std::vector<Point>{{1, 1}})));
}

}  // namespace
}  // namespace graze::price
