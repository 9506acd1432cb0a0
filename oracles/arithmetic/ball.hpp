// Ball arithmetic: a real number known to lie within radius of midpoint, by Arb (F. Johansson, "Arb:
// efficient arbitrary-precision midpoint-radius interval arithmetic", IEEE Trans. Computers 66, 2017).
//
// Every operation returns a ball that holds all results for all numbers in its operands' balls, rounded to
// the thread's working precision. Searches compare midpoints and claim nothing. Proofs compare whole balls.
// For the oracles' own .cpp files: this header includes Arb.
#pragma once

#include <arb.h>
#include <graze/scalar.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

// Bits of the results of this thread's operations while it lives.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(long bits) : before_(bits_) { bits_ = bits; }
  ~WorkingPrecision() { bits_ = before_; }
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;
  [[nodiscard]] static long bits() { return bits_; }

 private:
  inline static thread_local long bits_ = 128;
  long before_;
};

class Ball {
 public:
  Ball() { arb_init(x_); }
  Ball(double exact) {  // NOLINT: a double is a ball of radius 0
    arb_init(x_);
    arb_set_d(x_, exact);
  }
  Ball(const Ball& other) {
    arb_init(x_);
    arb_set(x_, other.x_);
  }
  Ball(Ball&& other) noexcept {
    arb_init(x_);
    arb_swap(x_, other.x_);
  }
  Ball& operator=(const Ball& other) {
    arb_set(x_, other.x_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  [[nodiscard]] arb_ptr get() { return x_; }
  [[nodiscard]] arb_srcptr get() const { return x_; }

  Ball& operator+=(const Ball& r) {
    arb_add(x_, x_, r.x_, WorkingPrecision::bits());
    return *this;
  }
  Ball& operator-=(const Ball& r) {
    arb_sub(x_, x_, r.x_, WorkingPrecision::bits());
    return *this;
  }
  Ball& operator*=(const Ball& r) {
    arb_mul(x_, x_, r.x_, WorkingPrecision::bits());
    return *this;
  }
  Ball& operator/=(const Ball& r) {
    arb_div(x_, x_, r.x_, WorkingPrecision::bits());
    return *this;
  }
  // += l r
  Ball& add_product(const Ball& l, const Ball& r) {
    arb_addmul(x_, l.x_, r.x_, WorkingPrecision::bits());
    return *this;
  }
  Ball& subtract_product(const Ball& l, const Ball& r) {
    arb_submul(x_, l.x_, r.x_, WorkingPrecision::bits());
    return *this;
  }

  // True if every number in the ball is positive.
  [[nodiscard]] bool is_positive() const { return arb_is_positive(x_) != 0; }
  [[nodiscard]] bool is_negative() const { return arb_is_negative(x_) != 0; }
  [[nodiscard]] bool is_nonnegative() const { return arb_is_nonnegative(x_) != 0; }
  [[nodiscard]] bool is_zero() const { return arb_is_zero(x_) != 0; }
  [[nodiscard]] bool is_finite() const { return arb_is_finite(x_) != 0; }
  // The sign of the midpoint.
  [[nodiscard]] int mid_sign() const { return arf_sgn(arb_midref(x_)); }
  [[nodiscard]] double mid_double() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }

  // The midpoint, and the ends, as balls of radius 0 (the ends rounded outward to the working precision).
  [[nodiscard]] Ball mid() const {
    Ball m;
    arf_set_round(arb_midref(m.x_), arb_midref(x_), WorkingPrecision::bits(), ARF_RND_NEAR);
    return m;
  }
  [[nodiscard]] Ball low() const {
    Ball end;
    arb_get_lbound_arf(arb_midref(end.x_), x_, WorkingPrecision::bits());
    return end;
  }
  [[nodiscard]] Ball high() const {
    Ball end;
    arb_get_ubound_arf(arb_midref(end.x_), x_, WorkingPrecision::bits());
    return end;
  }
  // Doubles on either side of the whole ball. A ball that is not finite is unbounded.
  [[nodiscard]] double low_double() const {
    const double d = arf_get_d(arb_midref(low().x_), ARF_RND_FLOOR);
    return std::isnan(d) ? -std::numeric_limits<double>::infinity() : d;
  }
  [[nodiscard]] double high_double() const {
    const double d = arf_get_d(arb_midref(high().x_), ARF_RND_CEIL);
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
  }
  [[nodiscard]] Enclosure enclosure() const { return {low_double(), high_double()}; }

  // l < r for every pair of numbers in the balls.
  friend bool certainly_less(const Ball& l, const Ball& r) { return arb_lt(l.x_, r.x_) != 0; }
  friend bool certainly_at_most(const Ball& l, const Ball& r) { return arb_le(l.x_, r.x_) != 0; }
  friend bool mid_less(const Ball& l, const Ball& r) {
    return arf_cmp(arb_midref(l.x_), arb_midref(r.x_)) < 0;
  }

 private:
  arb_t x_;
};

inline Ball operator+(Ball l, const Ball& r) { return l += r; }
inline Ball operator-(Ball l, const Ball& r) { return l -= r; }
inline Ball operator*(Ball l, const Ball& r) { return l *= r; }
inline Ball operator/(Ball l, const Ball& r) { return l /= r; }
inline Ball operator-(Ball x) {
  arb_neg(x.get(), x.get());
  return x;
}
inline Ball abs(Ball x) {
  arb_abs(x.get(), x.get());
  return x;
}
// The root of max(0, x), for an x that is known not to be negative.
inline Ball sqrt(Ball x) {
  arb_sqrtpos(x.get(), x.get(), WorkingPrecision::bits());
  return x;
}
inline Ball max(const Ball& l, const Ball& r) {
  Ball m;
  arb_max(m.get(), l.get(), r.get(), WorkingPrecision::bits());
  return m;
}
inline Ball min(const Ball& l, const Ball& r) {
  Ball m;
  arb_min(m.get(), l.get(), r.get(), WorkingPrecision::bits());
  return m;
}
// 2^exponent
inline Ball power_of_two(long exponent) {
  Ball x(1);
  arb_mul_2exp_si(x.get(), x.get(), exponent);
  return x;
}
// max(0, x)
inline Ball not_below_zero(const Ball& x) { return max(x, Ball(0)); }
// The smallest ball around both, to the working precision.
inline Ball hull_of(const Ball& l, const Ball& r) {
  Ball u;
  arb_union(u.get(), l.get(), r.get(), WorkingPrecision::bits());
  return u;
}

struct BallVec {
  Ball x, y, z;
  BallVec() = default;
  BallVec(Ball x_, Ball y_, Ball z_) : x(std::move(x_)), y(std::move(y_)), z(std::move(z_)) {}
  explicit BallVec(const Vec3<double>& exact) : x(exact[0]), y(exact[1]), z(exact[2]) {}

