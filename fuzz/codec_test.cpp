// The codec: total on bytes, and a case comes back bit for bit.
#include "fuzz/codec.hpp"

#include <gtest/gtest.h>

#include <map>

#include "corpus/case_io.hpp"
#include "corpus/families.hpp"
#include "properties/case_edit.hpp"
#include "properties/draw_case.hpp"

namespace graze::fuzz {
namespace {

void expect_round_trip(const corpus::Case& problem) {
  const auto bytes = encode(problem);
  ASSERT_TRUE(bytes);
  corpus::Case back = decode(*bytes), numbers = problem;
  // What the bytes do not carry.
  back.id = numbers.id;
  back.family = numbers.family;
  back.hardness = numbers.hardness;
  back.comment = numbers.comment;
  back.source = numbers.source;
  back.flags = numbers.flags;
  numbers.expect.reset();
  EXPECT_TRUE(corpus::same_case(back, numbers)) << corpus::write_case(numbers) << "\n"
                                                << corpus::write_case(back);
}

TEST(Codec, a_drawn_case_comes_back_bit_for_bit) {
  corpus::Random random(1);
  for (int i = 0; i < 500; ++i) expect_round_trip(law::draw_case(random, i % 100));
}

TEST(Codec, a_familys_case_comes_back_bit_for_bit) {
  int tried = 0;
  for (const corpus::Family& family : corpus::families()) {
    for (const double hardness : family.levels) {
      const corpus::Case problem = family.generate(hardness, 1);
      if (!encode(problem)) continue;  // more than 64 vertices
      expect_round_trip(problem);
      ++tried;
    }
  }
  EXPECT_GE(tried, 20);
}

TEST(Codec, decoding_is_total_and_stable) {
  corpus::Random random(2);
  int refused = 0;
  std::map<std::size_t, int> kinds;
  for (int i = 0; i < 6000; ++i) {
    std::vector<std::uint8_t> bytes(random.below(120));
    for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random.bits());
    const corpus::Case problem = decode(bytes);
    const auto again = encode(problem);
    ASSERT_TRUE(again);
    EXPECT_EQ(encode(decode(*again)), again);
    ++kinds[problem.a.shape.index()];
    refused += law::must_be_refused(problem);
  }
  for (std::size_t kind = 0; kind < std::variant_size_v<Shape<double>>; ++kind) {
    EXPECT_GE(kinds[kind], 200) << kind;
  }
  EXPECT_GE(refused, 300);
}

TEST(Codec, an_empty_input_is_two_points) {
  const corpus::Case problem = decode({});
  EXPECT_TRUE(std::holds_alternative<Point<double>>(problem.a.shape));
  EXPECT_TRUE(std::holds_alternative<Point<double>>(problem.b.shape));
  EXPECT_EQ(problem.t_max, 1);
}

TEST(Codec, nesting_is_bounded_whatever_the_bytes) {
  // A rounding of a rounding of ...: three, then a leaf.
  corpus::Case problem = decode(std::vector<std::uint8_t>(100, 11));
  const Shape<double>* shape = &problem.a.shape;
  int depth = 0;
  while (const auto* rounded = std::get_if<Rounded<double>>(shape)) {
    shape = &rounded->shape->shape;
    ++depth;
  }
  EXPECT_EQ(depth, 3);
  problem.a.shape = rounded<double>(problem.a.shape, 1);
  EXPECT_FALSE(encode(problem));
  problem.a.shape = Sum<double>{{nullptr, nullptr, nullptr}};
  EXPECT_TRUE(encode(problem));
  problem.a.shape = Sum<double>{{nullptr, nullptr, nullptr, nullptr}};
  EXPECT_FALSE(encode(problem));
}

TEST(Codec, a_case_that_says_more_is_left_out) {
  corpus::Case spinning;
  spinning.spin_a.rotation = {0, 0, 1};
  EXPECT_FALSE(encode(spinning));
  corpus::Case large;
  large.a.shape =
      Hull<double>(std::span<const Vec3<double>>(std::vector<Vec3<double>>(65, Vec3<double>::Zero())));
  EXPECT_FALSE(encode(large));
}

}  // namespace
}  // namespace graze::fuzz
