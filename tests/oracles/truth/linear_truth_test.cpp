// Answers worked out by hand, and wrong answers that must be told apart from them.
#include "oracles/truth/linear_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

constexpr double kInf = kInfinity<double>;

bool holds(const Enclosure& x, double value) { return x.low <= value && value <= x.high; }

corpus::Case ball_on_slab() {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(500, 500, 500)};
  problem.a.position = Vec(0, -500, 0);
  problem.b.shape = Sphere<double>{0.5166};
  problem.b.position = Vec(3, 10, -7);
  problem.b.displacement = Vec(0, -20, 0);
  return problem;
}

corpus::Case boxes_a_unit_apart() {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Box<double>{Vec(1, 2, 3)};
  problem.b.position = Vec(3, 0.5, 0.25);
  problem.b.displacement = Vec(-3, 0, 0);
  return problem;
}

corpus::Case two_balls(double gap, double closing) {  // radii 1 and 2 on the x-axis
  corpus::Case problem;
  problem.a.shape = Sphere<double>{1};
  problem.b.shape = Sphere<double>{2};
  problem.b.position = Vec(3 + gap, 0, 0);
  problem.b.displacement = Vec(-closing, 0, 0);
  return problem;
}

// (10 - 0.5166) / 20 with the double nearest 0.5166, worked out over 2^53.
TEST(LinearTruth, BallOnABigSlabIsALinearEquation) {
  const LinearTruth truth(ball_on_slab());
  EXPECT_EQ(truth.outcome(), Outcome::hit);
  EXPECT_EQ(truth.toi_exact(), "21354718353102681/45035996273704960");
  EXPECT_EQ(truth.toi_lower(), 0.47417);
  EXPECT_EQ(truth.toi_upper(), 0.47417000000000004);
  EXPECT_EQ(truth.compare(truth.toi_lower()), -1);
  EXPECT_EQ(truth.compare(truth.toi_upper()), 1);
  EXPECT_TRUE(holds(truth.distance(), 10 - 0.5166));
}

TEST(LinearTruth, BallsOnALineMeetAfterTheirGap) {
  const LinearTruth truth(two_balls(2, 4));
  EXPECT_EQ(truth.toi_exact(), "1/2");
  EXPECT_EQ(truth.toi_lower(), 0.5);
  EXPECT_EQ(truth.toi_upper(), 0.5);
  EXPECT_EQ(truth.compare(0.5), 0);
  EXPECT_EQ(truth.compare(std::nextafter(0.5, 0)), -1);
  EXPECT_EQ(truth.compare(std::nextafter(0.5, 1)), 1);
  EXPECT_EQ(truth.distance().low, 2);
  EXPECT_EQ(truth.depth().low, 2);  // the centre ends 1 away from A's, the radii sum to 3
  corpus::Case through = two_balls(2, 16);
  EXPECT_EQ(LinearTruth(through).depth().low, 3);  // sideways
  through.t_max = kInf;
  EXPECT_EQ(LinearTruth(through).depth().low, 3);
}

// |(5, 2) - 4 t (1, 0)| = 3: t = (5 - sqrt 5) / 4, irrational.
TEST(LinearTruth, BallsPastEachOtherMeetAtTheSmallerRoot) {
  corpus::Case problem = two_balls(2, 4);
  problem.b.position[1] = 2;
  const LinearTruth truth(problem);
  EXPECT_EQ(truth.toi_exact(), "");
  EXPECT_DOUBLE_EQ(truth.toi_lower(), (5 - std::sqrt(5.0)) / 4);
  EXPECT_EQ(truth.toi_upper(), std::nextafter(truth.toi_lower(), 1));
  EXPECT_EQ(truth.compare(truth.toi_lower()), -1);
  EXPECT_EQ(truth.compare(truth.toi_upper()), 1);
  const Enclosure short_by = truth.forward_error(truth.toi_lower());
  EXPECT_GT(short_by.low, 0);
  EXPECT_LT(short_by.high, 4 * (truth.toi_upper() - truth.toi_lower()));
}

