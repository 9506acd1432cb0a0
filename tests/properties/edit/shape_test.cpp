// Shapes as trees: what is visited, counted, refused, grown, and had as exact vertices.
#include "properties/edit/shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/support_value.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/solid.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/shrink.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {
namespace {

const Shape<double> kBox = Box<double>{{1, 2, 3}};
const Shape<double> kBall = Sphere<double>{4};
const Vec3<double> kOrigin = Vec3<double>::Zero();

std::vector<double> scalars_of(const Shape<double>& shape) {
  std::vector<double> all;
  auto keep = [&](Slot, double x) {
    all.push_back(x);
    return x;
  };
  (void)map_shape(shape, keep);
  return all;
}

TEST(MapShape, VisitsEveryNumberOnceInItsSlot) {
  const Shape<double> tree =
      hull_of<double>(posed<double>(sum<double>(kBox, kBall), {5, 6, 7}, {8, 9, 10, 11}),
                      rounded<double>(Segment<double>{{12, 13, 14}, {15, 16, 17}}, 18));
  std::vector<Slot> slots;
  auto doubled = [&](Slot slot, double x) {
    slots.push_back(slot);
    return 2 * x;
  };
  const Shape<double> twice = map_shape(tree, doubled);
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(scalars_of(twice)[i], 2.0 * static_cast<double>(i + 1));
  EXPECT_EQ(slots.size(), 18u);
  EXPECT_EQ(std::count(slots.begin(), slots.end(), Slot::extent), 5);
  EXPECT_EQ(std::count(slots.begin(), slots.end(), Slot::position), 3);
  EXPECT_EQ(std::count(slots.begin(), slots.end(), Slot::orientation), 4);
  EXPECT_EQ(std::count(slots.begin(), slots.end(), Slot::vertex), 6);
  EXPECT_EQ(outline(twice), outline(tree));
  EXPECT_NE(outline(tree), outline(rounded<double>(tree, 0)));
}

TEST(VertexCount, FollowsTheRuleOfTheShapes) {
  EXPECT_EQ(vertex_count(kBox), 8u);
  EXPECT_EQ(vertex_count(sum<double>(kBox, Triangle<double>{})), 24u);
  EXPECT_EQ(vertex_count(hull_of<double>(kBox, Capsule<double>{1, 1})), 10u);
  EXPECT_EQ(vertex_count(rounded<double>(translated<double>(kBox, kOrigin), 1)), 8u);
  EXPECT_EQ(vertex_count(Cone<double>{1, 1}), 1u);
  Shape<double> many = kBox;
  for (int i = 0; i < 10; ++i) many = sum<double>(many, many);  // 8^1024
  EXPECT_GE(vertex_count(many), std::uint64_t{1} << 62);
}

TEST(IsMalformed, KnowsWhatMustBeRefused) {
  EXPECT_FALSE(is_malformed(hull_of<double>(kBox, kBall)));
  EXPECT_TRUE(is_malformed(Hull<double>()));
  EXPECT_TRUE(is_malformed(Sum<double>()));
  EXPECT_TRUE(is_malformed(HullOf<double>()));
  EXPECT_TRUE(is_malformed(Rounded<double>()));
  EXPECT_TRUE(is_malformed(Sum<double>{{share(kBox), nullptr}}));
  EXPECT_TRUE(is_malformed(sum<double>(kBox, Shape<double>(Hull<double>()))));
  EXPECT_TRUE(is_malformed(posed<double>(kBox, kOrigin, {0, 0, 0, 0})));
  Shape<double> deep = kBall;
  for (int i = 0; i < 16; ++i) deep = rounded<double>(deep, 1);
  EXPECT_FALSE(is_malformed(deep));
  EXPECT_TRUE(is_malformed(rounded<double>(deep, 1)));
  Shape<double> many = kBox;
  for (int i = 0; i < 3; ++i) many = sum<double>(many, many);  // 2^24
  EXPECT_FALSE(is_malformed(many));
  EXPECT_TRUE(is_malformed(sum<double>(many, many)));
}

TEST(IsPolytope, AndIsUncurvedLookAtEveryPart) {
  EXPECT_TRUE(is_polytope(sum<double>(kBox, Segment<double>{})));
  EXPECT_FALSE(is_polytope(sum<double>(kBox, kBall)));
  EXPECT_TRUE(is_uncurved(sum<double>(kBox, kBall)));
  EXPECT_FALSE(is_uncurved(sum<double>(kBox, Cone<double>{1, 1})));
  EXPECT_FALSE(is_uncurved(rounded<double>(translated<double>(Ellipsoid<double>{}, kOrigin), 1)));
}

TEST(ExactVertices, AreInTheOrderOfTheIndices) {
  const Shape<double> one = Segment<double>{{1, 0, 0}, {2, 0, 0}};
  const Shape<double> two = posed<double>(Segment<double>{{0, 1, 0}, {0, 2, 0}}, {0, 0, 5}, {0, 1, 0, 0});
  const auto sums = exact_vertices(sum<double>(one, two), 100);
  ASSERT_TRUE(sums);
  EXPECT_EQ(*sums, (std::vector<Vec3<double>>{{1, -1, 5}, {1, -2, 5}, {2, -1, 5}, {2, -2, 5}}));
  const auto joined = exact_vertices(hull_of<double>(one, two), 100);
  ASSERT_TRUE(joined);
  EXPECT_EQ((*joined)[2], Vec3<double>(0, -1, 5));
  EXPECT_FALSE(exact_vertices(sum<double>(one, two), 3));
  EXPECT_FALSE(exact_vertices(sum<double>(one, kBall), 100));
  EXPECT_FALSE(exact_vertices(posed<double>(one, {0x1p-60, 0, 0}, {}), 100));  // 1 + 2^-60
}

TEST(Grown, IsASupersetOfEveryShape) {
  corpus::Random random(21);
  int larger = 0;
  for (int i = 0; i < 3000; ++i) {
    const Shape<double> shape = draw_case(random, i % 100).a.shape;
    const Shape<double> more = grown(shape, random.bits());
    EXPECT_FALSE(is_malformed(more));
    bool grew = false;
    for (int d = 0; d < 20; ++d) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const Vec3<double> n(x, y, random.uniform(-1, 1));
      const double before = corpus::support_value(shape, n), after = corpus::support_value(more, n);
      // 100 roundings of numbers up to 100.
      EXPECT_GE(after, before - 1e-12);
      grew = grew || after > before;
    }
    larger += grew;
  }
  EXPECT_GE(larger, 2000);
}

