// Numbers x + e y with an infinitesimal e > 0, to first order: the value of a polynomial at e, for all small enough e.
//
// The sign is that of x, or of y if x is 0. If it is not 0, it is the polynomial's for all small enough e > 0. Zero
// means that the polynomial is at most of the size of e^2.
#pragma once

#include "oracles/arithmetic/number.hpp"

namespace graze::oracle {

template <class N>
class Dual {
 public:
  Dual() = default;
  explicit Dual(double x) : value_(x), slope_(0) {}
  [[nodiscard]] static Dual infinitesimal() { return {N(0), N(1)}; }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value_ + b.value_, a.slope_ + b.slope_}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value_ - b.value_, a.slope_ - b.slope_}; }
  friend Dual operator-(const Dual& a) { return {-a.value_, -a.slope_}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value_ * b.value_, a.value_ * b.slope_ + a.slope_ * b.value_};
  }
  friend Dual operator*(const Dual& a, double b) { return {a.value_ * b, a.slope_ * b}; }
  friend Dual abs(const Dual& a) { return sign(a) == Sign::negative ? -a : a; }
  friend Dual max(const Dual& a, const Dual& b) { return sign(a - b) == Sign::negative ? b : a; }
  friend Sign sign(const Dual& a) {
    const Sign first = sign(a.value_);
    return first == Sign::zero ? sign(a.slope_) : first;
  }

 private:
  Dual(N value, N slope) : value_(std::move(value)), slope_(std::move(slope)) {}

  N value_, slope_;
};

}  // namespace graze::oracle
