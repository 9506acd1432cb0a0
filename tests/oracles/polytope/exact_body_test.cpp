// The vertices of every shape, in the order of their indices, and what has no exact body.
#include "oracles/polytope/exact_body.hpp"

#include <gtest/gtest.h>

#include "oracles/polytope/integer_scene.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

using D = double;

RationalPoint at(D x, D y, D z) { return {Rational(x), Rational(y), Rational(z)}; }

std::vector<RationalPoint> vertices(Shape<D> shape) {
  return exact_body({.shape = std::move(shape)}).vertices;
}

Rational radius(Shape<D> shape) { return exact_body({.shape = std::move(shape)}).radius; }

using Points = std::vector<RationalPoint>;

TEST(ExactBody, LeavesHaveTheirVerticesInTheOrderOfTheirIndex) {
  EXPECT_EQ(vertices(Point<D>{}), Points{at(0, 0, 0)});
  EXPECT_EQ(vertices(Segment<D>{Vec(3, 2, 1), Vec(1, 2, 3)}), (Points{at(3, 2, 1), at(1, 2, 3)}));
  EXPECT_EQ(vertices(Triangle<D>{Vec(3, 0, 0), Vec(2, 0, 0), Vec(1, 5, 0)}),
            (Points{at(3, 0, 0), at(2, 0, 0), at(1, 5, 0)}));
  EXPECT_EQ(vertices(Sphere<D>{2}), Points{at(0, 0, 0)});
  EXPECT_EQ(vertices(Capsule<D>{2, 3}), (Points{at(0, 0, -3), at(0, 0, 3)}));
  EXPECT_EQ(radius(Capsule<D>{2, 3}), 2);
  EXPECT_EQ(radius(Box<D>{Vec(1, 2, 3)}), 0);
  const Points box = vertices(Box<D>{Vec(1, 2, 3)});
  ASSERT_EQ(box.size(), 8u);
  EXPECT_EQ(box[0], at(-1, -2, -3));
  EXPECT_EQ(box[1], at(1, -2, -3));
  EXPECT_EQ(box[6], at(-1, 2, 3));
  EXPECT_EQ(vertices(Hull<D>{Vec(5, 5, 5), Vec(5, 5, 5), Vec(0, 0, 0)}),
            (Points{at(5, 5, 5), at(5, 5, 5), at(0, 0, 0)}));
}

TEST(ExactBody, ASumsLastPartCountsFastest) {
  const Shape<D> first = Segment<D>{Vec(0, 0, 0), Vec(1, 0, 0)};
  const Shape<D> second = Triangle<D>{Vec(0, 0, 0), Vec(0, 1, 0), Vec(0, 2, 0)};
  const Shape<D> third = Segment<D>{Vec(0, 0, 0), Vec(0, 0, 1)};
  const Points sum = vertices(Sum<D>{{share<D>(first), share<D>(second), share<D>(third)}});
  ASSERT_EQ(sum.size(), 12u);
  for (unsigned i = 0; i < 12; ++i) EXPECT_EQ(sum[i], at(i / 6, i / 2 % 3, i % 2)) << i;
}

TEST(ExactBody, AHullsPartsFollowOneAnother) {
  const Points both = vertices(hull_of<D>(Triangle<D>{Vec(1, 0, 0), Vec(2, 0, 0), Vec(3, 0, 0)},
                                          posed<D>(Point<D>{}, Vec(4, 0, 0), {})));
  EXPECT_EQ(both, (Points{at(1, 0, 0), at(2, 0, 0), at(3, 0, 0), at(4, 0, 0)}));
}

TEST(ExactBody, PosesAreAppliedFromTheInsideOut) {
  const Quaternion<D> quarter_about_z{1, 0, 0, 1}, half_about_x{0, 1, 0, 0};
  const Shape<D> inner = posed<D>(Segment<D>{Vec(1, 0, 0), Vec(0, 2, 0)}, Vec(10, 0, 0), quarter_about_z);
  EXPECT_EQ(vertices(inner), (Points{at(10, 1, 0), at(8, 0, 0)}));
  const ExactBody outer = exact_body({.shape = inner, .position = Vec(0, 0, 7), .orientation = half_about_x});
  EXPECT_EQ(outer.vertices, (Points{at(10, -1, 7), at(8, 0, 7)}));
  // (3, 4, 0, 0): cosine -7/25, sine 24/25 about x. No double holds them.
  const Points turned =
      vertices(posed<D>(Segment<D>{Vec(0, 25, 0), Vec(0, 1, 0)}, Vec(0, 0, 0), {3, 4, 0, 0}));
  EXPECT_EQ(turned[0], at(0, -7, 24));
  EXPECT_EQ(turned[1], (RationalPoint{0, Rational(-7, 25), Rational(24, 25)}));
}