TEST(LinearTruth, BallsThatGrazeTouchInOnePointOnly) {
  corpus::Case problem = two_balls(2, 4);
  problem.b.position[1] = 3;
  problem.t_max = kInf;
  const LinearTruth touching(problem);
  EXPECT_EQ(touching.outcome(), Outcome::hit);
  EXPECT_EQ(touching.toi_exact(), "5/4");
  EXPECT_EQ(touching.depth().high, 0);
  problem.b.position[1] = std::nextafter(3.0, 4.0);
  const LinearTruth passing(problem);
  EXPECT_EQ(passing.outcome(), Outcome::miss);
  EXPECT_EQ(passing.clearance().low, std::nextafter(3.0, 4.0) - 3);
  EXPECT_EQ(passing.toi_lower(), kInf);
  EXPECT_EQ(passing.compare(1e300), -1);
}

TEST(LinearTruth, AlignedBoxesMeetAtAThird) {
  const LinearTruth truth(boxes_a_unit_apart());
  EXPECT_EQ(truth.outcome(), Outcome::hit);
  EXPECT_EQ(truth.dimension(), 3);
  EXPECT_EQ(truth.toi_exact(), "1/3");
  EXPECT_EQ(truth.toi_upper(), std::nextafter(truth.toi_lower(), 1));
  // The sweep of C = [-2,2] x [-3,3] x [-4,4] less (3, .5, .25) reaches 2 beyond the origin along x, 2.5
  // along y.
  EXPECT_EQ(truth.depth().low, 2);
  EXPECT_EQ(truth.depth_before(0.5).low, 0.5);
  EXPECT_EQ(truth.depth_before(0.25).high, 0);
  EXPECT_EQ(truth.distance_at(0.25).low, 0.25);
  EXPECT_EQ(truth.distance_at(0.5).high, 0);
  EXPECT_EQ(truth.backward_error(0.25).low, 0.25);
  EXPECT_EQ(truth.backward_error(0.5).high, 0.5);
  EXPECT_EQ(truth.backward_error(kInf).low, kInf);
  EXPECT_TRUE(holds(truth.scale(), std::sqrt(4.0 + 16 + 36)));
}

TEST(LinearTruth, TargetDistanceRoundsTheBoxes) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.target_distance = 0.25;
  EXPECT_EQ(LinearTruth(problem).toi_exact(), "1/4");
  problem.b.position[1] = 3.15;  // beside A by 0.15 and a bit: the rounded edge is met, |(x, 0.15)| = 0.25
  const LinearTruth edge(problem);
  EXPECT_EQ(edge.outcome(), Outcome::hit);
  EXPECT_NEAR(edge.toi_lower(), 0.8 / 3, 1e-15);
  EXPECT_EQ(edge.compare(edge.toi_lower()), -1);
  EXPECT_EQ(edge.compare(edge.toi_upper()), 1);
  EXPECT_TRUE(holds(edge.depth(), 0.25 - (3.15 - 3)));
  problem.b.position[1] = 3.25;
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::hit) << "the rounded edge is grazed";
  problem.b.position[1] = std::nextafter(3.25, 4);
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::miss);
}

TEST(LinearTruth, WithoutMotionThereIsContactAtOnceOrNever) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.b.displacement.setZero();
  problem.t_max = kInf;
  const LinearTruth apart(problem);
  EXPECT_EQ(apart.outcome(), Outcome::miss);
  EXPECT_EQ(apart.clearance().low, 1);
  EXPECT_FALSE(apart.contact_interval().has_value());
  problem.b.position[0] = 2;
  const LinearTruth touching(problem);
  EXPECT_EQ(touching.outcome(), Outcome::initially_overlapping);
  EXPECT_EQ(touching.toi_exact(), "0");
  EXPECT_EQ(touching.depth().high, 0);
  EXPECT_EQ(touching.contact_interval()->t_out, kInf);
}

TEST(LinearTruth, HorizonEndsThePathAndTouchingAtItIsContact) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.b.displacement = Vec(-4, 0, 0);
  problem.t_max = 0.25;
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::hit);
  problem.t_max = std::nextafter(0.25, 0);
  const LinearTruth before(problem);
  EXPECT_EQ(before.outcome(), Outcome::miss);
  EXPECT_TRUE(holds(before.clearance(), 4 * (0.25 - problem.t_max)));
}

