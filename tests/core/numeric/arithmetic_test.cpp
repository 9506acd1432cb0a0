#include <gtest/gtest.h>
#include <bit>
#include <graze/detail/numeric/vectors.hpp>
#include <graze/detail/proving/pierce.hpp>

#include "tests/shared/generate.hpp"

namespace graze::detail::exact {
namespace {

using test::Draw;

TEST(Expansion, KeepsWhatADoubleLoses) {
  Expansion e(1e30);
  e.grow(1);
  e.grow(-1e30);
  EXPECT_EQ(e.sign(), 1);
  EXPECT_EQ(e.estimate(), 1);
  e.grow(-1);
  EXPECT_EQ(e.sign(), 0);
  EXPECT_EQ(e.size(), 0);
}

// Bit for bit, over the whole range in use: answers must not depend on the processor.
TEST(FusedPairs, AreTheSamePairs) {
  if (!fuses()) GTEST_SKIP() << "the compiler may fuse anyway, or the processor cannot";
  Draw draw{52};
  const auto number = [&] { return std::ldexp(draw.between(-1, 1), int(draw.bits() % 600) - 300); };
  const auto same = [](const auto& x, const auto& y) {
    return detail::bit_cast<std::uint64_t>(x.hi) == detail::bit_cast<std::uint64_t>(y.hi) && x.lo == y.lo;
  };
  int inexact = 0;
  for (int round = 0; round < 20000; ++round) {
    const double x = number(), y = number();
    const PairOf<true> fused = product<true>(x, y);
    EXPECT_TRUE(same(fused, product<false>(x, y))) << x << " " << y;
    inexact += fused.lo != 0 ? 1 : 0;

    const Quaternion<double> q{draw.between(1, 2), draw.between(-1, 1), draw.between(-1, 1),
                               draw.between(-1, 1)};
    const FineTurn turn(q);
    const Pair3 given = {difference(number(), number()), difference(number(), number()),
                         difference(number(), number())};
    const Pair3 one = turn.turned<true>(given), other = turn.turned<false>(given);
    const Vec3<double> c(number(), number(), number());
    const auto fused_turn = detail::rotated_in_pairs<true>(q, c),
               plain_turn = detail::rotated_in_pairs<false>(q, c);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(same(one[i], other[i]));
      EXPECT_TRUE(same(fused_turn[i], plain_turn[i]));
    }
  }
  EXPECT_GT(inexact, 19000);
}

// (x + 2^-60)(x - 2^-60) = x^2 - 2^-120.
TEST(Expansion, ProductsAreExact) {
  Draw draw{51};
  for (int round = 0; round < 200; ++round) {
    const double x = draw.between(1, 2);
    Expansion plus(x), minus(x);
    plus.grow(0x1p-60);
    minus.grow(-0x1p-60);
    Expansion product;
    product.add_product(plus, minus);
    Expansion square;
    square.add_product(Expansion(x), Expansion(x), -1);
    product.add(square);
    EXPECT_EQ(product.estimate(), -0x1p-120);
  }
}

// Integers small enough for 64-bit arithmetic.
TEST(Expansion, DeterminantOfIntegers) {
  Draw draw{52};
  int zeros = 0;
  for (int round = 0; round < 2000; ++round) {
    const int range = round % 2 ? 2 : 100000;
    std::int64_t m[3][3];
    std::array<Expansion3, 3> column;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        m[i][j] = static_cast<std::int64_t>(draw.bits() % static_cast<unsigned>(2 * range + 1)) - range;
        column[i][j] = Expansion(static_cast<double>(m[i][j]));
      }
    }
    const std::int64_t d = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                           m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    zeros += d == 0;
    EXPECT_EQ(determinant(column[0], column[1], column[2]).estimate(), static_cast<double>(d)) << round;
  }
  EXPECT_GT(zeros, 100);
}

std::array<SupportPair, 4> corners(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::array<SupportPair, 4> out;
  out[0].a.vertex = a;
  out[1].a.vertex = b;
  out[2].a.vertex = c;
  return out;
}

// A ray through the middle of a box's face is on the diagonal of either triangle: a tie that doubles cannot
// see where the numbers are no binary fractions.
TEST(Pierce, TieOnADiagonalIsDecided) {
  const double third = 1.0 / 3;
  const Body<double> box{.shape = Box<double>{{third, 0.1, 0.7}}, .position = {0.3, 0.3, 0.3}};
  const Body<double> ray{.shape = Point<double>{}, .position = {5.3, 0.3, 0.3}, .displacement = {-9, 0, 0}};
  // The face x = +1/3 has corners 1, 3, 5, 7 and diagonal 1-7.
  const Pierced pierced = pierce(box, ray, corners(1, 3, 7), 1, 0, 3);
  EXPECT_TRUE(pierced.pierced);
  EXPECT_NEAR(pierced.t_upper, (5.3 - 0.3 - third) / 9, 1e-15);
  // One unit in the last place off the diagonal: one of the triangles, not both.
  Body<double> off = ray;
  off.position[1] = std::nextafter(0.3, 1);
  EXPECT_NE(pierce(box, off, corners(1, 3, 7), 1, 0, 3).pierced,
            pierce(box, off, corners(1, 5, 7), 1, 0, 3).pierced);
}

TEST(Pierce, HorizonIsExact) {
  const Body<double> box{.shape = Box<double>{{1, 1, 1}}};
  const Body<double> ray{.shape = Point<double>{}, .position = {4, 0, 0}, .displacement = {-3, 0, 0}};
  EXPECT_TRUE(pierce(box, ray, corners(1, 3, 7), 1, 2, 1).pierced);  // t = 1 = t_max
  EXPECT_EQ(pierce(box, ray, corners(1, 3, 7), 1, 2, 1).t_upper, 1);
  EXPECT_FALSE(pierce(box, ray, corners(1, 3, 7), std::nextafter(1.0, 0.0), 2, 1).pierced);
  EXPECT_FALSE(pierce(box, ray, corners(0, 2, 6), 1, 2, 1).pierced);  // the far face: t = 5/3
  Body<double> behind = ray;
  behind.position = {-4, 0, 0};
  EXPECT_FALSE(pierce(box, behind, corners(1, 3, 7), 1, 2, 1).pierced);  // t < 0
}

TEST(Pierce, WhatItDoesNotDecideItDoesNotClaim) {
  Body<double> box{.shape = Box<double>{{1, 1, 1}}};
  const Body<double> ray{.shape = Point<double>{}, .position = {4, 0, 0}, .displacement = {-3, 0, 0}};
  box.orientation = {1, 1, 0, 0};
  EXPECT_FALSE(pierce(box, ray, corners(1, 3, 7), 2, 2, 1).pierced);  // rotated
  box.orientation = {};
  box.position = {1e-60, 0, 0};  // beyond the range of the products, at a scale of 2^600
  EXPECT_FALSE(pierce(box, ray, corners(1, 3, 7), 2, 600, 1).pierced);
}

}  // namespace
}  // namespace graze::detail::exact
