// Penetration worked out by hand, against Nef polyhedra, linear and quadratic programs, and with wrong
// answers planted.
#include "oracles/truth/penetration_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/linear_program.hpp"
#include "oracles/polytope/nef_minkowski.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

constexpr double kInf = kInfinity<double>;

bool is(const Enclosure& x, double value) { return x.low == value && x.high == value; }
bool holds(const Enclosure& x, double value) { return x.low <= value && value <= x.high; }

corpus::Case boxes(const Vec& b_position) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Box<double>{Vec(1, 2, 3)};
  problem.b.position = b_position;
  return problem;
}

TEST(Penetration, OfAlignedBoxesIsTheLeastOverlap) {
  const PenetrationTruth truth(boxes(Vec(1.75, 0.5, -0.25)));
  EXPECT_TRUE(truth.in_contact());
  EXPECT_EQ(truth.dimension(), 3);
  EXPECT_EQ(truth.depth_sq_exact(), "1/16");
  EXPECT_TRUE(is(truth.depth(), 0.25));
  ASSERT_EQ(truth.normals().size(), 1u);
  EXPECT_EQ(truth.normals()[0], Vec(1, 0, 0));
}

TEST(Penetration, OfConcentricBoxesHasTwoNormalsAndOfACubeSix) {
  const PenetrationTruth truth(boxes(Vec(0, 0, 0)));
  EXPECT_TRUE(is(truth.depth(), 2));
  EXPECT_EQ(truth.normals(), (std::vector<Vec>{Vec(-1, 0, 0), Vec(1, 0, 0)}));
  corpus::Case cubes = boxes(Vec(0, 0, 0));
  cubes.b.shape = Point<double>{};
  EXPECT_EQ(PenetrationTruth(cubes).normals().size(), 6u);
}

TEST(Penetration, OfTouchingBodiesIsZero) {
  const PenetrationTruth face(boxes(Vec(2, 0, 0)));
  EXPECT_TRUE(is(face.depth(), 0));
  EXPECT_EQ(face.normals(), std::vector<Vec>{Vec(1, 0, 0)});
  const PenetrationTruth edge(boxes(Vec(2, 3, 0)));
  EXPECT_TRUE(is(edge.depth(), 0));
  EXPECT_TRUE(edge.normals().empty()) << "a quarter of a circle of them";
  EXPECT_TRUE(is(edge.normal_error(Vec(3, 4, 0)), 0));
  const PenetrationTruth apart(boxes(Vec(std::nextafter(2.0, 3.0), 0, 0)));
  EXPECT_FALSE(apart.in_contact());
  EXPECT_THROW((void)apart.depth(), std::logic_error);
}

TEST(Penetration, OfAFlatPairIsZeroAndItsNormalsAreThePlanes) {
  corpus::Case problem;
  problem.a.shape = Triangle<double>{Vec(0, 0, 0), Vec(4, 0, 0), Vec(0, 4, 0)};
  problem.b.shape = Segment<double>{Vec(-1, 1, 0), Vec(1, 1, 0)};
  const PenetrationTruth inside(problem);
  EXPECT_EQ(inside.dimension(), 2);
  EXPECT_TRUE(is(inside.depth(), 0));
  EXPECT_EQ(inside.normals(), (std::vector<Vec>{Vec(0, 0, -1), Vec(0, 0, 1)}));
  problem.b.position = Vec(0, -1, 0);  // the segment lies on the triangle's edge
  EXPECT_TRUE(PenetrationTruth(problem).normals().empty());
  problem.a.shape = Segment<double>{Vec(-3, 0, 0), Vec(3, 0, 0)};
  const PenetrationTruth line(problem);
  EXPECT_EQ(line.dimension(), 1);
  EXPECT_TRUE(is(line.depth(), 0));
  EXPECT_TRUE(line.normals().empty());
  EXPECT_TRUE(is(line.normal_error(Vec(0, 3, 4)), 0));
}

