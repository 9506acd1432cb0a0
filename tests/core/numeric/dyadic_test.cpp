// Core's exact numbers against GMP's.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <graze/detail/numeric/dyadic.hpp>
#include <limits>
#include <vector>

#include "corpus/random.hpp"

namespace graze::detail::exact {
namespace {

struct Both {
  Dyadic own;
  mpq_class gmp;
};

Both of(double x) { return {Dyadic(x), mpq_class(x)}; }
Both operator+(const Both& x, const Both& y) { return {x.own + y.own, x.gmp + y.gmp}; }
Both operator-(const Both& x, const Both& y) { return {x.own - y.own, x.gmp - y.gmp}; }
Both operator*(const Both& x, const Both& y) { return {x.own * y.own, x.gmp * y.gmp}; }

// Any finite double, of few bits or all, near 1 or anywhere.
double draw(corpus::Random& random) {
  const int bits = random.once_in(2) ? 53 : random.integer(1, 20);
  const auto mantissa = static_cast<double>(random.below(std::uint64_t{1} << bits));
  const int exponent = random.once_in(2) ? random.integer(-60, 60) : random.integer(-1074, 900);
  return std::ldexp(random.once_in(2) ? mantissa : -mantissa, exponent);
}

void expect_equal(const Both& x) {
  ASSERT_TRUE(x.own.valid());
  ASSERT_EQ(x.own.sign(), sgn(x.gmp));
  if (x.own.sign() == 0) return;
  // leading() 2^order is x cut off after 53 bits.
  const int order = x.own.order();
  mpq_class scaled = x.gmp;
  if (order >= 0) {
    mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(order));
  } else {
    mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-order));
  }
  ASSERT_GE(abs(scaled), 1);
  ASSERT_LT(abs(scaled), 2);
  ASSERT_LE(abs(mpq_class(x.own.leading())), abs(scaled));
  ASSERT_LT(abs(scaled - mpq_class(x.own.leading())), mpq_class(std::numeric_limits<double>::epsilon()));
}

TEST(Dyadic, SumsDifferencesAndProductsAreGmps) {
  corpus::Random random(20261121);
  for (int round = 0; round < 4000; ++round) {
    std::vector<Both> known;
    for (int i = 0; i < 4; ++i) known.push_back(of(draw(random)));
    known.push_back(of(0));
    for (int step = 0; step < 6; ++step) {
      const Both& x = known[random.below(known.size())];
      const Both& y = known[random.below(known.size())];
      const std::uint64_t what = random.below(3);
      Both next = what == 0 ? x + y : what == 1 ? x - y : x * y;
      // Exponents spread as they multiply. A number beyond the room is invalid, and is not used further.
      if (!next.own.valid()) continue;
      expect_equal(next);
      if (HasFatalFailure()) return;
      known.push_back(next);
    }
    // Differences that cancel to the last bit.
    const Both& last = known.back();
    EXPECT_EQ((last.own - last.own).sign(), 0);
    EXPECT_EQ((last.own + -last.own).sign(), 0);
  }
}

TEST(Dyadic, NeighboursDifferByTheLastBit) {
  for (const double x : {1.0, 0x1p-1074, 0x1.fffffffffffffp1023, 1e-60, 3.0}) {
    const double below = std::nextafter(x, 0.0);
    EXPECT_EQ((Dyadic(x) - Dyadic(below)).sign(), 1);
    EXPECT_EQ((Dyadic(-x) - Dyadic(-below)).sign(), -1);
  }
}

// There is room for 20,480 bits. One more is refused, and stays refused.
TEST(Dyadic, BeyondItsRoomItIsInvalidAndStaysSo) {
  const Dyadic one(1), small(0x1p-1000);
  Dyadic power = small;
  int factors = 1;
  while ((one + power).valid() && factors < 30) {
    power = power * small;
    ++factors;
  }
  EXPECT_EQ(factors, 21);  // 2^-20000 + 1 fits, 2^-21000 + 1 does not
  const Dyadic overflown = one + power;
  EXPECT_FALSE(overflown.valid());
  EXPECT_FALSE((overflown - overflown).valid());
  EXPECT_FALSE((overflown * Dyadic(0)).valid());
  EXPECT_FALSE((Dyadic(0) + overflown).valid());
}

// The portable product of limbs against GMP's: compilers without a 128-bit integer use it.
TEST(Limbs, ProductInHalvesIsExact) {
  constexpr Limb kMost = ~Limb{0};
  const auto wide = [](Limb x) { return mpz_class(static_cast<unsigned long>(x)); };
  const auto check = [&](Limb x, Limb y, Limb z, Limb carry) {
    const mpz_class expected = wide(x) * wide(y) + wide(z) + wide(carry);
    Limb high = carry, other = carry;
    const Limb low = multiply_add_in_halves(x, y, z, high);
    ASSERT_EQ((wide(high) << 64) + wide(low), expected) << x << ' ' << y << ' ' << z << ' ' << carry;
    ASSERT_EQ(multiply_add(x, y, z, other), low);
    ASSERT_EQ(other, high);
  };
  for (const Limb x : {Limb{0}, Limb{1}, Limb{0xffffffff}, Limb{1} << 32, kMost - 1, kMost}) {
    for (const Limb y : {Limb{0}, Limb{1}, Limb{0xffffffff}, Limb{1} << 32, kMost}) {
      for (const Limb z : {Limb{0}, Limb{0xffffffff}, kMost}) check(x, y, z, kMost - z / 2);
    }
  }
  corpus::Random random(7);
  for (int i = 0; i < 10000; ++i) {
    const auto any = [&] { return random.below(kMost) >> (random.once_in(3) ? random.integer(0, 63) : 0); };
    check(any(), any(), any(), any());
  }
}

}  // namespace
}  // namespace graze::detail::exact
