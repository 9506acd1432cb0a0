// The signed answer [t_in, t_out] and the starts that leave or slide: by hand, against linear programs, and
// with wrong answers planted.
#include <gtest/gtest.h>

#include <cmath>

#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/linear_program.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

constexpr double kInf = kInfinity<double>;

corpus::Case ball_through_ball(double beside) {
  corpus::Case problem;
  problem.a.shape = Sphere<double>{1};
  problem.b.shape = Sphere<double>{2};
  problem.b.position = Vec(0, beside, 0);
  problem.b.displacement = Vec(4, 0, 0);
  return problem;
}

TEST(ContactInterval, OfBallsAreTheTwoRoots) {
  const ContactInterval centred = LinearTruth(ball_through_ball(0)).contact_interval().value();
  EXPECT_EQ(centred.in_exact, "-3/4");
  EXPECT_EQ(centred.out_exact, "3/4");
  EXPECT_EQ(centred.in.low, -0.75);
  EXPECT_EQ(centred.in.high, -0.75);
  const ContactInterval beside = LinearTruth(ball_through_ball(1)).contact_interval().value();  // sqrt 8 / 4
  EXPECT_EQ(beside.out_exact, "");
  EXPECT_EQ(beside.t_out, std::sqrt(0.5));
  EXPECT_EQ(beside.t_in, -std::sqrt(0.5));
  EXPECT_EQ(beside.out.high, std::nextafter(beside.out.low, 1));
  EXPECT_EQ(beside.in.low, -beside.out.high);
  const ContactInterval graze = LinearTruth(ball_through_ball(3)).contact_interval().value();
  EXPECT_EQ(graze.in_exact, "0");
  EXPECT_EQ(graze.out_exact, "0");
  EXPECT_FALSE(LinearTruth(ball_through_ball(std::nextafter(3.0, 4.0))).contact_interval().has_value());
}

// Ends of very different magnitudes: B's centre is 2^-200 inside of A's surface, and 2 - 2^-200 from the
// other.
TEST(ContactInterval, AnEndNearZeroIsAsGoodAsAnyOther) {
  corpus::Case problem;
  problem.a.shape = Sphere<double>{1};
  problem.a.position = Vec(1, 0, 0);
  problem.b.position = Vec(0x1p-200, 0, 0);
  problem.b.displacement = Vec(1, 0, 0);
  const ContactInterval centred = LinearTruth(problem).contact_interval().value();
  EXPECT_EQ(centred.t_in, -0x1p-200);
  EXPECT_EQ(centred.out.high, 2);
  problem.b.displacement = Vec(1, 1, 0);  // (e + t - 1)^2 + t^2 = 1, so t_in = -e nearly, and a bit above
  const ContactInterval slanted = LinearTruth(problem).contact_interval().value();
  EXPECT_EQ(slanted.in.low, -0x1p-200);
  EXPECT_EQ(slanted.in.high, std::nextafter(-0x1p-200, 0));
  EXPECT_EQ(slanted.out.low, std::nextafter(1.0, 0));
}

TEST(ContactInterval, WithoutMotionIsEverythingOrNothing) {
  corpus::Case problem = ball_through_ball(3);
  problem.b.displacement.setZero();
  const ContactInterval all = LinearTruth(problem).contact_interval().value();
  EXPECT_EQ(all.t_in, -kInf);
  EXPECT_EQ(all.out.low, kInf);
  problem.b.position[1] = 4;
  EXPECT_FALSE(LinearTruth(problem).contact_interval().has_value());
}

TEST(ContactInterval, OfPolytopesIsTheLinearProgramsAndThatOfCombinatorsToo) {
  SmallPairs pairs(41);
  int met = 0, missed = 0, behind = 0;
  for (int i = 0; i < 500; ++i) {
    const corpus::Case problem = i % 2 == 0 ? pairs.pair() : pairs.composed_pair();
    if (problem.a.displacement == problem.b.displacement) continue;
    const auto expected = contact_times_by_linear_program(problem);
    const auto found = LinearTruth(problem).contact_interval();
    ASSERT_EQ(expected.has_value(), found.has_value()) << "case " << i;
    ++(expected ? met : missed);
    if (!expected) continue;
    ASSERT_EQ(expected->first.get_str(), found->in_exact) << "case " << i;
    ASSERT_EQ(expected->second.get_str(), found->out_exact) << "case " << i;
    ASSERT_EQ(nearest_double(expected->first), found->t_in);
    ASSERT_EQ(floor_double(expected->second), found->out.low);
    behind += sgn(expected->second) < 0;
  }
  EXPECT_GE(met, 150);
  EXPECT_GE(missed, 50);
  EXPECT_GE(behind, 5);
}

