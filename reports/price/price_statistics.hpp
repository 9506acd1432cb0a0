// Statistics of many measured numbers. A NaN is left out. A result is infinite only if an input is.
#pragma once

#include <span>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

// The least value that is not below a fraction q of all (nearest rank). NaN for no values.
[[nodiscard]] double quantile(std::vector<double> values, double q);
[[nodiscard]] double mean(std::span<const double> values);
[[nodiscard]] double geometric_mean(std::span<const double> values);  // of positive values

[[nodiscard]] std::optional<Times> times_of(std::span<const double> ns);
[[nodiscard]] ErrorQuantiles errors_of(std::span<const double> errors);
[[nodiscard]] Work work_of(std::span<const double> counts);
// The median, with the least and the greatest value as low and high. With few rounds nothing finer is known.
[[nodiscard]] std::optional<Spread> spread_of(std::span<const double> values);
[[nodiscard]] bool overlap(const Spread& l, const Spread& r);

// Marks the points that no other point dominates: no other is at least as cheap and as accurate, and better in one of
// the two. NaN is dominated by all.
struct Point {
  double cost = 0, error = 0;
};
[[nodiscard]] std::vector<bool> pareto_front(std::span<const Point> points);

// The cost of one more digit, on the front of the points (nobody pays more for a coarser answer). It is a least-squares
// line of log(cost) against digits = -log10(error).
struct DigitPrice {
  double digits = 0;        // from the coarsest point to the finest
  double factor = 1;        // the factor by which one digit multiplies the cost
  double from = 0, to = 0;  // cost of the coarsest point and of the finest
};
// Errors below kFinest count as that: what rounding leaves. Nothing where the front has
// fewer than two points, or less than one digit between them: the finest answer costs no more than a coarse one.
inline constexpr double kFinest = 1e-17;
[[nodiscard]] std::optional<DigitPrice> price_of_a_digit(std::span<const Point> points);

// The power p of y = c x^p, by least squares of the logarithms. NaN for fewer than two points.
[[nodiscard]] double power_of_growth(std::span<const Point> x_and_y);

}  // namespace graze::price
