// The rotating families: each level as hard as it says. Poses at a time and distances there are computed in
// doubles, by the library's sine and by core's GJK: they measure what was drawn, and judge no answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <graze/distance.hpp>
#include <map>
#include <set>

#include "corpus/families.hpp"
#include "corpus/families/turning.hpp"
#include "oracles/truth/rotating_truth.hpp"

namespace graze::corpus {
namespace {

constexpr std::uint64_t kSeeds = 16;

Body<double> placed_at(const Body<double>& body, const Spin& spin, double t) {
  const double angle = t * spin.rotation.norm();
  Body<double> out = body;
  out.displacement.setZero();
  Quaternion<double> turn;
  if (angle > 0) {
    const Vec3<double> axis = spin.rotation.normalized() * std::sin(angle / 2);
    turn = {std::cos(angle / 2), axis[0], axis[1], axis[2]};
  }
  const Vec3<double> pivot = rotate(body.orientation, spin.pivot);
  out.orientation = multiply(turn, body.orientation);
  out.position = body.position + t * body.displacement + pivot - rotate(turn, pivot);
  return out;
}

double gap_at(const Case& problem, double t) {
  const DistanceOptions<double> options{.request = Request::verdict};
  return distance(placed_at(problem.a, problem.spin_a, t), placed_at(problem.b, problem.spin_b, t), options)
      .upper;
}

bool turns(const Spin& spin) { return !spin.rotation.isZero(0); }

// An upper bound on how fast the gap may close.
double closing_speed(const Case& problem) {
  const auto fastest = [](const Body<double>& body, const Spin& spin) {
    return spin.rotation.norm() * (bounding_radius(body.shape) + spin.pivot.norm());
  };
  return (problem.b.displacement - problem.a.displacement).norm() + fastest(problem.a, problem.spin_a) +
         fastest(problem.b, problem.spin_b);
}

// Steps that no contact fits into, until the bodies are within 1e-6 or the budget ends: enough to tell what
// is drawn.
Outcome rough_outcome(const Case& problem) {
  constexpr double kNear = 1e-6;
  const double speed = closing_speed(problem);
  double t = 0;
  for (int step = 0; step < 4000; ++step) {
    const double gap = gap_at(problem, t);
    if (gap <= kNear) return t == 0 ? Outcome::initially_overlapping : Outcome::hit;
    if (t >= problem.t_max || speed == 0) return Outcome::miss;
    t = std::min(problem.t_max, t + gap / speed);
  }
  return Outcome::not_converged;
}

template <class F>
void for_each_case(const Family& family, F f) {
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) f(level, family.generate(level, seed));
  }
}

void add_kinds(const Shape<double>& shape, std::set<std::size_t>& kinds) {
  kinds.insert(shape.index());
  std::visit(
      [&](const auto& one) {
        if constexpr (requires { one.shapes; }) {
          for (const auto& part : one.shapes) add_kinds(part->shape, kinds);
        } else if constexpr (requires { one.shape; }) {
          add_kinds(one.shape->shape, kinds);
        }
      },
      shape);
}

TEST(RotatingFamilies, AreApartFromTheLinearOnes) {
  EXPECT_EQ(rotating_families().size(), 16u);
  for (const Family& family : rotating_families()) {
    EXPECT_TRUE(family.rotating) << family.name;
    EXPECT_EQ(find_family(family.name), &family);
  }
  for (const Family& family : families()) {
    EXPECT_FALSE(family.rotating) << family.name;
    for (const double level : family.levels) {
      const Case problem = family.generate(level, 1);
      EXPECT_FALSE(turns(problem.spin_a) || turns(problem.spin_b)) << problem.id;
    }
  }
}

TEST(RotatingFamilies, DrawEveryShapeBothBodiesAndFiniteSteps) {
  std::set<std::size_t> kinds;
  for (const Family& family : rotating_families()) {
    std::size_t total = 0, a = 0, b = 0, both = 0, off_centre = 0, other_steps = 0;
    for_each_case(family, [&](double, const Case& problem) {
      ++total;
      add_kinds(problem.a.shape, kinds);
      add_kinds(problem.b.shape, kinds);
      a += turns(problem.spin_a);
      b += turns(problem.spin_b);
      both += turns(problem.spin_a) && turns(problem.spin_b);
      off_centre += !problem.spin_a.pivot.isZero(0) || !problem.spin_b.pivot.isZero(0);
      other_steps += problem.t_max != 1;
      EXPECT_TRUE(std::isfinite(problem.t_max) && problem.t_max > 0) << problem.id;
    });
    EXPECT_GE(a, total / 4) << family.name;
    EXPECT_GE(b, total / 4) << family.name;
    EXPECT_GE(both, total / 8) << family.name;
    EXPECT_GE(a + b - both, total * 7 / 8) << family.name;
    EXPECT_GE(off_centre, total / 5) << family.name;
    EXPECT_GE(other_steps, total / 8) << family.name;
  }
  EXPECT_EQ(kinds.size(), 14u);
}

