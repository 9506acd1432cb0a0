// What the corpus stores comes from the oracle of the case's kind, with its name.
#include "oracles/derive.hpp"

#include <gtest/gtest.h>

#include "tests/oracles/small_pairs.hpp"

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

}  // namespace
}  // namespace graze::oracle
