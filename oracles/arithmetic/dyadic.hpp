// An exact number m 2^e. Sums, differences and products of doubles are such numbers, so predicates without
// division need no other, and no common factors have to be removed.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "oracles/arithmetic/number.hpp"

namespace graze::oracle {

class Dyadic {
 public:
  Dyadic() = default;
  // A finite double. Read from its bits: no mode of the processor can change them.
  explicit Dyadic(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t magnitude = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    if (magnitude == 0) return;
    const int zeros = std::countr_zero(magnitude);
    mantissa_ = static_cast<unsigned long>(magnitude >> zeros);
    if (bits >> 63 != 0) mantissa_ = -mantissa_;
    exponent_ = std::max(biased, 1) - 1075 + zeros;
  }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (sgn(a.mantissa_) == 0) return b;
    if (sgn(b.mantissa_) == 0) return a;
    Dyadic sum;
    if (a.exponent_ >= b.exponent_) {
      sum.mantissa_ = a.mantissa_ << static_cast<mp_bitcnt_t>(a.exponent_ - b.exponent_);
      sum.mantissa_ += b.mantissa_;
      sum.exponent_ = b.exponent_;
    } else {
      sum.mantissa_ = b.mantissa_ << static_cast<mp_bitcnt_t>(b.exponent_ - a.exponent_);
      sum.mantissa_ += a.mantissa_;
      sum.exponent_ = a.exponent_;
    }
    return sum;
  }
  friend Dyadic operator-(const Dyadic& a) {
    Dyadic negated = a;
    mpz_neg(negated.mantissa_.get_mpz_t(), negated.mantissa_.get_mpz_t());
    return negated;
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    product.mantissa_ = a.mantissa_ * b.mantissa_;
    product.exponent_ = a.exponent_ + b.exponent_;
    return product;
  }
  friend Dyadic operator*(const Dyadic& a, double b) { return a * Dyadic(b); }
  friend Dyadic abs(const Dyadic& a) { return sgn(a.mantissa_) < 0 ? -a : a; }
  friend Dyadic max(const Dyadic& a, const Dyadic& b) { return sign(a - b) == Sign::negative ? b : a; }

  friend Sign sign(const Dyadic& a) { return static_cast<Sign>(sgn(a.mantissa_)); }

  // For messages: numerator / denominator to about 15 digits.
  [[nodiscard]] static double ratio(const Dyadic& numerator, const Dyadic& denominator) {
    long n_exp = 0, d_exp = 0;
    const double n = mpz_get_d_2exp(&n_exp, numerator.mantissa_.get_mpz_t());
    const double d = mpz_get_d_2exp(&d_exp, denominator.mantissa_.get_mpz_t());
    const long shift = n_exp + numerator.exponent_ - d_exp - denominator.exponent_;
    return std::scalbn(n / d, static_cast<int>(std::clamp(shift, -5000L, 5000L)));
  }

 private:
  mpz_class mantissa_ = 0;
  long exponent_ = 0;
};

}  // namespace graze::oracle