  [[nodiscard]] BallVec mid() const { return {x.mid(), y.mid(), z.mid()}; }
  [[nodiscard]] bool is_zero() const { return x.is_zero() && y.is_zero() && z.is_zero(); }
  [[nodiscard]] Vec3<double> mid_double() const { return {x.mid_double(), y.mid_double(), z.mid_double()}; }
};

inline BallVec operator+(const BallVec& l, const BallVec& r) { return {l.x + r.x, l.y + r.y, l.z + r.z}; }
inline BallVec operator-(const BallVec& l, const BallVec& r) { return {l.x - r.x, l.y - r.y, l.z - r.z}; }
inline BallVec operator-(const BallVec& l) { return {-l.x, -l.y, -l.z}; }
inline BallVec operator*(const Ball& s, const BallVec& r) { return {s * r.x, s * r.y, s * r.z}; }
inline Ball dot(const BallVec& l, const BallVec& r) {
  Ball d = l.x * r.x;
  return d.add_product(l.y, r.y).add_product(l.z, r.z);
}
inline BallVec cross(const BallVec& l, const BallVec& r) {
  BallVec c{l.y * r.z, l.z * r.x, l.x * r.y};
  c.x.subtract_product(l.z, r.y);
  c.y.subtract_product(l.x, r.z);
  c.z.subtract_product(l.y, r.x);
  return c;
}
inline Ball norm(const BallVec& x) { return sqrt(dot(x, x)); }

}  // namespace graze::oracle
