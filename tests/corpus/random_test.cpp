// The generator gives the published sequences.
#include "corpus/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace graze::corpus {
namespace {

TEST(Random, IsXoshiro256StarStarSeededBySplitmix64) {
  // splitmix64 from 0 (Vigna's reference): e220a8397b1dcdaf 6e789e6aa1b965f4 06c45d188009454f
  // f88bb8a8724c81ec. The first output of xoshiro256** on that state is rotl(state[1] * 5, 7) * 9, computed
  // by hand here.
  const std::uint64_t product = 0x6e789e6aa1b965f4u * 5;
  EXPECT_EQ(Random(0).bits(), ((product << 7) | (product >> 57)) * 9);
}

TEST(Random, HashOfNothingAndOfAIsTheStandard) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325u);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cu);
}

TEST(Random, StaysInRangeAndReachesBothEnds) {
  Random random(7);
  std::array<int, 5> seen{};
  double least = 1, most = 0;
  for (int i = 0; i < 10000; ++i) {
    ++seen[static_cast<std::size_t>(random.integer(-2, 2) + 2)];
    const double u = random.unit();
    least = std::min(least, u);
    most = std::max(most, u);
  }
  // Expected 2000 each with a standard deviation of 40: six of them.
  for (const int count : seen) EXPECT_NEAR(count, 2000, 240);
  EXPECT_GE(least, 0);
  EXPECT_LT(least, 0.01);
  EXPECT_LT(most, 1);
  EXPECT_GT(most, 0.99);
}

}  // namespace
}  // namespace graze::corpus
