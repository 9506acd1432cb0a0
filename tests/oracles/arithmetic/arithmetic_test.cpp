// The checker's arithmetics against rationals: the bounds of Filtered and Extended hold for random
// expressions (cancelling, overflowing, underflowing), a sign that is told is the true one, and Dyadic is
// exact.
#include "oracles/arithmetic/number.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <iostream>

#include "corpus/random.hpp"
#include "oracles/arithmetic/double_double.hpp"
#include "oracles/arithmetic/dyadic.hpp"
#include "oracles/arithmetic/filtered.hpp"

namespace graze::test {
namespace {

using oracle::Dyadic;
using oracle::Extended;
using oracle::Filtered;
using oracle::Sign;

struct Values {
  Filtered filtered{0};
  Extended extended{0};
  Dyadic dyadic{0};
  mpq_class exact = 0;
};

Values of(double x) { return {Filtered(x), Extended(x), Dyadic(x), mpq_class(x)}; }

// Exponents around 0, or over the whole range. Mantissas are short or long, and equal values are frequent.
double draw_double(corpus::Random& random, bool wide) {
  const double mantissa = random.once_in(3) ? random.integer(-9, 9) : random.uniform(-2, 2);
  const double x = std::scalbn(mantissa, wide ? random.integer(-1000, 1000) : random.integer(-3, 3));
  return random.once_in(4) ? static_cast<double>(static_cast<float>(x)) : x;
}
bool finite_input(double x) { return std::abs(x) <= std::numeric_limits<double>::max(); }

struct Told {
  long long told = 0, unknown = 0;
  void count(Sign found, const mpq_class& exact) {
    if (found == Sign::unknown) {
      ++unknown;
      return;
    }
    ++told;
    ASSERT_EQ(static_cast<int>(found), sgn(exact));
  }
};

void run(bool wide, std::uint64_t seed, Told& filtered, Told& extended) {
  corpus::Random random(seed);
  for (int round = 0; round < 20000; ++round) {
    std::vector<Values> pool;
    while (pool.size() < 4)
      if (const double x = draw_double(random, wide); finite_input(x)) pool.push_back(of(x));
    for (int step = 0; step < 8; ++step) {
      const Values& a = pool[random.below(pool.size())];
      const Values& b = pool[random.below(pool.size())];
      Values r;
      switch (random.below(5)) {
        case 0:
          r = {a.filtered + b.filtered, a.extended + b.extended, a.dyadic + b.dyadic, a.exact + b.exact};
          break;
        case 1:
          r = {a.filtered - b.filtered, a.extended - b.extended, a.dyadic - b.dyadic, a.exact - b.exact};
          break;
        case 2:
          r = {a.filtered * b.filtered, a.extended * b.extended, a.dyadic * b.dyadic, a.exact * b.exact};
          break;
        case 3:
          r = {abs(a.filtered), abs(a.extended), abs(a.dyadic), abs(a.exact)};
          break;
        default:
          r = {a.exact >= b.exact ? a.filtered : b.filtered, max(a.extended, b.extended),
               max(a.dyadic, b.dyadic), std::max(a.exact, b.exact)};
      }
      filtered.count(sign(r.filtered), r.exact);
      extended.count(sign(r.extended), r.exact);
      ASSERT_EQ(static_cast<int>(sign(r.dyadic)), sgn(r.exact));
      if (testing::Test::HasFatalFailure()) return;
      const double v = r.filtered.value(), e = r.filtered.error();
      if (finite_input(v) && finite_input(e)) {
        ASSERT_LE(abs(mpq_class(r.exact - mpq_class(v))), mpq_class(e)) << v << " +- " << e;
      }
      // x - fl(x) probes the bound itself: its sign is told only if the error allows.
      if (finite_input(r.exact.get_d()) && !wide) {
        const double nearest = r.exact.get_d();
        extended.count(sign(r.extended - Extended(nearest)), r.exact - mpq_class(nearest));
      }
      pool.push_back(r);
    }
  }
}

TEST(Arithmetic, BoundsHoldAtOrdinaryMagnitudes) {
  Told filtered, extended;
  run(false, 1, filtered, extended);
  std::cout << "[  counts  ] signs told: filtered " << filtered.told << " of "
            << filtered.told + filtered.unknown << ", extended " << extended.told << " of "
            << extended.told + extended.unknown << "\n";
  EXPECT_GT(filtered.told, filtered.unknown);
  EXPECT_GT(extended.told, 20 * extended.unknown);
}

TEST(Arithmetic, BoundsHoldWhereProductsOverflowAndVanish) {
  Told filtered, extended;
  run(true, 2, filtered, extended);
  EXPECT_GT(filtered.told, 10000);
  EXPECT_GT(filtered.unknown, 1000);
  EXPECT_GT(extended.told, 10000);
  EXPECT_GT(extended.unknown, 1000);
}

TEST(Arithmetic, ExtendedKnowsAnExactZero) {
  const Extended a(0.1), b(0.3);
  EXPECT_EQ(sign(a * b - b * a), Sign::zero);
  EXPECT_EQ(sign((a + b) - b - a), Sign::zero);
  EXPECT_EQ(sign(Extended(3) * Extended(5) - Extended(15)), Sign::zero);
  EXPECT_EQ(sign(Extended(1e-200) * Extended(1e-200)), Sign::unknown);  // underflow is not zero
}

TEST(Arithmetic, DyadicReadsEveryDouble) {
  for (const double x : {0.0, -0.0, 0x1p-1074, -0x1.8p-1073, 0x1p-1022, 1.0, -0x1.fffffffffffffp1023}) {
    const Dyadic d(x);
    EXPECT_EQ(Dyadic::ratio(d, Dyadic(1)), x);
    EXPECT_EQ(sign(d - Dyadic(x)), Sign::zero);
  }
}

}  // namespace
}  // namespace graze::test
