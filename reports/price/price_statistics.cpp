#include "reports/price/price_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace graze::price {
namespace {

std::vector<double> numbers(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  std::erase_if(out, [](double x) { return std::isnan(x); });
  return out;
}

// The slope of the least-squares line. NaN if x does not vary.
double slope(const std::vector<std::pair<double, double>>& points) {
  const auto n = static_cast<double>(points.size());
  double x = 0, y = 0;
  for (const auto& [px, py] : points) {
    x += px / n;
    y += py / n;
  }
  double xx = 0, xy = 0;
  for (const auto& [px, py] : points) {
    xx += (px - x) * (px - x);
    xy += (px - x) * (py - y);
  }
  return xx > 0 ? xy / xx : kNone;
}

}  // namespace

double quantile(std::vector<double> values, double q) {
  values = numbers(values);
  if (values.empty()) return kNone;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

double mean(std::span<const double> values) {
  const std::vector<double> known = numbers(values);
  if (known.empty()) return kNone;
  return std::accumulate(known.begin(), known.end(), 0.0) / static_cast<double>(known.size());
}

double geometric_mean(std::span<const double> values) {
  std::vector<double> logs = numbers(values);
  if (logs.empty()) return kNone;
  for (double& x : logs) x = std::log(x);
  return std::exp(mean(logs));
}

std::optional<Times> times_of(std::span<const double> ns) {
  const std::vector<double> known = numbers(ns);
  if (known.empty()) return {};
  return Times{.median = quantile(known, 0.5),
               .mean = mean(known),
               .p95 = quantile(known, 0.95),
               .p99 = quantile(known, 0.99),
               .worst = quantile(known, 1)};
}

ErrorQuantiles errors_of(std::span<const double> errors) {
  const std::vector<double> known = numbers(errors);
  return {.median = quantile(known, 0.5), .p99 = quantile(known, 0.99), .worst = quantile(known, 1)};
}

Work work_of(std::span<const double> counts) {
  const std::vector<double> known = numbers(counts);
  return {.mean = mean(known), .worst = quantile(known, 1)};
}

std::optional<Spread> spread_of(std::span<const double> values) {
  const std::vector<double> known = numbers(values);
  if (known.empty()) return {};
  return Spread{.median = quantile(known, 0.5), .low = quantile(known, 0), .high = quantile(known, 1)};
}

bool overlap(const Spread& l, const Spread& r) { return l.low <= r.high && r.low <= l.high; }

std::vector<bool> pareto_front(std::span<const Point> points) {
  const auto known = [](const Point& p) { return !std::isnan(p.cost) && !std::isnan(p.error); };
  std::vector<bool> front;
  for (const Point& p : points) {
    front.push_back(known(p) && std::none_of(points.begin(), points.end(), [&](const Point& q) {
                      return known(q) && q.cost <= p.cost && q.error <= p.error &&
                             (q.cost < p.cost || q.error < p.error);
                    }));
  }
  return front;
}

std::optional<DigitPrice> price_of_a_digit(std::span<const Point> points) {
  std::vector<Point> counted(points.begin(), points.end());
  for (Point& p : counted) p.error = p.error < kFinest ? kFinest : p.error;  // a NaN stays one
  const std::vector<bool> front = pareto_front(counted);
  std::vector<std::pair<double, double>> known;  // digits, log cost
  for (std::size_t i = 0; i < counted.size(); ++i) {
    if (front[i]) known.emplace_back(-std::log10(counted[i].error), std::log(counted[i].cost));
  }
  if (known.size() < 2) return {};
  std::sort(known.begin(), known.end());
  const double digits = known.back().first - known.front().first;
  if (!(digits >= 1)) return {};
  return DigitPrice{.digits = digits,
                    .factor = std::exp(slope(known)),
                    .from = std::exp(known.front().second),
                    .to = std::exp(known.back().second)};
}

double power_of_growth(std::span<const Point> x_and_y) {
  std::vector<std::pair<double, double>> known;
  for (const Point& p : x_and_y) {
    if (p.cost > 0 && p.error > 0) known.emplace_back(std::log(p.cost), std::log(p.error));
  }
  return known.size() < 2 ? kNone : slope(known);
}

}  // namespace graze::price
