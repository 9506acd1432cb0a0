// A double with a running bound on its error: |x - value| <= error, x the exact number it stands for.
//
// Derivation, per operation, round to nearest, u = 2^-53, |fl(z) - z| <= u |fl(z)| + 2^-1075:
//   sum      |x1 + x2 - fl(v1 + v2)| <= e1 + e2 + u |v|
//   product  |x1 x2 - fl(v1 v2)|     <= |v1| e2 + |v2| e1 + e1 e2 + u |v| + 2^-1075
//   quotient |x1 / x2 - fl(v1 / v2)| <= (e1 + |v1 / v2| e2) / (|v2| - e2) + u |v| + 2^-1075, for |v2| > e2
//   root     |sqrt(x) - fl(sqrt(w))| <= min(e / sqrt(w), sqrt(e)) + u |v|, w = max(0, v1), for x >= 0
//   max      |max(x1, x2) - max(v1, v2)| <= max(e1, e2)
// The bound is itself computed, by fewer than 10 operations on numbers >= 0, each low by at most a factor 1 -
// u or by 2^-1075. kUp = 1 + 2^-48 > (1 - u)^-10 and kTiny = 2^-1022 cover that and underflow. A sum
// contracted with a product into one FMA rounds once instead of twice, so the bound still holds. Overflow
// makes the error infinite or NaN, and the sign unknown.
#pragma once

#include <cmath>

#include "oracles/arithmetic/number.hpp"

namespace graze::oracle {

class Filtered {
 public:
  static constexpr double kUp = 1 + 0x1p-48, kTiny = 0x1p-1022;

  Filtered() = default;
  explicit Filtered(double exact) : value_(exact) {}
  Filtered(double value, double error) : value_(value), error_(error) {}

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double error() const { return error_; }

  friend Filtered operator+(const Filtered& a, const Filtered& b) {
    const double v = a.value_ + b.value_;
    return {v, (a.error_ + b.error_ + kUnitRoundoff<double> * std::abs(v) + kTiny) * kUp};
  }
  friend Filtered operator-(const Filtered& a, const Filtered& b) {
    const double v = a.value_ - b.value_;
    return {v, (a.error_ + b.error_ + kUnitRoundoff<double> * std::abs(v) + kTiny) * kUp};
  }
  friend Filtered operator-(const Filtered& a) { return {-a.value_, a.error_}; }
  friend Filtered operator*(const Filtered& a, const Filtered& b) {
    const double v = a.value_ * b.value_;
    return {v, (std::abs(a.value_) * b.error_ + (std::abs(b.value_) + b.error_) * a.error_ +
                kUnitRoundoff<double> * std::abs(v) + kTiny) *
                   kUp};
  }
  friend Filtered operator*(const Filtered& a, double b) {
    const double v = a.value_ * b;
    return {v, (std::abs(b) * a.error_ + kUnitRoundoff<double> * std::abs(v) + kTiny) * kUp};
  }
  friend Filtered operator/(const Filtered& a, const Filtered& b) {
    const double v = a.value_ / b.value_, room = std::abs(b.value_) * (1 - 0x1p-50) - b.error_;
    if (!(room > kTiny)) return {0, kInfinity<double>};  // NaN too
    return {v, ((a.error_ + (std::abs(v) * kUp + kTiny) * b.error_) / room +
                kUnitRoundoff<double> * std::abs(v) + kTiny) *
                   kUp};
  }
  // The root of a number known not to be negative.
  friend Filtered root(const Filtered& a) {
    const double v = std::sqrt(a.value_ < 0 ? 0 : a.value_);
    const double far = std::sqrt(a.error_), near = v > 0 ? a.error_ / v : far;
    return {v, ((near < far ? near : far) + kUnitRoundoff<double> * v + kTiny) * kUp};
  }
  // The sum of the errors is taken, so that a NaN stays.
  friend Filtered max(const Filtered& a, const Filtered& b) {
    return {a.value_ > b.value_ ? a.value_ : b.value_, (a.error_ + b.error_) * kUp};
  }
  friend Filtered abs(const Filtered& a) { return {std::abs(a.value_), a.error_}; }

  friend Sign sign(const Filtered& a) {
    if (a.value_ > a.error_) return Sign::positive;
    if (a.value_ < -a.error_) return Sign::negative;
    return Sign::unknown;  // NaN too
  }

 private:
  double value_ = 0, error_ = 0;
};

}  // namespace graze::oracle