// At the easier levels, where a rough count tells: grazes by 1e-6 are for the oracle, and so is what moves
// far and comes no nearer (far_families_test.cpp). Bodies that rest or roll are in contact at the start by design.
TEST(RotatingFamilies, MixOutcomes) {
  const std::set<std::string_view> far = {"far_own_frame_turning", "long_arms", "swung_balls",
                                          "resting_turns", "wheels"};
  for (const Family& family : rotating_families()) {
    if (far.contains(family.name)) continue;
    std::map<Outcome, std::size_t> outcomes;
    std::size_t total = 0;
    for (const double level : family.levels) {
      if (level > 12) break;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed, ++total) {
        ++outcomes[rough_outcome(family.generate(level, seed))];
      }
    }
    EXPECT_GE(outcomes[Outcome::hit], total / 5) << family.name;
    EXPECT_GE(outcomes[Outcome::miss], total / 12) << family.name;
    EXPECT_LE(outcomes[Outcome::initially_overlapping], total / 3) << family.name;
    EXPECT_LE(outcomes[Outcome::not_converged], total / 3) << family.name;
  }
}

TEST(RotatingFamilies, AnglesAreThoseOfTheMathematicalLibrary) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const int most = i < 1000 ? 3 : 1 << random.integer(0, 30);
    const Quaternion<double> q{
        static_cast<double>(random.integer(-most, most)), static_cast<double>(random.integer(-3, 3)),
        static_cast<double>(random.integer(-3, 3)), static_cast<double>(random.integer(-3, 3))};
    if (q.is_identity()) continue;
    const double side = std::sqrt((q.x * q.x + q.y * q.y) + q.z * q.z);
    const double angle = 2 * std::atan2(side, q.w);
    // Sixteen roundings and three halvings, each below u relative. Near 2 pi there is a difference of two of
    // 3.14.
    EXPECT_NEAR(angle_of(q), angle, 32 * kUnitRoundoff<double> * angle) << q.w << ' ' << q.x;
    EXPECT_NEAR(rotation_vector(q, 2).norm(), angle + 4 * kPi, 1e-13);
  }
}

TEST(RotatingFamilies, ABodyStandsWhereItWasDrawnToMeet) {
  Draw draw(7);
  draw.coordinates = Coordinates::doubles;
  for (int i = 0; i < 200; ++i) {
    Case problem;  // two points: their box is the origin
    problem.a.orientation = draw.pose();
    problem.b.orientation = draw.pose();
    problem.a.position = draw.vector(8);
    problem.spin_a.pivot = draw.vector(8);
    problem.spin_b.pivot = draw.vector(8);
    set_motion(draw, problem, draw.vector(16));
    Meeting meeting;
    meeting.t = meeting_time(draw);
    meeting.turn_a = draw.pose();
    meeting.turn_b = some_turn(draw);
    meeting.turns_b = draw.random.integer(0, 3);
    meet(draw, problem, meeting, 0);
    EXPECT_NEAR(gap_at(problem, meeting.t), 0, 1e-12);
  }
}

TEST(SpinningGraze, IsClearOrDeepByExactlyItsHardness) {
  const Family& family = *find_family("spinning_graze");
  for (const double level : {4.0, 12.0, 20.0}) {
    const double wanted = std::exp2(-level);
    std::size_t misses = 0, hits = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      const oracle::RotatingTruth truth(problem);
      if (truth.outcome() == Outcome::miss) {
        ++misses;
        // The clearance is enclosed to 1/16. The scene is rotated and rounded, with coordinates up to 64.
        const oracle::Enclosure clearance = truth.clearance();
        EXPECT_LE(clearance.low, wanted + 0x1p-44) << problem.id;
        EXPECT_GE(clearance.high, wanted - 0x1p-44) << problem.id;
      } else if (truth.outcome() == Outcome::hit) {
        ++hits;
        EXPECT_LE(truth.depth().low, wanted + 0x1p-44) << problem.id;
      }
    }
    EXPECT_GE(misses, kSeeds / 4) << level;
    EXPECT_GE(hits, kSeeds / 8) << level;
  }
}

