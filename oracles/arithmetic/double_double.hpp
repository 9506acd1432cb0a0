// A double-double with a running bound on its error: |x - (high + low)| <= error. An exact operation adds
// nothing to the error, so ties between short numbers (integers, aligned boxes) come out as exact zeros.
//
// Error-free transformations [Dekker 1971, and Knuth, TAOCP 2, 4.2.2], round to nearest, gradual underflow:
//   two_sum(a, b)      s + e = a + b exactly, s = fl(a + b), unless it overflows
//   two_product(a, b)  p + e = a b exactly, p = fl(a b), unless it overflows or 0 < |p| < 2^-960
// Each step knows the terms that it discards, and their magnitude goes into the error:
//   sum      a + b = s0 + e0 + s1 + e1,  (s0,e0) = two_sum(a0,b0), (s1,e1) = two_sum(a1,b1),
//            (t,e2) = two_sum(e0,s1),  result two_sum(s0,t),  discarded e1, e2.
//   product  a b = a0 b0 + a0 b1 + a1 b0 + a1 b1,
//            (p,q) = two_product(a0,b0), p1 = fl(a0 b1), p2 = fl(a1 b0),
//            (t1,f1) = two_sum(p1,p2), (t2,f2) = two_sum(q,t1),  result two_sum(p,t2),
//            discarded f1, f2, a1 b1, and the roundings of p1 and p2, at most u |p1| + u |p2|,
//            inherited (|a0|+|a1|) eb + (|b0|+|b1|) ea + ea eb.
// The bound is computed by fewer than 20 operations on numbers >= 0: kUp = 1 + 2^-47 pays for their rounding,
// kTiny = 2^-1000 for underflow, added wherever a factor is not a plain double or the product is tiny.
// Overflow leaves a NaN or an infinite error, and the sign unknown.
#pragma once

#include <cmath>
#include <limits>

#include "oracles/arithmetic/number.hpp"

namespace graze::oracle {

// x as a rounded double that no later sum may fuse with the product it came from. Without FMA instructions
// nothing can be fused.
[[nodiscard]] inline double rounded(double x) {
#if defined(__x86_64__) && !defined(__FMA__)
  return x;
#else
  volatile double stored = x;
  return stored;
#endif
}

struct DoublePair {
  double high, low;
};

[[nodiscard]] inline DoublePair two_sum(double a, double b) {
  const double s = a + b, b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}
[[nodiscard]] inline DoublePair two_product(double a, double b) {
  const double p = rounded(a * b);
  return {p, std::fma(a, b, -p)};
}

class Extended {
 public:
  static constexpr double kUp = 1 + 0x1p-47, kTiny = 0x1p-1000, kProductExactAbove = 0x1p-960;

  Extended() = default;
  explicit Extended(double exact) : high_(exact) {}

  friend Extended operator+(const Extended& a, const Extended& b) {
    const DoublePair s = two_sum(a.high_, b.high_), r = two_sum(a.low_, b.low_), t = two_sum(s.low, r.high);
    return {two_sum(s.high, t.high), (a.error_ + b.error_ + (std::abs(r.low) + std::abs(t.low))) * kUp};
  }
  friend Extended operator-(const Extended& a) { return {{-a.high_, -a.low_}, a.error_}; }
  friend Extended operator-(const Extended& a, const Extended& b) { return a + -b; }
  friend Extended operator*(const Extended& a, const Extended& b) {
    const DoublePair p = two_product(a.high_, b.high_);
    const bool plain = (a.low_ == 0) & (b.low_ == 0) & (a.error_ == 0) & (b.error_ == 0);
    if (plain) {
      if (a.high_ == 0 || b.high_ == 0) return {p, 0};
      const double magnitude = std::abs(p.high);
      const bool finite = magnitude <= std::numeric_limits<double>::max();
      return {p, !finite ? kInfinity<double> : magnitude > kProductExactAbove ? 0 : kTiny};
    }
    const double p1 = rounded(a.high_ * b.low_), p2 = rounded(a.low_ * b.high_);
    const DoublePair t1 = two_sum(p1, p2), t2 = two_sum(p.low, t1.high);
    const double discarded = std::abs(t1.low) + std::abs(t2.low) + std::abs(a.low_ * b.low_) +
                             kUnitRoundoff<double> * (std::abs(p1) + std::abs(p2));
    const double inherited = (std::abs(a.high_) + std::abs(a.low_)) * b.error_ +
                             (std::abs(b.high_) + std::abs(b.low_) + b.error_) * a.error_;
    return {two_sum(p.high, t2.high), (discarded + inherited + kTiny) * kUp};
  }
  friend Extended operator*(const Extended& a, double b) { return a * Extended(b); }
  friend Extended abs(const Extended& a) { return a.high_ + a.low_ < 0 ? -a : a; }
  // max(x1, x2) lies within max(e1, e2) of max(v1, v2). The sum of the errors is taken, so that a NaN stays.
  friend Extended max(const Extended& a, const Extended& b) {
    // high = fl(high + low), so pairs compare by the high parts, then by the low ones.
    const bool a_larger = a.high_ > b.high_ || (a.high_ == b.high_ && a.low_ >= b.low_);
    Extended larger = a_larger ? a : b;
    larger.error_ = (a.error_ + b.error_) * kUp;
    return larger;
  }

  friend Sign sign(const Extended& a) {
    // fl(high + low) has the sign of the sum and is within a factor 1 + u of it.
    const double v = a.high_ + a.low_;
    if (v > a.error_ * kUp) return Sign::positive;
    if (-v > a.error_ * kUp) return Sign::negative;
    return v == 0 && a.error_ == 0 ? Sign::zero : Sign::unknown;  // NaN: unknown
  }

 private:
  Extended(DoublePair sum, double error) : high_(sum.high), low_(sum.low), error_(error) {}

  double high_ = 0, low_ = 0, error_ = 0;
};

}  // namespace graze::oracle
