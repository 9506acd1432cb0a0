// The truth that the corpus stores comes from the oracle of the case's kind, with its name.
#include "oracles/truth/derive.hpp"

#include <gtest/gtest.h>

#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

corpus::Case point_and_box() {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.position = Vec(4, 0, 0);
  problem.b.displacement = Vec(-9, 0, 0);
  return problem;
}

TEST(DeriveExpectation, CastOfAPolytopeIsTheExactCso) {
  const corpus::Expect expect = derive_expectation(point_and_box());
  EXPECT_EQ(expect.by, "exact CSO (CGAL convex_hull_3)");
  EXPECT_EQ(expect.outcome, Outcome::hit);
  EXPECT_EQ(expect.toi_exact, "1/3");
  EXPECT_LT(expect.toi_lower.value(), expect.toi_upper.value());
  EXPECT_FALSE(expect.t_in.has_value());
}

// Rounded so that what exceeds a tolerance by them does so in truth: lengths down, the scale up.
TEST(DeriveExpectation, CastSaysHowFarItsPathIsFromAnotherAnswer) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Point<double>{};
  problem.b.position = Vec(-4, 0.75, 0);
  problem.b.displacement = Vec(8, 0, 0);
  corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.outcome, Outcome::hit);
  EXPECT_EQ(expect.path_depth.value(), 0.25);
  EXPECT_FALSE(expect.clearance.has_value());
  EXPECT_NEAR(expect.scale.value(), std::sqrt(16.5625), 1e-15);  // between the centres
  EXPECT_GE(expect.scale.value() * expect.scale.value(), 16.5625 * (1 - 0x1p-52));
  problem.b.position = Vec(-4, 2, 2);  // passes the edge by the root of 2
  expect = derive_expectation(problem);
  EXPECT_EQ(expect.outcome, Outcome::miss);
  EXPECT_FALSE(expect.path_depth.has_value());
  EXPECT_GT(std::sqrt(2.0) * std::sqrt(2.0), 2) << "the nearest double is above the root";
  EXPECT_EQ(expect.clearance.value(), std::nextafter(std::sqrt(2.0), 0.0));
  problem.query = corpus::Query::swept_overlap;
  EXPECT_FALSE(derive_expectation(problem).has_measures());
}

TEST(DeriveExpectation, CurvedCastHasALowerBoundOfItsClearance) {
  corpus::Case problem;
  problem.a.shape = Ellipsoid<double>{Vec(1, 2, 3)};
  problem.b.shape = Ellipsoid<double>{Vec(1, 1, 2)};
  problem.b.position = Vec(-4, 0, 5.5);  // passes the poles by a half
  problem.b.displacement = Vec(8, 0, 0);
  const corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.outcome, Outcome::miss);
  EXPECT_LE(expect.clearance.value(), 0.5);
  EXPECT_NEAR(expect.clearance.value(), 0.5, 1e-12);
}

TEST(DeriveExpectation, LineHasItsSignedInterval) {
  corpus::Case problem = point_and_box();
  problem.query = corpus::Query::line;
  problem.b.displacement = Vec(8, 0, 0);  // A lies behind: t in [-5/8, -3/8]
  const corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.outcome, Outcome::miss);
  EXPECT_EQ(expect.t_in.value(), -0.625);
  EXPECT_EQ(expect.t_out.value(), -0.375);
  EXPECT_EQ(expect.toi_lower.value(), kInfinity<double>);
}

TEST(DeriveExpectation, DistanceIsAskedAtTheStart) {
  corpus::Case problem = point_and_box();
  problem.query = corpus::Query::distance;
  problem.b.position = Vec(2, 2, 2);
  const corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.outcome, Outcome::miss);
  EXPECT_EQ(expect.distance.value(), std::sqrt(3.0));
  EXPECT_FALSE(expect.toi_lower.has_value());
  problem.b.position = Vec(1, 1, 1);
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::initially_overlapping);
}

TEST(DeriveExpectation, RoundedShapesNameTheirOwnOracle) {
  corpus::Case problem = point_and_box();
  problem.b.shape = Sphere<double>{0.5};
  EXPECT_EQ(derive_expectation(problem).by, "exact rounded CSO");
  problem.a.shape = Sphere<double>{0.5};
  EXPECT_EQ(derive_expectation(problem).by, "closed form");
  EXPECT_EQ(derive_expectation(problem).toi_exact, "1/3");
}

TEST(DeriveExpectation, LineOfRoundedShapesHasItsInterval) {
  corpus::Case problem = point_and_box();
  problem.query = corpus::Query::line;
  problem.b.shape = Capsule<double>{1, 2};
  problem.b.displacement = Vec(8, 0, 0);
  const corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.t_in.value(), -0.75);
  EXPECT_EQ(expect.t_out.value(), -0.25);
  problem.b.position = Vec(4, 9, 0);
  EXPECT_FALSE(derive_expectation(problem).t_in.has_value());
}