TEST(Penetration, RadiiAddToTheDepthOfTheCores) {
  corpus::Case problem = boxes(Vec(1.75, 0.5, -0.25));
  problem.b.shape = rounded<double>(problem.b.shape, 0.5);
  EXPECT_TRUE(is(PenetrationTruth(problem).depth(), 0.75));
  EXPECT_EQ(PenetrationTruth(problem).depth_sq_exact(), "9/16");
  problem.a.shape = rounded<double>(Box<double>{Vec(1, 1, 1)}, 4);
  problem.b.shape = rounded<double>(Point<double>{}, 5);
  problem.b.position = Vec(3, 4, 7);
  const PenetrationTruth corner(problem);
  EXPECT_TRUE(is(corner.depth(), 2)) << "the cores are |(2, 3, 6)| = 7 apart, the radii sum to 9";
  ASSERT_EQ(corner.normals().size(), 1u);
  EXPECT_EQ(corner.normals()[0], Vec(2.0 / 7, 3.0 / 7, 6.0 / 7));
  problem.b.position = Vec(3, 4, 0);  // the edge's, sqrt 13 away
  const PenetrationTruth edge(problem);
  EXPECT_TRUE(holds(edge.depth(), 9 - std::sqrt(13.0)));
  EXPECT_EQ(edge.depth().high, std::nextafter(edge.depth().low, 9));
  EXPECT_EQ(edge.depth_sq_exact(), "");
  EXPECT_LT((edge.normals().at(0) - Vec(2, 3, 0).normalized()).norm(), 1e-15);
  EXPECT_LT(edge.normal_error(edge.normals()[0]).high, 1e-15);
  EXPECT_GT(edge.normal_error(Vec(3, 2, 0)).low, 0.2);
}

TEST(Penetration, OfBallsIsAlongTheirCentres) {
  corpus::Case problem;
  problem.a.shape = Sphere<double>{2};
  problem.b.shape = Capsule<double>{1, 3};
  problem.b.position = Vec(0, 1, 2);
  const PenetrationTruth truth(problem);
  EXPECT_TRUE(is(truth.depth(), 2));
  EXPECT_EQ(truth.normals(), std::vector<Vec>{Vec(0, 1, 0)});
  problem.b.position = Vec(0, 0, 5);  // beyond the end of the core by 2
  EXPECT_TRUE(is(PenetrationTruth(problem).depth(), 1));
  problem.b.position = Vec(0, 0, 1);  // centre on the core
  const PenetrationTruth inside(problem);
  EXPECT_TRUE(is(inside.depth(), 3));
  EXPECT_TRUE(inside.normals().empty());
}

TEST(Penetration, TargetDistanceAndMotionAreNotLookedAt) {
  corpus::Case problem = boxes(Vec(1.75, 0.5, -0.25));
  problem.target_distance = 5;
  problem.b.displacement = Vec(1, 2, 3);
  EXPECT_TRUE(is(PenetrationTruth(problem).depth(), 0.25));
}

TEST(PenetrationAlong, IsTheWayOutInMultiplesOfTheDirection) {
  const PenetrationTruth truth(boxes(Vec(1.75, 0.5, -0.25)));
  const DepthAlong x = truth.along(Vec(3, 0, 0)).value();
  EXPECT_EQ(x.factor_exact, "1/12");
  EXPECT_EQ(x.length, 0.25);
  EXPECT_EQ(x.factor_bounds.high, std::nextafter(x.factor_bounds.low, 1));
  EXPECT_EQ(truth.along(Vec(0, -2, 0)).value().factor_exact, "7/4");
  EXPECT_EQ(truth.along(Vec(1, 1, 0)).value().factor_exact, "1/4");
  EXPECT_EQ(truth.along(Vec(1, 1, 0)).value().length, std::sqrt(0.125));
  EXPECT_THROW((void)truth.along(Vec(0, 0, 0)), std::invalid_argument);
  corpus::Case balls;
  balls.a.shape = Sphere<double>{2};
  balls.b.shape = Sphere<double>{1};
  balls.b.position = Vec(1, 0, 0);
  const DepthAlong aside = PenetrationTruth(balls).along(Vec(0, 2, 0)).value();  // (2 s)^2 + 1 = 9
  EXPECT_EQ(aside.factor, std::sqrt(2.0));
  EXPECT_EQ(aside.factor_exact, "");
  EXPECT_EQ(aside.length, std::sqrt(8.0));
  balls.b.position = Vec(4, 0, 0);
  EXPECT_FALSE(PenetrationTruth(balls).along(Vec(1, 0, 0)).has_value()) << "the ray leads away";
  EXPECT_EQ(PenetrationTruth(balls).along(Vec(-1, 0, 0)).value().length, 7) << "through and out";
}