TEST(SpinningGraze, IsOnTheSideThatWasDrawn) {
  const Family& family = *find_family("spinning_graze");
  std::size_t misses = 0, others = 0;
  for_each_case(family, [&](double, const Case& problem) {
    // The first that the family draws.
    const bool above = Draw(fnv1a(problem.id)).random.once_in(2);
    const Outcome outcome = oracle::RotatingTruth(problem, oracle::RotatingTruth::kLeastWidth).outcome();
    EXPECT_EQ(outcome == Outcome::miss, above) << problem.id;
    EXPECT_NE(outcome, Outcome::not_converged) << problem.id;
    misses += outcome == Outcome::miss;
    others += outcome != Outcome::miss;
  });
  EXPECT_GE(misses, 40u);
  EXPECT_GE(others, 40u);
}

TEST(FastSpin, TurnsAsFastAsTheHardnessSays) {
  for_each_case(*find_family("fast_spin"), [](double level, const Case& problem) {
    // vary_horizon leaves t_max of 1/2, 1 or 2 units of time. One rotation more may take a quarter of a unit.
    const double most =
        std::max(problem.spin_a.rotation.norm(), problem.spin_b.rotation.norm()) * problem.t_max;
    EXPECT_LE(most, 2 * (std::exp2(level) + 8 * kPi)) << problem.id;
    EXPECT_GE(most, std::exp2(level) / 8) << problem.id;
  });
}

TEST(OffCentrePivot, IsAsFarAsTheHardnessSays) {
  for_each_case(*find_family("off_centre_pivot"), [](double level, const Case& problem) {
    const double arm = std::max(problem.spin_a.pivot.norm(), problem.spin_b.pivot.norm());
    // Integers round it. The other body's pivot is within 4 along each axis.
    EXPECT_GE(arm, 4 * std::exp2(level) - 1) << problem.id;
    EXPECT_LE(arm, std::max(4 * std::exp2(level) + 1, 4 * std::sqrt(3.0))) << problem.id;
  });
}

TEST(EntersAndLeaves, IsApartAtBothEndsAndInContactForNoLongerThanItSays) {
  const Family& family = *find_family("enters_and_leaves");
  for (const double level : {4.0, 6.0, 8.0}) {
    std::size_t passes = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      if (gap_at(problem, 0) <= 0 || gap_at(problem, problem.t_max) <= 0) continue;
      // Several features of a body may pass. Each passes for 1.9 times the fraction at most, or for the
      // sizes' 8 of 16 * 2^k.
      const int samples = 16 << static_cast<int>(level);
      int inside = 0;
      for (int i = 0; i <= samples; ++i) inside += gap_at(problem, problem.t_max * i / samples) <= 0;
      passes += inside > 0;
      EXPECT_LE(inside, 16 * 8 + 4) << problem.id;
    }
    EXPECT_GE(passes, kSeeds / 2) << level;
  }
}

TEST(BothTurn, DiffersByNoMoreThanTheHardnessSays) {
  for_each_case(*find_family("both_turn"), [](double level, const Case& problem) {
    const Vec3<double> difference = problem.spin_b.rotation - problem.spin_a.rotation;
    const double most = difference.cwiseAbs().maxCoeff() * problem.t_max;
    // Rotated by a cube rotation or not at all. t_max is up to two units of time.
    EXPECT_LE(most, 2 * std::exp2(-level) * (1 + 1e-9) + 1e-12) << problem.id;
    EXPECT_GT(most, 0) << problem.id;
    EXPECT_GE(problem.spin_a.rotation.norm() * problem.t_max, 0.2) << problem.id;
  });
}

TEST(SlowSpin, TurnsAsLittleAsTheHardnessSays) {
  for_each_case(*find_family("slow_spin"), [](double level, const Case& problem) {
    const double most =
        std::max(problem.spin_a.rotation.norm(), problem.spin_b.rotation.norm()) * problem.t_max;
    EXPECT_NEAR(most, std::exp2(-level), std::exp2(-level) * 1e-6) << problem.id;
  });
}

}  // namespace
}  // namespace graze::corpus