TEST(LinearTruth, PassOverDropsStartsThatLeaveOrSlide) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.start_policy = corpus::StartPolicy::pass_over;
  problem.b.position[0] = 2;  // touching, and moves into A
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::initially_overlapping);
  problem.b.displacement = Vec(1, 0, 0);
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::miss);
  problem.b.displacement = Vec(0, 1, 0);
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::miss);
  problem.b.position[0] = 1.5;  // overlapping: not a start that leaves
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::initially_overlapping);
  corpus::Case balls = two_balls(0, 4);
  balls.start_policy = corpus::StartPolicy::pass_over;
  EXPECT_EQ(LinearTruth(balls).outcome(), Outcome::initially_overlapping);
  balls.b.displacement = Vec(0, 1, 0);
  EXPECT_EQ(LinearTruth(balls).outcome(), Outcome::miss);
}

// Moved by little, a start that is deep in the target distance is passed over.
TEST(LinearTruth, DepthUnderPassOverIsThatOfTheRay) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.b.position[0] = 1.75;  // overlaps by 1/4, at rest
  problem.b.displacement = Vec(0, 0, 0);
  problem.target_distance = 1;
  EXPECT_TRUE(holds(LinearTruth(problem).depth(), 1.25));
  problem.start_policy = corpus::StartPolicy::pass_over;
  EXPECT_TRUE(holds(LinearTruth(problem).depth(), 0.25));
  problem.b.displacement = Vec(-0.125, 0, 0);  // the ray continues beyond the horizon, through all of A
  problem.b.position[1] = 2.875;
  EXPECT_TRUE(holds(LinearTruth(problem).depth(), 0.125));
}

// Contact may be asked for once the ray meets C without the target distance, or the start is out of C.
TEST(LinearTruth, ClearanceOfAPassedOverStartIsThatOfItsRay) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.start_policy = corpus::StartPolicy::pass_over;
  problem.b.position[0] = 2.25;
  problem.target_distance = 1;
  problem.b.displacement = Vec(1, 0, 0);
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::miss);
  EXPECT_TRUE(holds(LinearTruth(problem).clearance(), 0.25));
  problem.b.position = Vec(2.5, 3.125, 0);
  problem.b.displacement = Vec(-0.125, 0, 0);  // the ray continues beyond the horizon, over A
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::miss);
  EXPECT_TRUE(holds(LinearTruth(problem).clearance(), 0.125));
  problem.b.position = Vec(2.875, 0, 0);  // the start is the lesser: 1/8 in
  problem.b.displacement = Vec(0, 1, 0);
  EXPECT_TRUE(holds(LinearTruth(problem).clearance(), 0.125));
  problem.b.position = Vec(2, 0, 0);  // touching
  EXPECT_EQ(LinearTruth(problem).clearance().high, 0);
}

// It starts 1/8 short of the target distance of what it slides past: no less makes it a start that slides.
TEST(LinearTruth, DepthUnderPassOverCountsWhatMakesAStart) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.b.position = Vec(3.125, 0, 0);
  problem.target_distance = 1;
  problem.b.displacement = Vec(-1, 4, 0);  // beside A it is deeper, but not in the shapes
  EXPECT_EQ(LinearTruth(problem).outcome(), Outcome::hit);
  EXPECT_GT(LinearTruth(problem).depth().low, 0.5);
  problem.start_policy = corpus::StartPolicy::pass_over;
  EXPECT_TRUE(holds(LinearTruth(problem).depth(), 0.125));
  problem.b.displacement = Vec(-1, 0, 0);  // into A: no start that leaves
  EXPECT_TRUE(holds(LinearTruth(problem).depth(), 0.875));
}