TEST(PlantedError, ADepthOffByOneUnitIsTold) {
  const PenetrationTruth exact(boxes(Vec(1.75, 0.5, -0.25)));
  EXPECT_TRUE(is(exact.depth_error(0.25), 0));
  EXPECT_TRUE(is(exact.depth_error(std::nextafter(0.25, 1)), 0x1p-54));
  EXPECT_TRUE(is(exact.depth_error(std::nextafter(0.25, 0)), 0x1p-55));
  EXPECT_TRUE(is(exact.depth_error(0.25 + 1e-15), (0.25 + 1e-15) - 0.25));
  EXPECT_TRUE(is(exact.depth_error(NAN), kInf));
  corpus::Case problem = boxes(Vec(1.75, 0.5, -0.25));
  problem.b.orientation = {3, 1, 0, 2};
  problem.b.shape = rounded<double>(problem.b.shape, 0.1);
  const PenetrationTruth irrational(problem);
  const Enclosure depth = irrational.depth();
  ASSERT_LT(depth.low, depth.high);
  EXPECT_GT(irrational.depth_error(depth.low).low, 0);
  EXPECT_LT(irrational.depth_error(depth.low).high, depth.high - depth.low);
  EXPECT_GE(irrational.depth_error(std::nextafter(depth.high, kInf)).low, depth.high - depth.low);
}

TEST(PlantedError, AFlippedOrTiltedNormalOfPenetrationIsTold) {
  const PenetrationTruth truth(boxes(Vec(1.75, 0.5, -0.25)));
  EXPECT_TRUE(is(truth.normal_error(Vec(2, 0, 0)), 0));
  EXPECT_TRUE(is(truth.normal_error(Vec(-1, 0, 0)), 3.5));  // h(-x) = 3.75
  EXPECT_TRUE(is(truth.normal_error(Vec(0, 1, 0)), 2.25));  // h(y) = 2.5
  EXPECT_GT(truth.normal_error(Vec(1, 1e-9, 0)).low, 1e-9);
  EXPECT_TRUE(is(truth.normal_error(Vec(0, 0, 0)), kInf));
  EXPECT_TRUE(is(truth.reach(Vec(-1, 0, 0)), 3.75));
}

TEST(PlantedError, AWitnessOffItsShapeAndAPairOffTheBoundaryAreTold) {
  const PenetrationTruth truth(boxes(Vec(1.75, 0.5, -0.25)));
  // A's face at x = 1, B's at x = 0.75.
  const Vec on_a(1, 0.25, 0.5), on_b(0.75, 0.25, 0.5);
  EXPECT_TRUE(is(truth.distance_from_body('a', on_a), 0));
  EXPECT_TRUE(is(truth.distance_from_body('b', on_b), 0));
  EXPECT_TRUE(is(truth.distance_from_body('a', Vec(std::nextafter(1.0, 2), 0, 0)), 0x1p-52));
  EXPECT_TRUE(is(truth.pair_error(on_a, on_b), 0));
  EXPECT_TRUE(is(truth.pair_error(on_b, on_a), 0.5)) << "swapped: -x is half a unit inside";
  EXPECT_TRUE(is(truth.pair_error(on_a, on_b + Vec(1e-15, 0, 0)), on_b[0] + 1e-15 - on_b[0]));
  // As long as the depth, but not along the normal: 1/4 to the next face.
  EXPECT_TRUE(is(truth.pair_error(Vec(0, 0.25, 0), Vec(0, 0, 0)), 0.25));
  // On the boundary, but not the nearest point of it.
  EXPECT_GT(truth.pair_error(Vec(1, 0.5, 0), Vec(0.75, 0, 0)).low, 0.3);
  EXPECT_TRUE(is(truth.pair_error(Vec(NAN, 0, 0), on_b), kInf));
}

TEST(PlantedError, AWayOutOffByALittleIsTold) {
  const PenetrationTruth truth(boxes(Vec(1.75, 0.5, -0.25)));
  EXPECT_TRUE(is(truth.along_error(Vec(1, 0, 0), 0.25), 0));
  EXPECT_TRUE(is(truth.along_error(Vec(1, 0, 0), std::nextafter(0.25, 1)), 0x1p-54));
  EXPECT_TRUE(is(truth.along_error(Vec(1, 0, 0), std::nextafter(0.25, 0)), 0x1p-55));
  EXPECT_GT(truth.along_error(Vec(1, 0, 0), 0.25 + 1e-15).low, 9e-16);
  EXPECT_TRUE(is(truth.along_error(Vec(1, 0, 0), -0.5), kInf));
}

TEST(PenetrationAfter, AMoveByTheDepthAlongTheNormalLeavesTouch) {
  const PenetrationTruth truth(boxes(Vec(1.75, 0.5, -0.25)));
  EXPECT_TRUE(is(truth.depth_after(Vec(0.25, 0, 0)), 0));
  EXPECT_TRUE(is(truth.distance_after(Vec(0.25, 0, 0)), 0));
  EXPECT_TRUE(is(truth.depth_after(Vec(0.125, 0, 0)), 0.125));
  EXPECT_TRUE(is(truth.distance_after(Vec(0.5, 0, 0)), 0.25));
  EXPECT_TRUE(is(truth.depth_after(Vec(0, 0, 0)), truth.depth().low));
  EXPECT_TRUE(is(truth.depth_after(Vec(NAN, 0, 0)), kInf));
}