corpus::Case meeting(Shape<double> shape) {
  corpus::Case problem;
  problem.a.shape = std::move(shape);
  problem.b.position = {20, 0, 0};
  problem.b.displacement = {-20, 0, 0};
  return problem;
}

TEST(HasTruth, ExactForPolytopesAndOneRadiusAndABracketForEverythingElse) {
  const Shape<double> exact[] = {Point<double>{},
                                 Segment<double>{{0, 0, 0}, {1, 0, 0}},
                                 Triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                 kBall,
                                 Capsule<double>{1, 2},
                                 kBox,
                                 Hull<double>{Vec3<double>(1, 2, 3)},
                                 sum<double>(kBox, kBall),
                                 hull_of<double>(kBox, Point<double>{}),
                                 posed<double>(kBox, {1, 2, 3}, {1, 1, 0, 0}),
                                 rounded<double>(kBox, 1)};
  for (const Shape<double>& shape : exact) {
    ASSERT_TRUE(has_truth(meeting(shape))) << shape.index();
    EXPECT_TRUE(is_exactly_decided(meeting(shape))) << shape.index();
    EXPECT_TRUE(truth_of(meeting(shape)).is_exact()) << shape.index();
  }
  const Shape<double> bracketed[] = {Ellipsoid<double>{{1, 2, 3}}, Cylinder<double>{1, 2}, Cone<double>{1, 2},
                                     sum<double>(kBox, Cone<double>{1, 2}),
                                     hull_of<double>(kBall, Point<double>{})};
  for (const Shape<double>& shape : bracketed) {
    ASSERT_TRUE(has_truth(meeting(shape))) << shape.index();
    EXPECT_FALSE(is_exactly_decided(meeting(shape))) << shape.index();
    EXPECT_FALSE(truth_of(meeting(shape)).is_exact()) << shape.index();
    EXPECT_FALSE(without_truth(meeting(shape)).has_value()) << shape.index();
    EXPECT_TRUE(without_exact_truth(meeting(shape)).has_value()) << shape.index();
  }
}