// Both ends of rounded pairs, checked by the quadratic program alone: at the doubles around an end the
// squared distance is on either side of the squared radius.
TEST(ContactInterval, OfRoundedPolytopesIsWhereTheQuadraticProgramSaysSo) {
  SmallPairs pairs(43);
  int met = 0, irrational = 0;
  for (int i = 0; i < 150; ++i) {
    corpus::Case problem = pairs.composed_pair();
    problem.a.shape = rounded<double>(problem.a.shape, 0.375);
    problem.target_distance = i % 3 == 0 ? 0.25 : 0;
    if (problem.a.displacement == problem.b.displacement) continue;
    const auto interval = LinearTruth(problem).contact_interval();
    if (!interval) continue;
    ++met;
    irrational += interval->in_exact.empty();
    const Rational reach = Rational(0.375) + Rational(problem.target_distance);
    const auto outside = [&](double t) {
      return cmp(distance_sq_by_quadratic_program(problem, Rational(t)), Rational(reach * reach));
    };
    ASSERT_GE(outside(interval->in.low), 0) << "case " << i;
    ASSERT_LE(outside(interval->in.high), 0) << "case " << i;
    ASSERT_LE(outside(interval->out.low), 0) << "case " << i;
    ASSERT_GE(outside(interval->out.high), 0) << "case " << i;
    ASSERT_GT(outside(std::nextafter(interval->in.low, -kInf)), 0) << "case " << i;
    ASSERT_GT(outside(std::nextafter(interval->out.high, kInf)), 0) << "case " << i;
  }
  EXPECT_GE(met, 60);
  EXPECT_GE(irrational, 30);
}

TEST(PlantedError, AnEndOfTheIntervalOffByALittleIsTold) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.position = Vec(4, 0.5, 0);
  problem.b.displacement = Vec(-3, 0, 0);  // in C for t in [1, 5/3], with 0.5 to leave sideways
  const LinearTruth truth(problem);
  EXPECT_EQ(truth.entry_error(1).high, 0);
  EXPECT_EQ(truth.entry_error(std::nextafter(1.0, 0)).low, 3 * 0x1p-53);
  EXPECT_EQ(truth.entry_error(std::nextafter(1.0, 2)).low, 3 * 0x1p-52);
  EXPECT_GT(truth.entry_error(1 + 1e-15).low, 2.9e-15);
  const ContactInterval interval = truth.contact_interval().value();
  EXPECT_GT(truth.exit_error(interval.out.low).low, 0);
  EXPECT_LT(truth.exit_error(interval.out.low).high, 1e-15);
  EXPECT_GT(truth.exit_error(interval.t_out + 1e-15).low, 2e-15);
  EXPECT_EQ(truth.entry_error(5).low, 10.0) << "far behind";
  EXPECT_EQ(truth.entry_error(1.5).low, 0.5) << "no deeper than the whole line";
  EXPECT_EQ(truth.entry_error(kInf).low, 0.5) << "a claim that the line misses";
  EXPECT_EQ(truth.exit_error(-kInf).low, 0.5);
  EXPECT_EQ(truth.entry_error(-kInf).low, kInf) << "a claim of contact for ever";
  EXPECT_EQ(truth.exit_error(NAN).low, kInf);
  EXPECT_EQ(truth.line_depth().low, 0.5);
  EXPECT_EQ(truth.line_clearance().high, 0);
  problem.b.position[1] = 3;
  const LinearTruth passing(problem);
  EXPECT_EQ(passing.line_clearance().low, 2);
  EXPECT_EQ(passing.line_depth().high, 0);
  EXPECT_EQ(passing.entry_error(1).low, 2);
  EXPECT_EQ(passing.entry_error(kInf).high, 0);
}