// Nef polyhedra give the squared depth, the linear program the way out, the quadratic program whether there
// is contact. No facet of the hull is used in any of them.
TEST(Penetration, IsWhatTheOtherJudgesSay) {
  SmallPairs pairs(53);
  int deep = 0, flat = 0, apart = 0, ways_out = 0;
  for (int i = 0; i < 400; ++i) {
    corpus::Case problem = i % 4 == 0 ? pairs.pair() : pairs.composed_pair();
    if (i % 3 != 0) problem.b.position = problem.a.position + pairs.vector(1);
    const PenetrationTruth truth(problem);
    corpus::Case at_rest = problem;
    at_rest.a.displacement = at_rest.b.displacement = Vec::Zero();
    ASSERT_EQ(truth.in_contact(), sgn(distance_sq_by_quadratic_program(at_rest, 0)) == 0) << "case " << i;
    if (!truth.in_contact()) {
      ++apart;
      continue;
    }
    Vec d = pairs.vector(3);
    if (d.isZero(0)) d = Vec(1, 0, 0);
    corpus::Case line = at_rest;
    line.b.displacement = d;
    const auto times = contact_times_by_linear_program(line).value();
    ASSERT_EQ(times.second.get_str(), truth.along(d).value().factor_exact) << "case " << i;
    ways_out += sgn(times.second) > 0;
    if (truth.dimension() < 3) {
      ++flat;
      ASSERT_EQ(truth.depth_sq_exact(), "0") << "case " << i;
      continue;
    }
    if (deep >= 60 || exact_body(problem.a).vertices.size() * exact_body(problem.b).vertices.size() > 200)
      continue;
    const Rational squared = nef_cso(at_rest).depth_sq();
    ASSERT_EQ(squared.get_str(), truth.depth_sq_exact()) << "case " << i;
    deep += sgn(squared) > 0;
    if (sgn(squared) > 0) {
      ASSERT_FALSE(truth.normals().empty());
    }
    for (const Vec& n : truth.normals()) {
      ASSERT_LT(truth.normal_error(n).high, 1e-14) << "case " << i;
      ASSERT_LT(truth.distance_after(truth.nearest_depth() * n).high, 1e-14);
      ASSERT_LT(truth.depth_after(truth.nearest_depth() * n).high, 1e-14);
    }
  }
  EXPECT_GE(deep, 40);
  EXPECT_GE(flat, 10);
  EXPECT_GE(apart, 40);
  EXPECT_GE(ways_out, 60);
}

// The least depth of a rounded pair. Every direction of a fan reaches at least as far, and one of them nearly
// so. After a move by it, the quadratic program finds the bodies apart.
TEST(Penetration, OfRoundedPairsIsTheLeastReachOfAnyDirection) {
  SmallPairs pairs(59);
  int inside = 0, outside = 0;
  for (int i = 0; i < 300; ++i) {
    corpus::Case problem = pairs.composed_pair();
    problem.a.shape = rounded<double>(problem.a.shape, 1.5);
    problem.a.displacement = problem.b.displacement = Vec::Zero();
    const PenetrationTruth truth(problem);
    if (!truth.in_contact()) continue;
    const bool cores_meet = sgn(distance_sq_by_quadratic_program(problem, 0)) == 0;
    ++(cores_meet ? inside : outside);
    if (!cores_meet) {
      ASSERT_EQ(truth.normals().size(), 1u);
    }
    for (int k = 0; k < 20; ++k) {
      const Vec n = pairs.vector(5);
      if (n.isZero(0)) continue;
      ASSERT_GE(truth.normal_error(n).low, 0);
    }
    for (const Vec& n : truth.normals()) {
      ASSERT_LT(truth.normal_error(n).high, 1e-14);
      corpus::Case moved = problem;
      moved.b.position += (truth.nearest_depth() + 1e-9) * n;
      ASSERT_GT(distance_sq_by_quadratic_program(moved, 0), Rational(2.25)) << "case " << i;
      moved.b.position = problem.b.position + (truth.nearest_depth() - 1e-9) * n;
      ASSERT_LT(distance_sq_by_quadratic_program(moved, 0), Rational(2.25)) << "case " << i;
    }
  }
  EXPECT_GE(inside, 30);
  EXPECT_GE(outside, 15);
}

}  // namespace
}  // namespace graze::oracle
