// An exact number m 2^e: what is left to decide when doubles and pairs of doubles could not.
//
// Sums and products are exact and do not allocate. m has at most kLimbs 64-bit limbs: 20,480 bits. The numbers of a cast
// fit. Given numbers are multiples of 2^-252 below 2^200, as magnitudes are 1e-60 to 1e60: 452 bits. W is |q|^2 of both
// bodies, the weight of all that their rotations pose.
//   a posed vertex, times W                                       2,270 bits
//   of two polytopes: a determinant of three of them              6,820
//     the same minus a time times another, as a time is a double  7,900
//   of rounded ones (round_search.hpp): z, a vertex less t v, with |t v| a few times the vertices' size and t a
//   multiple of 2^-1074, times W                                  3,350
//     at a vertex (z.z), an edge (|z x e|^2), a face ((z.N)^2)    6,690, 11,220, 15,750
//     the normal at an edge (z.v times |e|^2 z)                   16,210
//     a face over two times, N of steps that are as long as z     20,060
// Combinators that nest rotations can take more. Beyond kLimbs `valid` turns false and stays so. The caller then refuses
// the case (too_complex) and never guesses.
//
// Why this and neither of the others (bench/exact_bench.cpp): docs/reports/costs.md.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <graze/detail/numeric/limbs.hpp>
#include <graze/detail/numeric/machine.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

class Dyadic {
 public:
  static constexpr int kLimbs = 320;