TEST(ExactBody, RadiiAddUpInSumsAndMustAgreeInHulls) {
  EXPECT_EQ(radius(sum<D>(Sphere<D>{1}, rounded<D>(Capsule<D>{2, 1}, 4))), 7);
  EXPECT_EQ(radius(hull_of<D>(Sphere<D>{3}, rounded<D>(Box<D>{Vec(1, 1, 1)}, 3))), 3);
  EXPECT_EQ(radius(hull_of<D>(rounded<D>(Sphere<D>{1}, 2), Capsule<D>{3, 1})), 3);
  // 0.1 + 0.2 as doubles is not 0.3 as a double.
  EXPECT_FALSE(is_exact_body(hull_of<D>(rounded<D>(Sphere<D>{0.1}, 0.2), Sphere<D>{0.3})));
  EXPECT_THROW(vertices(hull_of<D>(Sphere<D>{1}, Point<D>{})), std::invalid_argument);
}

TEST(ExactBody, SaysBeforehandWhatItRefuses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Shape<D> good[] = {Point<D>{},
                           Capsule<D>{0, 0},
                           Box<D>{Vec(0, 0, 0)},
                           Segment<D>{},
                           swept<D>(Sphere<D>{1}, Vec(1, 2, 3)),
                           Sum<D>{{share<D>(Point<D>{})}}};
  for (const Shape<D>& shape : good) {
    EXPECT_TRUE(is_exact_body(shape)) << shape.index();
    EXPECT_NO_THROW((void)exact_body({.shape = shape})) << shape.index();
  }
  const Shape<D> bad[] = {Ellipsoid<D>{Vec(1, 1, 1)},
                          Cylinder<D>{1, 1},
                          Cone<D>{1, 1},
                          rounded<D>(Cone<D>{1, 1}, 1),
                          sum<D>(Box<D>{}, Cylinder<D>{1, 1}),
                          Hull<D>{},
                          Hull<D>{Vec(nan, 0, 0)},
                          Segment<D>{Vec(0, 0, 0), Vec(0, nan, 0)},
                          Triangle<D>{Vec(0, 0, kInfinity<D>)},
                          Sphere<D>{-1},
                          Sphere<D>{nan},
                          Capsule<D>{1, -1},
                          Box<D>{Vec(1, -1, 1)},
                          rounded<D>(Point<D>{}, -1),
                          Posed<D>{},
                          Rounded<D>{},
                          Posed<D>{share<D>(Point<D>{}), Vec(0, 0, 0), {0, 0, 0, 0}},
                          Sum<D>{},
                          HullOf<D>{},
                          Sum<D>{{nullptr}},
                          hull_of<D>(Sphere<D>{1}, Sphere<D>{2})};
  for (const Shape<D>& shape : bad) {
    EXPECT_FALSE(is_exact_body(shape)) << shape.index();
    EXPECT_THROW((void)exact_body({.shape = shape}), std::invalid_argument) << shape.index();
  }
}

TEST(ExactBody, ASumOfTooManyVerticesIsRefusedByItsNumber) {
  const SharedShape<D> box = share<D>(Box<D>{Vec(1, 1, 1)});
  EXPECT_EQ(vertices(Sum<D>{{box, box, box, box}}).size(), kMostSumVertices);
  const Shape<D> five = Sum<D>{{box, box, box, box, box}};
  EXPECT_FALSE(is_exact_body(five));
  try {
    (void)exact_body({.shape = five});
    ADD_FAILURE() << "8^5 vertices were formed";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("4096"), std::string::npos) << e.what();
  }
  // A hull given as such is no product, and may have more.
  EXPECT_TRUE(is_exact_body(Hull<D>(std::vector<Vec>(5000, Vec(1, 2, 3)))));
}

// Four boxes summed up are one box four times as large.
TEST(ExactBody, ALargeSumIsReducedToItsExtremePoints) {
  const SharedShape<D> box = share<D>(Box<D>{Vec(1, 2, 3)});
  corpus::Case problem;
  problem.a.shape = Sum<D>{{box, box, box, box}};
  problem.b.shape = Sum<D>{{box, box, box, box}};
  problem.b.position = Vec(17, 0, 0);
  problem.b.displacement = Vec(-3, 0, 0);
  problem.t_max = 4;
  EXPECT_EQ(LinearTruth(problem).toi_exact(), "3");
  EXPECT_EQ(IntegerScene(problem).cso->hull().vertices.size(), 8u);
}

}  // namespace
}  // namespace graze::oracle