TEST(LinearTruth, SubnormalAndHugeTimesAreRoundedAsAnyOther) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.b.displacement = Vec(-3e300, 0, 0);
  problem.b.position[0] = 2 + 0x1p-51;  // 2^-51 / 3e300: far below the normal doubles
  const LinearTruth tiny(problem);
  EXPECT_EQ(tiny.outcome(), Outcome::hit);
  EXPECT_LT(tiny.toi_upper(), std::numeric_limits<double>::min());
  EXPECT_GT(tiny.toi_upper(), 0);
  EXPECT_EQ(tiny.toi_upper(), std::nextafter(tiny.toi_lower(), 1));
  EXPECT_EQ(tiny.compare(tiny.toi_lower()), -1);
  EXPECT_EQ(tiny.compare(tiny.toi_upper()), 1);
  problem.b.displacement = Vec(-0x1p-1074, 0, 0);
  problem.t_max = kInf;
  const LinearTruth huge(problem);
  EXPECT_EQ(huge.outcome(), Outcome::hit);
  EXPECT_EQ(huge.toi_lower(), 0x1p+1023);
  EXPECT_EQ(huge.toi_upper(), 0x1p+1023);
}

TEST(PlantedError, ATimeOneUnitOffIsTold) {
  SmallPairs pairs(5);
  int polytope_hits = 0, rounded_hits = 0;
  for (int i = 0; i < 300; ++i) {
    corpus::Case problem = pairs.pair();
    if (i % 2 == 1) problem.a.shape = Sphere<double>{0.75};
    const LinearTruth truth(problem);
    if (truth.outcome() != Outcome::hit) continue;
    ++(i % 2 == 1 ? rounded_hits : polytope_hits);
    const double low = truth.toi_lower(), high = truth.toi_upper();
    ASSERT_LE(truth.compare(low), 0);
    ASSERT_GE(truth.compare(high), 0);
    ASSERT_EQ(truth.compare(std::nextafter(low, -kInf)), -1);
    ASSERT_EQ(truth.compare(std::nextafter(high, kInf)), 1);
    ASSERT_EQ(truth.lateness(low).high, 0);
  }
  EXPECT_GE(polytope_hits, 30);
  EXPECT_GE(rounded_hits, 30);
}

TEST(PlantedError, ATimeLateByAMillionthOfABillionthIsLate) {
  const LinearTruth boxes(boxes_a_unit_apart());
  const double late = 1.0 / 3 + 1e-15;
  EXPECT_EQ(boxes.lateness(boxes.toi_lower()).high, 0);
  EXPECT_GT(boxes.lateness(late).low, 2.9e-15);
  EXPECT_LT(boxes.lateness(late).high, 3.2e-15);
  EXPECT_GT(boxes.forward_error(late).low, 2.9e-15);
  const LinearTruth ball(ball_on_slab());
  EXPECT_GT(ball.lateness(0.47417 + 1e-15).low, 1.8e-14);
  EXPECT_LT(ball.lateness(0.47417 + 1e-15).high, 2.3e-14);
}

TEST(PlantedError, AClaimedMissIsAsLateAsTheHitIsDeep) {
  const LinearTruth truth(boxes_a_unit_apart());
  EXPECT_EQ(truth.lateness(kInf).low, truth.depth().low);
  EXPECT_EQ(truth.lateness(2).low, truth.depth().low);
}

TEST(PlantedError, AFlippedOrTiltedNormalIsTold) {
  const LinearTruth boxes(boxes_a_unit_apart());
  EXPECT_EQ(boxes.normal_error(Vec(1, 0, 0)).high, 0);
  EXPECT_EQ(boxes.normal_error(Vec(-1, 0, 0)).low, 4);
  EXPECT_GT(boxes.normal_error(Vec(1, 1e-9, 0)).low, 1e-10);
  EXPECT_EQ(boxes.normal_error(Vec(0, 0, 0)).low, kInf);
  const LinearTruth balls(two_balls(2, 4));
  EXPECT_EQ(balls.normal_error(Vec(2, 0, 0)).high, 0);
  EXPECT_EQ(balls.normal_error(Vec(-1, 0, 0)).low, 6);
}