TEST(PlantedError, AnIntervalOfBodiesAtRestHasInfiniteEnds) {
  corpus::Case problem = ball_through_ball(1);
  problem.b.displacement.setZero();
  const LinearTruth touching(problem);
  EXPECT_EQ(touching.entry_error(-kInf).high, 0);
  EXPECT_EQ(touching.exit_error(kInf).high, 0);
  EXPECT_EQ(touching.entry_error(kInf).low, 2) << "claims a miss";
  problem.b.position[1] = 5;
  EXPECT_EQ(LinearTruth(problem).entry_error(-kInf).low, 2);
}

// The origin is interior to the hull of C and -v exactly when a step along each of six directions stays
// inside: six linear programs.
TEST(LeavesOrSlides, AsLinearProgramsSay) {
  SmallPairs pairs(47);
  int leaving = 0, entering = 0;
  for (int i = 0; i < 600; ++i) {
    corpus::Case problem = i % 2 == 0 ? pairs.pair() : pairs.composed_pair();
    problem.a.orientation = problem.b.orientation = {};  // so that C's points are doubles
    const ExactBody a = exact_body(problem.a), b = exact_body(problem.b);
    std::vector<Vec> points = {problem.a.displacement - problem.b.displacement};  // -v
    bool doubles = true;
    for (const RationalPoint& p : a.vertices) {
      for (const RationalPoint& q : b.vertices) {
        Vec& c = points.emplace_back();
        for (int k = 0; k < 3; ++k) {
          const Rational x = p[k] - q[k];
          c[k] = x.get_d();
          doubles = doubles && Rational(c[k]) == x;
        }
      }
    }
    if (!doubles) continue;
    corpus::Case probe;
    probe.a.shape = Hull<double>(points);
    bool interior = true;
    for (int k = 0; k < 6 && interior; ++k) {
      probe.b.displacement.setZero();
      probe.b.displacement[k / 2] = k % 2 == 0 ? 1 : -1;
      const auto times = contact_times_by_linear_program(probe);
      interior = times && sgn(times->first) <= 0 && sgn(times->second) > 0;
    }
    const LinearTruth truth(problem);
    ASSERT_EQ(truth.leaves_or_slides(), !interior) << "case " << i;
    if (truth.outcome() != Outcome::initially_overlapping) continue;
    ++(interior ? entering : leaving);
    problem.start_policy = corpus::StartPolicy::pass_over;
    ASSERT_EQ(LinearTruth(problem).outcome(), interior ? Outcome::initially_overlapping : Outcome::miss);
  }
  EXPECT_GE(leaving, 20);
  EXPECT_GE(entering, 20);
}

// A start that is in contact by the target distance alone is judged by the shapes: C unrounded by m.
TEST(LeavesOrSlides, TheTargetDistanceIsNotCounted) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Sphere<double>{1};
  problem.b.position = Vec(2.5, 0, 0);
  problem.target_distance = 1;
  problem.start_policy = corpus::StartPolicy::pass_over;
  const auto outcome_of = [&](const Vec& v) {
    problem.b.displacement = v;
    return LinearTruth(problem).outcome();
  };
  EXPECT_EQ(outcome_of(Vec(1, 0, 0)), Outcome::miss);
  EXPECT_EQ(outcome_of(Vec(0, 1, 0)), Outcome::miss);
  EXPECT_EQ(outcome_of(Vec(0, 0, 0)), Outcome::miss);
  EXPECT_EQ(outcome_of(Vec(-1, 0, 0)), Outcome::initially_overlapping);
  // Past the rounded corner: n may lean towards the path as long as C stays behind it.
  EXPECT_EQ(outcome_of(Vec(-1, 10, 0)), Outcome::miss);
  problem.b.position = Vec(2.25, 2.25, 0);
  EXPECT_EQ(outcome_of(Vec(-1, 1, 0)), Outcome::miss);
  EXPECT_EQ(outcome_of(Vec(-1, -1, 0)), Outcome::initially_overlapping);
}

}  // namespace
}  // namespace graze::oracle
