// The codec: total on bytes, and a case comes back bit for bit.
#include "fuzz/codec.hpp"

#include <gtest/gtest.h>

#include <map>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/rotating.hpp"

namespace graze::fuzz {
namespace {

void expect_round_trip(const corpus::Case& problem) {
  const auto bytes = encode(problem);
  ASSERT_TRUE(bytes);
  corpus::Case back = decode(*bytes), numbers = problem;
  // The bytes do not carry these fields.
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

TEST(Codec, ADrawnCaseComesBackBitForBit) {
  corpus::Random random(1);
  int tried = 0;
  for (int i = 0; i < 500; ++i) {
    const corpus::Case problem = law::draw_case(random, i % 100);
    if (!encode(problem)) continue;  // a tapered capsule in two other combinators: four deep
    expect_round_trip(problem);
    ++tried;
  }
  EXPECT_GE(tried, 490);
}

TEST(Codec, ATurningCaseComesBackBitForBit) {
  corpus::Random random(3);
  int turning = 0;
  for (int i = 0; i < 300; ++i) {
    const corpus::Case problem = law::draw_rotating(random, i % 100);
    if (!encode(problem)) continue;  // nested too deep
    turning += law::has_spin(problem);
    expect_round_trip(problem);
  }
  EXPECT_GE(turning, 200);
}

TEST(Codec, EveryFieldOfAQuestionComesBack) {
  corpus::Case problem;
  problem.spin_a.pivot = {0.1, -0.0, 3};
  problem.spin_b.rotation = {0, 1e-300, 0x1p60};
  problem.start_policy = corpus::StartPolicy::pass_over;
  problem.query = corpus::Query::penetration_along;
  problem.direction = {0, -1, 0.3};
  problem.t_max = kInfinity<double>;
  problem.target_distance = -0.5;
  problem.a.shape = Hull<double>();
  problem.b.shape = Sum<double>{};
  expect_round_trip(problem);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  problem.a.shape = Box<double>{{nan, -0.0, -kInfinity<double>}};
  problem.b.shape = HullOf<double>{{nullptr, share<double>(Capsule<double>{-1, nan})}};
  problem.b.orientation = {0, 0, 0, 0};
  problem.t_max = nan;
  expect_round_trip(problem);
}

TEST(Codec, AHullsAdjacencyComesBack) {
  const std::vector<Vec3<double>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  corpus::Case problem;
  problem.a.shape = with_adjacency<double>(std::span<const Vec3<double>>(corners));
  problem.b.shape = Hull<double>(std::span<const Vec3<double>>(corners));
  const corpus::Case back = decode(encode(problem).value());
  EXPECT_TRUE(std::get<Hull<double>>(back.a.shape).has_adjacency());
  EXPECT_FALSE(std::get<Hull<double>>(back.b.shape).has_adjacency());
}

TEST(Codec, WhatIsLeftOverIsTheTail) {
  corpus::Random random(4);
  int tried = 0;
  for (int i = 0; i < 100; ++i) {
    std::optional<Bytes> bytes = encode(law::draw_rotating(random, i));
    if (!bytes) continue;  // nested too deep
    const Bytes tail = {7, 8, 9};
    bytes->insert(bytes->end(), tail.begin(), tail.end());
    const std::span<const std::uint8_t> left = decode_with_tail(*bytes).tail;
    EXPECT_TRUE(std::equal(left.begin(), left.end(), tail.begin(), tail.end()));
    ++tried;
  }
  EXPECT_GE(tried, 90);
}

TEST(Codec, AFamilysCaseComesBackBitForBit) {
  int tried = 0;
  for (const corpus::Family& family : corpus::families()) {
    for (const double hardness : family.levels) {
      const corpus::Case problem = family.generate(hardness, 1);
      if (!encode(problem)) continue;  // more than 128 vertices
      expect_round_trip(problem);
      ++tried;
    }
  }
  EXPECT_GE(tried, 20);
}

TEST(Codec, DecodingIsTotalAndStable) {
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
    refused += !law::in_domain(problem);
  }
  for (std::size_t kind = 0; kind < std::variant_size_v<Shape<double>::Kinds>; ++kind) {
    EXPECT_GE(kinds[kind], 200) << kind;
  }
  EXPECT_GE(refused, 60);
  EXPECT_LE(refused, 400);  // more than nine in ten inputs are questions
}

TEST(Codec, AnEmptyInputIsTwoPoints) {
  const corpus::Case problem = decode({});
  EXPECT_TRUE(std::holds_alternative<Point<double>>(problem.a.shape));
  EXPECT_TRUE(std::holds_alternative<Point<double>>(problem.b.shape));
  EXPECT_EQ(problem.t_max, 1);
}

TEST(Codec, NestingIsBoundedWhateverTheBytes) {
  // A rounding of a rounding of ...: three, then a leaf.
  corpus::Case problem = decode(Bytes(100, 11));
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

TEST(Codec, AHullBeyond128VerticesIsLeftOut) {
  corpus::Case large;
  for (const std::size_t size : {128u, 129u}) {
    large.a.shape =
        Hull<double>(std::span<const Vec3<double>>(std::vector<Vec3<double>>(size, Vec3<double>(1, 2, 3))));
    EXPECT_EQ(encode(large).has_value(), size == 128);
  }
}

}  // namespace
}  // namespace graze::fuzz