TEST(PlantedError, AWitnessOffItsShapeIsTold) {
  const LinearTruth boxes(boxes_a_unit_apart());
  EXPECT_EQ(boxes.distance_from_body('a', 0, Vec(1, 0.5, 0.5)).high, 0);
  EXPECT_TRUE(holds(boxes.distance_from_body('a', 0, Vec(std::nextafter(1.0, 2.0), 0, 0)), 0x1p-52));
  EXPECT_EQ(boxes.distance_from_body('b', 0.5, Vec(0.25, 0, 0)).low, 0.25);  // B's face is at 2 - 3 t
  const LinearTruth ball(ball_on_slab());
  EXPECT_EQ(ball.distance_from_body('b', 0, Vec(3, 10, -6.5)).high, 0);
  EXPECT_TRUE(holds(ball.distance_from_body('b', 0, Vec(3, 10, -6)), 1 - 0.5166));
  EXPECT_EQ(ball.distance_from_body('b', 0, Vec(NAN, 0, 0)).low, kInf);
}

// Depth is the least translation after which the path misses: none shorter will do, whatever its direction,
// and along the normal that attains it a longer one does. Clearance the other way round.
TEST(Depth, NoShorterTranslationMakesThePathMiss) {
  SmallPairs pairs(13);
  int deep = 0;
  for (int i = 0; i < 400; ++i) {
    corpus::Case problem = pairs.pair();
    if (i % 2 == 1) problem.target_distance = 0.5;
    const LinearTruth truth(problem);
    const double depth = truth.depth().low;
    if (!(depth > 0)) continue;
    ++deep;
    for (int k = 0; k < 4; ++k) {
      Vec direction = pairs.vector(4);
      if (direction.isZero(0)) direction = Vec(1, 0, 0);
      corpus::Case moved = problem;
      moved.a.position += 0.999 * depth * direction.normalized();
      ASSERT_NE(LinearTruth(moved).outcome(), Outcome::miss) << "case " << i;
    }
  }
  EXPECT_GE(deep, 50);
}

TEST(Depth, IsAttainedInSomeDirection) {
  SmallPairs pairs(17);
  int deep = 0;
  for (int i = 0; i < 60; ++i) {
    corpus::Case problem = pairs.pair();
    if (i % 2 == 1) problem.target_distance = 0.5;
    const LinearTruth truth(problem);
    const double depth = truth.depth().low;
    if (!(depth > 0)) continue;
    ++deep;
    // A fan of directions about 0.16 apart: one of them is within 0.12 of the best, whose cosine exceeds
    // 0.99.
    bool missed = false;
    constexpr int kRings = 20;
    for (int ring = 0; ring <= kRings && !missed; ++ring) {
      const double polar = std::numbers::pi * ring / kRings;
      const int steps = 1 + static_cast<int>(2 * kRings * std::sin(polar));
      for (int step = 0; step < steps && !missed; ++step) {
        const double turn = 2 * std::numbers::pi * step / steps;
        corpus::Case moved = problem;
        moved.a.position +=
            1.02 * depth *
            Vec(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
        missed = LinearTruth(moved).outcome() == Outcome::miss;
      }
    }
    ASSERT_TRUE(missed) << "case " << i << ", depth " << depth;
    if (deep == 8) break;
  }
  EXPECT_EQ(deep, 8);
}

TEST(LinearTruth, RefusesWhatItDoesNotDecide) {
  corpus::Case problem = boxes_a_unit_apart();
  problem.spin_b.rotation = Vec(0, 0, 1);
  EXPECT_THROW(LinearTruth{problem}, std::invalid_argument);
  problem = boxes_a_unit_apart();
  problem.b.position[0] = NAN;
  EXPECT_THROW(LinearTruth{problem}, std::invalid_argument);
  problem = boxes_a_unit_apart();
  problem.a.orientation = {0, 0, 0, 0};
  EXPECT_THROW(LinearTruth{problem}, std::invalid_argument);
  problem = boxes_a_unit_apart();
  problem.a.shape = Hull<double>();
  EXPECT_THROW(LinearTruth{problem}, std::invalid_argument);
  problem = boxes_a_unit_apart();
  problem.t_max = -1;
  EXPECT_THROW(LinearTruth{problem}, std::invalid_argument);
  problem = boxes_a_unit_apart();
  problem.a.shape = Cylinder<double>{1, 1};
  EXPECT_THROW(LinearTruth{problem}, std::invalid_argument);
}

}  // namespace
}  // namespace graze::oracle