// The hulls' vertices lie on a helix about x: 256 of each, 2^16 differences. The first to meet are the ends.
TEST(HasTruth, BracketForMoreDifferencesThanTheExactOracleTakesInTime) {
  std::vector<Vec3<double>> vertices;
  for (int i = 0; i < 256; ++i) vertices.emplace_back(i / 64.0, std::cos(i / 8.0), std::sin(i / 8.0));
  const Hull<double> helix{std::span<const Vec3<double>>(vertices)};
  corpus::Case problem = meeting(helix);
  problem.b.shape = helix;
  ASSERT_TRUE(has_truth(problem));
  EXPECT_FALSE(is_exactly_decided(problem));
  const oracle::CaseTruth& bracket = truth_of(problem);
  EXPECT_FALSE(bracket.is_exact());
  const oracle::LinearTruth exact(problem);
  EXPECT_EQ(bracket.outcome(), Outcome::hit);
  EXPECT_EQ(exact.outcome(), Outcome::hit);
  EXPECT_LE(bracket.toi_lower(), exact.toi_upper());
  EXPECT_GE(bracket.toi_upper(), exact.toi_lower());
}

TEST(HasTruth, UndecidedWhereCurvedShapesTouch) {
  corpus::Case problem = meeting(Cylinder<double>{1, 2});
  problem.b.shape = kBall;
  problem.b.position = {20, 1 + std::get<Sphere<double>>(kBall).radius, 0};  // grazes the side
  ASSERT_TRUE(has_truth(problem));
  EXPECT_TRUE(is_undecided(truth_of(problem)));
  const std::optional<LawResult> open = without_truth(problem);
  ASSERT_TRUE(open.has_value());
  EXPECT_EQ(open->holding, Holding::not_applicable);
  EXPECT_EQ(open->reason, "undecided by the bracket oracle");
  EXPECT_EQ(open->labels, std::vector<std::string_view>{"undecided"});
}

TEST(HasTruth, NoneForWhatTheDoorRefuses) {
  corpus::Case problem = meeting(Ellipsoid<double>{{1, 2, -3}});
  EXPECT_FALSE(has_truth(problem));
  const std::optional<LawResult> open = without_truth(problem);
  ASSERT_TRUE(open.has_value());
  EXPECT_EQ(open->reason, "no oracle takes the case");
}

TEST(Solid, HasAnInside) {
  const auto hull = [](std::vector<Vec3<double>> vertices) {
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  };
  const Hull<double> flat = hull({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}}),
                     tetrahedron = hull({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5.25}});
  for (const Shape<double>& solid : std::vector<Shape<double>>{
           kBall, kBox, tetrahedron, Ellipsoid<double>{{1, 2, 3}}, Capsule<double>{1, 0},
           Cylinder<double>{1, 1}, Cone<double>{1, 1}, rounded<double>(Point<double>{}, 1),
           sum<double>(flat, kBall), posed<double>(kBox, {1, 2, 3}, {})}) {
    EXPECT_TRUE(is_solid(solid)) << solid.index();
  }
  for (const Shape<double>& none : std::vector<Shape<double>>{
           Point<double>{}, flat, Sphere<double>{0}, Box<double>{{1, 0, 1}}, Ellipsoid<double>{{1, 2, 0}},
           Capsule<double>{0, 1}, Cylinder<double>{1, 0}, Cone<double>{0, 1},
           Segment<double>{{0, 0, 0}, {1, 0, 0}}, rounded<double>(flat, 0),
           posed<double>(flat, {1, 2, 3}, {}), hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}})}) {
    EXPECT_FALSE(is_solid(none)) << none.index();
  }
}

TEST(Simpler, ACombinatorShrinksToThePartThatMatters) {
  corpus::Case problem;
  problem.a.shape = sum<double>(rounded<double>(kBox, 2), hull_of<double>(Cone<double>{3, 1}, kBall));
  const auto has_cone = [](const corpus::Case& c) {
    const std::vector<std::uint32_t> kinds = outline(c.a.shape);
    return std::find(kinds.begin(), kinds.end(), Shape<double>(Cone<double>{}).index()) != kinds.end();
  };
  ASSERT_TRUE(has_cone(problem));
  EXPECT_TRUE(std::holds_alternative<Cone<double>>(minimised(problem, has_cone).a.shape));
}

}  // namespace
}  // namespace graze::law