TEST(DeriveExpectation, PenetrationHasItsDepthAndItsOneNormal) {
  corpus::Case problem = point_and_box();
  problem.query = corpus::Query::penetration;
  problem.b.shape = Segment<double>{Vec(-0.25, 0, 0), Vec(0.25, 0, 0)};
  problem.b.position = Vec(0, -0.5, 0);
  const corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.outcome, Outcome::initially_overlapping);
  EXPECT_EQ(expect.by, "exact CSO (CGAL convex_hull_3)");
  EXPECT_EQ(expect.depth.value(), 0.5);
  EXPECT_EQ(expect.normal.value(), Vec(0, -1, 0));
  EXPECT_FALSE(expect.toi_lower.has_value());
  problem.b.position = Vec(0, 0, 0);
  EXPECT_EQ(derive_expectation(problem).depth.value(), 1);
  EXPECT_FALSE(derive_expectation(problem).normal.has_value()) << "up and down are as near";
  problem.b.position = Vec(0, 3, 0);
  problem.target_distance = 5;
  const corpus::Expect apart = derive_expectation(problem);
  EXPECT_EQ(apart.outcome, Outcome::miss) << "penetration is of the shapes themselves";
  EXPECT_EQ(apart.distance.value(), 2);
  EXPECT_FALSE(apart.depth.has_value());
}

TEST(DeriveExpectation, PenetrationAlongIsTheLengthOfTheMove) {
  corpus::Case problem = point_and_box();
  problem.query = corpus::Query::penetration_along;
  problem.b.position = Vec(0.5, 0, 0);
  problem.direction = Vec(-3, 4, 0);
  EXPECT_EQ(derive_expectation(problem).depth.value(), 1.25);
  problem.direction = Vec(2, 0, 0);
  EXPECT_EQ(derive_expectation(problem).depth.value(), 0.5);
  problem.b.position = Vec(3, 0, 0);
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::miss);
}

TEST(DeriveExpectation, StartPolicyPassesOverOnlyWhatLeavesOrSlides) {
  corpus::Case problem = point_and_box();
  problem.start_policy = corpus::StartPolicy::pass_over;
  problem.b.position = Vec(1, 0, 0);
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::initially_overlapping);
  problem.b.displacement = Vec(0, 9, 0);
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::miss);
  EXPECT_EQ(derive_expectation(problem).toi_lower.value(), kInfinity<double>);
  problem.query = corpus::Query::overlap;
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::initially_overlapping) << "nothing starts there";
}

TEST(DeriveExpectation, SweptOverlapIsAnyContactOnTheWay) {
  corpus::Case problem = point_and_box();
  problem.query = corpus::Query::swept_overlap;
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::hit);
  EXPECT_FALSE(derive_expectation(problem).toi_lower.has_value());
  problem.b.displacement = Vec(-2.75, 0, 0);
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::miss);
  problem.b.position = Vec(0, 1, 0);
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::hit) << "at the start";
}

TEST(DeriveExpectation, CurvedShapesByClosedFormOrBracket) {
  corpus::Case problem = point_and_box();
  problem.a.shape = Cone<double>{1, 1};  // at z = 0 half its radius
  corpus::Expect expect = derive_expectation(problem);
  EXPECT_EQ(expect.by, "closed form");
  EXPECT_EQ(expect.toi_exact, "7/18");

  problem.b.shape = Ellipsoid<double>{Vec(0.5, 2, 1)};
  expect = derive_expectation(problem);
  EXPECT_EQ(expect.by, "bracket in ball arithmetic (Arb)");
  EXPECT_EQ(expect.outcome, Outcome::hit);
  // Neighbouring doubles, before the spheres around both could meet and after the inner ones must.
  EXPECT_EQ(std::nextafter(*expect.toi_lower, 1), *expect.toi_upper);
  EXPECT_GT(*expect.toi_lower, 1.0 / 9);
  EXPECT_LT(*expect.toi_upper, 4.0 / 9);

  problem.query = corpus::Query::distance;
  problem.b.shape = Point<double>{};
  expect = derive_expectation(problem);
  // The slant from (1, -1) to (0, 1), seen from (4, 0), is nearest at its foot: sqrt(3^2 + 1^2).
  EXPECT_DOUBLE_EQ(*expect.distance, std::sqrt(10.0));

  problem.query = corpus::Query::penetration;
  EXPECT_THROW((void)derive_expectation(problem), Undecided);
}

}  // namespace
}  // namespace graze::oracle