  // NOLINTNEXTLINE(modernize-use-equals-default): a defaulted one would have Dyadic() clear all limbs
  Dyadic() {}
  // A finite double, read from its bits: no mode of the machine can change it.
  explicit Dyadic(double x) {
    const auto bits = detail::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t magnitude = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    if (magnitude == 0) return;
    const int zeros = std::countr_zero(magnitude);
    limb_[0] = magnitude >> zeros;
    size_ = 1;
    negative_ = bits >> 63 != 0;
    exponent_ = std::max(biased, 1) - 1075 + zeros;
  }
  Dyadic(const Dyadic& o) { *this = o; }
  Dyadic& operator=(const Dyadic& o) {
    if (this == &o) return *this;
    size_ = o.size_;
    exponent_ = o.exponent_;
    negative_ = o.negative_;
    valid_ = o.valid_;
    std::copy_n(o.limb_.data(), size_, limb_.data());
    return *this;
  }

  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }
  [[nodiscard]] bool valid() const { return valid_; }
  // The exponent of the leading bit: 2^order <= |x| < 2^(order + 1). For x != 0.
  [[nodiscard]] int order() const {
    return exponent_ + 64 * size_ - 1 - std::countl_zero(limb_[static_cast<std::size_t>(size_ - 1)]);
  }
  // The exponent of the last bit that is set: x is an odd multiple of 2^grid. For x != 0.
  [[nodiscard]] int grid() const {
    std::size_t k = 0;
    while (limb_[k] == 0) ++k;
    return exponent_ + 64 * static_cast<int>(k) + std::countr_zero(limb_[k]);
  }
  // x 2^-order as a double, truncated: in +-[1, 2). For x != 0.
  [[nodiscard]] double leading() const {
    const std::size_t top = static_cast<std::size_t>(size_ - 1);
    const int shift = std::countl_zero(limb_[top]);
    std::uint64_t bits = limb_[top] << shift;
    if (shift > 0 && size_ > 1) bits |= limb_[top - 1] >> (64 - shift);
    const double magnitude = static_cast<double>(bits >> 11) * 0x1p-52;
    return negative_ ? -magnitude : magnitude;
  }

  [[nodiscard]] Dyadic times_power_of_two(int shift) const {
    Dyadic out = *this;
    out.exponent_ += shift;
    return out;
  }
  friend Dyadic operator-(const Dyadic& x) {
    Dyadic out = x;
    out.negative_ = !x.negative_;
    return out;
  }
  friend Dyadic operator+(const Dyadic& x, const Dyadic& y) {
    if (x.size_ == 0) return with_validity(y, x);
    if (y.size_ == 0) return with_validity(x, y);
    if (x.exponent_ < y.exponent_) return sum(y, x);
    return sum(x, y);
  }
  friend Dyadic operator-(const Dyadic& x, const Dyadic& y) { return x + -y; }
  friend Dyadic operator*(const Dyadic& x, const Dyadic& y) {
    Dyadic out;
    out.valid_ = x.valid_ && y.valid_;
    if (x.size_ == 0 || y.size_ == 0) return out;
    if (x.size_ + y.size_ > kLimbs) {
      out.valid_ = false;
      return out;
    }
    const auto n = static_cast<std::size_t>(x.size_), m = static_cast<std::size_t>(y.size_);
    std::fill_n(out.limb_.data(), n + m, 0);
    for (std::size_t i = 0; i < n; ++i) {
      Limb carry = 0;
      for (std::size_t k = 0; k < m; ++k) {
        out.limb_[i + k] = multiply_add(x.limb_[i], y.limb_[k], out.limb_[i + k], carry);
      }
      out.limb_[i + m] = carry;
    }
    out.size_ = static_cast<int>(n + m);
    out.exponent_ = x.exponent_ + y.exponent_;
    out.negative_ = x.negative_ != y.negative_;
    out.trim();
    return out;
  }

 private:
  static Dyadic with_validity(const Dyadic& value, const Dyadic& other) {
    Dyadic out = value;
    out.valid_ = value.valid_ && other.valid_;
    return out;
  }
  // x + y, where x.exponent_ >= y.exponent_ and both are nonzero.
  static Dyadic sum(const Dyadic& x, const Dyadic& y) {
    Dyadic high = x.shifted_left(x.exponent_ - y.exponent_);
    high.valid_ = high.valid_ && y.valid_;
    if (!high.valid_) return high;
    high.exponent_ = y.exponent_;
    if (x.negative_ == y.negative_) {
      high.add_magnitude(y);
    } else if (const int order = compare_magnitude(high, y); order > 0) {
      high.subtract_magnitude(y);
    } else if (order == 0) {
      high.size_ = 0;
    } else {
      Dyadic low = y;
      low.subtract_magnitude(high);
      high = low;
    }
    high.trim();
    return high;
  }
  [[nodiscard]] Dyadic shifted_left(int bits) const {
    Dyadic out;
    out.valid_ = valid_;
    out.negative_ = negative_;
    const int limbs = bits / 64, rest = bits % 64;
    // One limb more than the value takes: room for a carry.
    if (bits < 0 || size_ + limbs + 2 > kLimbs) {
      out.valid_ = false;
      return out;
    }
    std::fill_n(out.limb_.data(), limbs, 0);
    Limb carry = 0;
    const std::size_t moved = static_cast<std::size_t>(limbs);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) {
      const Limb l = limb_[i];
      out.limb_[i + moved] = rest == 0 ? l : l << rest | carry;
      carry = rest == 0 ? 0 : l >> (64 - rest);
    }
    out.size_ = size_ + limbs;
    if (carry != 0) out.limb_[static_cast<std::size_t>(out.size_++)] = carry;
    return out;
  }
  static int compare_magnitude(const Dyadic& x, const Dyadic& y) {
    if (x.size_ != y.size_) return x.size_ > y.size_ ? 1 : -1;
    for (int i = x.size_ - 1; i >= 0; --i) {
      const std::size_t k = static_cast<std::size_t>(i);
      if (x.limb_[k] != y.limb_[k]) return x.limb_[k] > y.limb_[k] ? 1 : -1;
    }
    return 0;
  }
  void add_magnitude(const Dyadic& y) {
    if (std::max(size_, y.size_) + 1 > kLimbs) {
      valid_ = false;
      return;
    }
    for (int i = size_; i <= std::max(size_, y.size_); ++i) limb_[static_cast<std::size_t>(i)] = 0;
    size_ = std::max(size_, y.size_) + 1;
    Limb carry = 0;
    for (int i = 0; i < size_; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      limb_[k] = add(limb_[k], i < y.size_ ? y.limb_[k] : 0, carry);
    }
  }
  // |this| > |y|
  void subtract_magnitude(const Dyadic& y) {
    Limb borrow = 0;
    for (int i = 0; i < size_; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      limb_[k] = subtract(limb_[k], i < y.size_ ? y.limb_[k] : 0, borrow);
    }
  }
  // No leading zero limbs, and no trailing ones.
  void trim() {
    while (size_ > 0 && limb_[static_cast<std::size_t>(size_ - 1)] == 0) --size_;
    int zeros = 0;
    while (zeros < size_ && limb_[static_cast<std::size_t>(zeros)] == 0) ++zeros;
    if (zeros == 0) return;
    std::copy(limb_.begin() + zeros, limb_.begin() + size_, limb_.begin());
    size_ -= zeros;
    exponent_ += 64 * zeros;
  }

  int size_ = 0, exponent_ = 0;
  bool negative_ = false, valid_ = true;
  std::array<Limb, kLimbs> limb_;  // little-endian, unspecified beyond size_
};

using Dyadic3 = std::array<Dyadic, 3>;

inline Dyadic dot(const Dyadic3& a, const Dyadic3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Dyadic3 cross(const Dyadic3& a, const Dyadic3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
