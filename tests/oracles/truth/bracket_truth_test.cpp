// The bracket oracle against closed forms, against the exact oracle, and against itself on other names of one
// shape. It must tell wrong answers from right ones.
#include "oracles/truth/bracket_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracles/truth/closed_form.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/curved_pairs.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

constexpr double kInf = kInfinity<double>;
const double kHalfRoot = std::sqrt(0.5);

// Two ellipsoids, turned, of which no closed form is known here.
corpus::Case two_ellipsoids() {
  corpus::Case problem;
  problem.a.shape = Ellipsoid<double>{Vec(1, 0.5, 2)};
  problem.a.orientation = {0.9, 0.2, -0.3, 0.1};
  problem.b.shape = Ellipsoid<double>{Vec(0.7, 1.1, 0.4)};
  problem.b.orientation = {0.3, 0.8, 0.1, -0.5};
  problem.b.position = Vec(4, 0.3, -0.2);
  problem.b.displacement = Vec(-5, 0.1, 0.2);
  return problem;
}

struct Tally {
  std::array<int, 5> of = {};
  void count(Outcome outcome) { ++of[static_cast<std::size_t>(outcome)]; }
  [[nodiscard]] int operator[](Outcome outcome) const { return of[static_cast<std::size_t>(outcome)]; }
};

// Silence is allowed only where neither clearance nor depth exceeds the width, or where contact is proved and
// only its presence at the start is open, within the width.
void expect_silence_is_due(const BracketTruth& bracket, double width) {
  const double limit = width * bracket.scale().high;
  if (bracket.contact_proved()) {
    EXPECT_EQ(bracket.toi_lower(), 0);
    EXPECT_LE(bracket.width(), limit);
    return;
  }
  EXPECT_LE(bracket.depth().low, limit);
  EXPECT_LE(bracket.clearance().low, limit);
}

// `compare`: sign(t - TOI) for a rational t, by another judge.
template <class Compare>
void expect_agreement(const BracketTruth& bracket, double width, Outcome outcome, const Compare& compare) {
  if (bracket.outcome() == Outcome::not_converged) {
    expect_silence_is_due(bracket, width);
    EXPECT_TRUE(!bracket.contact_proved() || outcome != Outcome::miss);
  } else {
    ASSERT_EQ(bracket.outcome(), outcome);
  }
  if (!bracket.contact_proved()) return;
  const RationalBracket toi = bracket.toi_bracket();
  EXPECT_LE(compare(toi.low), 0);
  EXPECT_GE(compare(toi.high), 0);
  EXPECT_LE(bracket.width(), width * bracket.scale().high);
}

struct Kinds {
  Kind a, b;
  bool target;  // a target distance has a closed form
};

TEST(BracketTruth, HoldsEveryClosedForm) {
  constexpr double kWidth = 1e-20;
  const std::array<Kinds, 12> kinds = {{{Kind::sphere, Kind::sphere, true},
                                        {Kind::sphere, Kind::capsule, true},
                                        {Kind::capsule, Kind::capsule, true},
                                        {Kind::segment, Kind::capsule, true},
                                        {Kind::segment, Kind::segment, true},
                                        {Kind::sphere, Kind::box, true},
                                        {Kind::box, Kind::point, true},
                                        {Kind::point, Kind::ellipsoid, false},
                                        {Kind::ellipsoid, Kind::point, false},
                                        {Kind::point, Kind::cylinder, false},
                                        {Kind::cylinder, Kind::point, false},
                                        {Kind::cone, Kind::point, false}}};
  constexpr int kPairs = 500;
  CurvedPairs pairs(0xc105ed);
  for (const Kinds& kind : kinds) {
    Tally tally;
    for (int round = 0; round < kPairs; ++round) {
      corpus::Case problem = pairs.pair(kind.a, kind.b);
      if (kind.target && pairs.random.once_in(4)) problem.target_distance = pairs.extent();
      const auto form = ClosedForm::of(problem);
      ASSERT_TRUE(form);
      const BracketTruth bracket(problem, kWidth);
      expect_agreement(bracket, kWidth, form->outcome(), [&](const Rational& t) { return form->compare(t); });
      tally.count(bracket.outcome());
      if (HasFailure()) {
        FAIL() << "kinds " << static_cast<int>(kind.a) << ", " << static_cast<int>(kind.b) << ", round "
               << round;
      }
    }
    EXPECT_GT(tally[Outcome::hit], kPairs / 50);
    EXPECT_GT(tally[Outcome::miss], kPairs / 50);
    EXPECT_LT(tally[Outcome::not_converged], kPairs / 3);
    RecordProperty("undecided_" + std::to_string(static_cast<int>(kind.a)) + "_" +
                       std::to_string(static_cast<int>(kind.b)),
                   tally[Outcome::not_converged]);
  }
}

// sign(t - TOI) by the exact oracle, or 0 where only a double could decide.
int order(const LinearTruth& exact, const Rational& t) {
  if (exact.outcome() == Outcome::miss) return -1;
  if (!exact.toi_exact().empty()) return cmp(t, Rational(exact.toi_exact()));
  if (exact.compare(floor_double(t)) > 0) return 1;
  return exact.compare(ceil_double(t)) < 0 ? -1 : 0;
}

// Every length that both give must overlap.
void expect_overlap(const Enclosure& bracket, const Enclosure& exact, const char* what) {
  EXPECT_LE(bracket.low, exact.high) << what;
  EXPECT_GE(bracket.high, exact.low) << what;
}

TEST(BracketTruth, HoldsTheExactAnswersOfPolytopesAndSpheres) {
  constexpr double kWidth = 1e-20;
  SmallPairs pairs(0xace);
  Tally tally;
  int lines = 0;
  for (int round = 0; round < 600; ++round) {
    corpus::Case problem = pairs.pair();
    if (pairs.random.once_in(4)) problem.b.shape = Sphere<double>{pairs.random.uniform(0, 2)};
    if (pairs.random.once_in(4)) problem.target_distance = pairs.random.uniform(0, 1);
    const LinearTruth exact(problem);
    const BracketTruth bracket(problem, kWidth);
    expect_agreement(bracket, kWidth, exact.outcome(), [&](const Rational& t) { return order(exact, t); });
    tally.count(bracket.outcome());
    EXPECT_LE(bracket.toi_lower(), exact.toi_lower());
    EXPECT_GE(bracket.toi_upper(), exact.toi_upper());
    expect_overlap(bracket.scale(), exact.scale(), "scale");
    expect_overlap(bracket.distance(), exact.distance(), "distance");
    if (bracket.outcome() == Outcome::miss)
      expect_overlap(bracket.clearance(), exact.clearance(), "clearance");
    if (bracket.contact_proved()) {
      expect_overlap(bracket.depth(), exact.depth(), "depth");
      EXPECT_LE(bracket.depth().high,
                (1 + BracketTruth::kDepthSlack) * bracket.depth().low + kWidth * bracket.scale().high);
      const Vec n = pairs.vector(3);
      if (!n.isZero(0)) expect_overlap(bracket.normal_error(n), exact.normal_error(n), "normal");
    }
    const double t = pairs.random.uniform(0, 1.5);
    expect_overlap(bracket.distance_at(t), exact.distance_at(t), "distance_at");
    expect_overlap(bracket.depth_before(t), exact.depth_before(t), "depth_before");
    expect_overlap(bracket.backward_error(t), exact.backward_error(t), "backward_error");
    if (bracket.outcome() != Outcome::not_converged) {
      expect_overlap(bracket.forward_error(t), exact.forward_error(t), "forward_error");
      expect_overlap(bracket.lateness(t), exact.lateness(t), "lateness");
    }
    if (exact.is_polytope()) {
      const LineContact line = bracket.contact_interval();
      const auto interval = exact.contact_interval();
      if (line.outcome == Outcome::miss) {
        EXPECT_FALSE(interval);
      } else if (line.outcome == Outcome::hit) {
        ++lines;
        ASSERT_TRUE(interval);
        expect_overlap(line.t_in, {interval->t_in, interval->t_in}, "t_in");
        expect_overlap(line.t_out, {interval->t_out, interval->t_out}, "t_out");
      }
    }
    const Vec p = pairs.vector(4);
    for (const char body : {'a', 'b'}) {
      expect_overlap(bracket.distance_from_body(body, t, p), exact.distance_from_body(body, t, p), "witness");
    }
    if (HasFailure()) FAIL() << "round " << round;
  }
  for (const Outcome o : {Outcome::initially_overlapping, Outcome::hit, Outcome::miss})
    EXPECT_GT(tally[o], 30);
}

// The path passes two unit balls at a height of 2. The target distance 10^-k is the depth.
TEST(BracketTruth, GrazesAreDecidedDownToTheWidth) {
  constexpr double kWidth = 1e-20;
  corpus::Case problem;
  problem.a.shape = problem.b.shape = Sphere<double>{1};
  problem.b.position = Vec(3, 2, 0);
  problem.b.displacement = Vec(-7, 0, 0);
  for (int k = 0; k <= 18; ++k) {
    problem.target_distance = std::pow(10.0, -k);
    const auto form = ClosedForm::of(problem);
    const BracketTruth bracket(problem, kWidth);
    ASSERT_EQ(bracket.outcome(), Outcome::hit) << k;
    expect_agreement(bracket, kWidth, form->outcome(), [&](const Rational& t) { return form->compare(t); });
    expect_overlap(bracket.depth(), {problem.target_distance, problem.target_distance}, "depth");
    EXPECT_EQ(bracket.toi_upper(), form->toi_upper());
    EXPECT_EQ(bracket.toi_lower(), form->toi_lower());
  }
  problem.target_distance = 0;
  EXPECT_EQ(BracketTruth(problem, kWidth).outcome(), Outcome::not_converged);
  problem.b.position[1] = std::nextafter(2, 3);
  EXPECT_EQ(BracketTruth(problem, kWidth).outcome(), Outcome::miss);
}

// Lengths of 1e-60 and 1e60, and unit shapes drawn 1e9 away from their own origins.
TEST(BracketTruth, DecidesAtEveryMagnitudeAndFarFromTheOrigin) {
  for (const double size : {1e-60, 1.0, 1e60}) {
    corpus::Case problem = two_ellipsoids();
    for (Body<double>* body : {&problem.a, &problem.b}) {
      Vec& radii = std::get<Ellipsoid<double>>(body->shape).radii;
      radii *= size;
      body->position *= size;
      body->displacement *= size;
    }
    const BracketTruth truth(problem);
    ASSERT_EQ(truth.outcome(), Outcome::hit);
    EXPECT_LE(truth.width(), BracketTruth::kDefaultWidth * truth.scale().high);
    EXPECT_NEAR(truth.toi_lower(), BracketTruth(two_ellipsoids()).toi_lower(), 1e-14);
  }
  corpus::Case far = two_ellipsoids();
  const Vec offset(1e9, -3e9, 2e9);
  far.a.shape = translated<double>(far.a.shape, offset);
  far.a.orientation = {1, 0, 0, 0};
  far.a.position = -offset;
  corpus::Case near = two_ellipsoids();
  near.a.orientation = {1, 0, 0, 0};
  EXPECT_EQ(BracketTruth(far).toi_lower(), BracketTruth(near).toi_lower());
}

TEST(BracketTruth, DecidesEveryPairOfKindsToAThirtiethDecimal) {
  constexpr double kWidth = 1e-30;
  CurvedPairs pairs(0xa11);
  Tally tally;
  for (int a = 0; a < kKinds; ++a) {
    for (int b = 0; b < kKinds; ++b) {
      const corpus::Case problem = pairs.pair(static_cast<Kind>(a), static_cast<Kind>(b));
      const BracketTruth bracket(problem, kWidth);
      tally.count(bracket.outcome());
      if (bracket.outcome() == Outcome::not_converged) expect_silence_is_due(bracket, kWidth);
      if (bracket.outcome() != Outcome::hit) continue;
      EXPECT_LE(bracket.width(), kWidth * bracket.scale().high);
      const RationalBracket toi = bracket.toi_bracket();
      EXPECT_LE(toi.low, toi.high);
    }
  }
  EXPECT_GT(tally[Outcome::hit], 30);
}

// One set under two names must have one answer.
TEST(BracketTruth, CombinatorsAreTheShapesTheyMake) {
  const auto disk = [](double radius, double z) {
    return translated<double>(Cylinder<double>{radius, 0}, Vec(0, 0, z));
  };
  const std::vector<std::array<Shape<double>, 2>> twins = {
      {Capsule<double>{0.5, 1}, rounded<double>(Segment<double>{Vec(0, 0, -1), Vec(0, 0, 1)}, 0.5)},
      {Capsule<double>{0.5, 1}, hull_of<double>(translated<double>(Sphere<double>{0.5}, Vec(0, 0, 1)),
                                                translated<double>(Sphere<double>{0.5}, Vec(0, 0, -1)))},
      {Cylinder<double>{0.75, 1}, swept<double>(disk(0.75, -1), Vec(0, 0, 2))},
      {Cylinder<double>{0.75, 1}, hull_of<double>(disk(0.75, -1), disk(0.75, 1))},
      {Cone<double>{0.75, 1},
       hull_of<double>(disk(0.75, -1), translated<double>(Point<double>{}, Vec(0, 0, 1)))},
      {Ellipsoid<double>{Vec(1, 1, 1)}, Sphere<double>{1}},
      {Ellipsoid<double>{Vec(1, 1, 0)}, Cylinder<double>{1, 0}},
      {Box<double>{Vec(1, 2, 3)}, sum<double>(Box<double>{Vec(0.5, 1, 3)}, Box<double>{Vec(0.5, 1, 0)})},
      {Ellipsoid<double>{Vec(1, 2, 3)},  // a quarter turn about z
       posed<double>(Ellipsoid<double>{Vec(2, 1, 3)}, Vec::Zero(), Quaternion<double>{1, 0, 0, 1})}};
  CurvedPairs pairs(0x27);
  for (const auto& twin : twins) {
    int hits = 0;
    for (int round = 0; round < 12; ++round) {
      corpus::Case one = pairs.pair(Kind::point, static_cast<Kind>(pairs.random.integer(0, kKinds - 1)));
      one.a.shape = twin[0];
      corpus::Case other = one;
      other.a.shape = twin[1];
      const BracketTruth first(one), second(other);
      if (first.outcome() == Outcome::not_converged || second.outcome() == Outcome::not_converged) continue;
      ASSERT_EQ(first.outcome(), second.outcome());
      expect_overlap(first.distance(), second.distance(), "distance");
      if (first.outcome() != Outcome::hit) continue;
      ++hits;
      EXPECT_LE(first.toi_bracket().low, second.toi_bracket().high);
      EXPECT_LE(second.toi_bracket().low, first.toi_bracket().high);
      expect_overlap(first.depth(), second.depth(), "depth");
    }
    EXPECT_GT(hits, 0);
  }
}

TEST(BracketTruth, TellsAUnitInTheLastPlaceFromTheTruth) {
  const BracketTruth truth(two_ellipsoids());
  ASSERT_EQ(truth.outcome(), Outcome::hit);
  EXPECT_EQ(truth.toi_upper(), std::nextafter(truth.toi_lower(), 1));
  EXPECT_EQ(truth.compare(truth.toi_lower()), -1);
  EXPECT_EQ(truth.compare(truth.toi_upper()), 1);
  const double late = std::nextafter(truth.toi_upper(), 1), early = std::nextafter(truth.toi_lower(), 0);
  EXPECT_EQ(truth.compare(late), 1);
  EXPECT_EQ(truth.compare(early), -1);
  EXPECT_GT(truth.forward_error(late).low, truth.forward_error(truth.toi_upper()).high);
  EXPECT_GT(truth.lateness(late).low, 0);
  EXPECT_EQ(truth.lateness(truth.toi_lower()).high, 0);
  EXPECT_GT(truth.backward_error(early).low, 0);
  EXPECT_GT(truth.backward_error(early).low, truth.backward_error(truth.toi_lower()).high);
}

TEST(BracketTruth, MeasuresHowLateATimeIs) {
  const BracketTruth truth(two_ellipsoids());
  const double t = truth.toi_upper() + 1e-15;
  const Enclosure late = truth.lateness(t);
  EXPECT_GT(late.low, 1e-16);  // speed 5, a normal not far from the path
  EXPECT_LT(late.high, 6e-15);
  EXPECT_LE(late.high, (1 + BracketTruth::kDepthSlack) * late.low);
  EXPECT_EQ(truth.lateness(kInf).low, truth.depth().low) << "a miss claimed is late by the whole path";
  EXPECT_GT(truth.depth().low, 0.1);
}

// A ball of radius 1 passes the rim of a cylinder of radius 2: contact where the rim's circle is a unit away.
TEST(BracketTruth, TellsANormalFromItsNegativeAndAWitnessFromOneBesideTheShape) {
  corpus::Case problem;
  problem.a.shape = Cylinder<double>{2, 1};
  problem.b.shape = Sphere<double>{1};
  problem.b.position = Vec(4, 0, 1 + kHalfRoot);
  problem.b.displacement = Vec(-4, 0, 0);  // contact at x = 2 + sqrt(1 - (z - 1)^2), near 2.707
  const BracketTruth truth(problem);
  ASSERT_EQ(truth.outcome(), Outcome::hit);
  EXPECT_NEAR(truth.toi_lower(), (2 - kHalfRoot) / 4, 1e-15);
  const Vec normal(kHalfRoot, 0, kHalfRoot);
  EXPECT_LT(truth.normal_error(normal).high, 1e-15);
  EXPECT_GT(truth.normal_error(-normal).low, 1);
  EXPECT_GT(truth.normal_error(Vec(1, 0, 0)).low, 0.1);
  const Vec rim(2, 0, 1);
  EXPECT_EQ(truth.distance_from_body('a', 0, rim).low, 0);
  EXPECT_LT(truth.distance_from_body('b', truth.toi_lower(), rim).high, 1e-15);
  EXPECT_GT(truth.distance_from_body('a', 0, rim + Vec(1e-15, 0, 0)).low, 4e-16);
  EXPECT_GT(truth.distance_from_body('b', truth.toi_lower() - 1e-14, rim).low, 1e-15);
}

TEST(BracketTruth, FindsClosestPointsAndLeastPenetration) {
  corpus::Case problem;
  problem.a.shape = Cone<double>{1, 1};
  problem.b.shape = Ellipsoid<double>{Vec(1, 1, 0.5)};
  problem.b.position = Vec(0, 0, 2.5);
  const ClosestPoints apart = BracketTruth(problem).closest_points();
  EXPECT_LE(apart.distance.low, 1);
  EXPECT_GE(apart.distance.high, 1);
  EXPECT_LT(apart.distance.high - apart.distance.low, 1e-12);
  EXPECT_LT((apart.point_a - Vec(0, 0, 1)).norm(), 1e-6);
  EXPECT_LT((apart.point_b - Vec(0, 0, 2)).norm(), 1e-6);
  EXPECT_LT((apart.axis - Vec(0, 0, 1)).norm(), 1e-6);
  problem.a.shape = Cylinder<double>{3, 1};
  problem.b.position = Vec(0, 0, 1.25);
  const ClosestPoints inside = BracketTruth(problem).penetration(1e-9);
  EXPECT_LE(inside.distance.low, 0.25);
  EXPECT_GE(inside.distance.high, 0.25);
  EXPECT_LT(inside.distance.high - inside.distance.low, 1e-9);
  EXPECT_LT((inside.axis - Vec(0, 0, 1)).norm(), 1e-8);
}

// Shapes without depth are undecided, and the oracle reports so within its budget.
TEST(BracketTruth, IsSilentWhereShapesTouchOrAreFlat) {
  corpus::Case touching;
  touching.a.shape = Cylinder<double>{1, 1};
  touching.b.shape = Sphere<double>{1};
  touching.b.position = Vec(4, 0, 2);
  touching.b.displacement = Vec(-4, 0, 0);  // the ball slides over the cap
  const BracketTruth slides(touching);
  EXPECT_EQ(slides.outcome(), Outcome::not_converged);
  EXPECT_FALSE(slides.contact_proved());
  EXPECT_LE(slides.depth().high, 1e-19);

  corpus::Case flat;  // two disks in one plane, moving in it
  flat.a.shape = Ellipsoid<double>{Vec(1, 2, 0)};
  flat.b.shape = Cylinder<double>{1, 0};
  flat.b.position = Vec(4, 0, 0);
  flat.b.displacement = Vec(-4, 0, 0);
  EXPECT_EQ(BracketTruth(flat).outcome(), Outcome::not_converged);

  corpus::Case start;  // touching at the start, then deep inside
  start.a.shape = Ellipsoid<double>{Vec(1, 2, 1)};
  start.b.shape = Sphere<double>{1};
  start.b.position = Vec(2, 0, 0);
  start.b.displacement = Vec(-2, 0, 0);
  const BracketTruth touches(start);
  EXPECT_TRUE(touches.contact_proved());
  EXPECT_LE(touches.toi_upper(), 1e-19);

  corpus::Case nothing;  // two points in one place
  EXPECT_EQ(BracketTruth(nothing).outcome(), Outcome::not_converged);
}

TEST(BracketTruth, LeavingStartsArePassedOver) {
  corpus::Case problem;  // within the target distance, moving away
  problem.a.shape = Ellipsoid<double>{Vec(1, 1, 1)};
  problem.b.shape = Cone<double>{1, 1};
  problem.b.position = Vec(0, 0, 2.5);
  problem.b.displacement = Vec(0, 0, 1);
  problem.target_distance = 1;
  EXPECT_EQ(BracketTruth(problem).outcome(), Outcome::initially_overlapping);
  problem.start_policy = corpus::StartPolicy::pass_over;
  EXPECT_EQ(BracketTruth(problem).outcome(), Outcome::miss);
  problem.b.displacement = Vec(0, 0, -1);
  EXPECT_EQ(BracketTruth(problem).outcome(), Outcome::initially_overlapping);
}

TEST(BracketTruth, DepthUnderPassOverIsThatOfTheRay) {
  corpus::Case problem;  // the ball's pole reaches 1/8 into the cone's base
  problem.a.shape = Ellipsoid<double>{Vec(1, 1, 1)};
  problem.b.shape = Cone<double>{1, 1};
  problem.b.position = Vec(0, 0, 1.875);
  problem.target_distance = 1;
  const Enclosure near = BracketTruth(problem).depth();
  EXPECT_TRUE(near.low <= 1.125 && near.high >= 1.125);
  problem.start_policy = corpus::StartPolicy::pass_over;
  const Enclosure core = BracketTruth(problem).depth();
  EXPECT_TRUE(core.low <= 0.125 && core.high >= 0.125 && core.low > 0.1);
}

TEST(BracketTruth, DepthUnderPassOverCountsWhatMakesAStart) {
  corpus::Case problem;  // 1/64 beyond the target distance, then slides past, a third of it within
  problem.a.shape = Ellipsoid<double>{Vec(1, 1, 1)};
  problem.b.shape = Cone<double>{1, 1};
  problem.b.position = Vec(0, 0, 3 + 0x1p-6);
  problem.b.displacement = Vec(2, 0, -1);
  problem.target_distance = 1;
  EXPECT_EQ(BracketTruth(problem).outcome(), Outcome::hit);
  EXPECT_GT(BracketTruth(problem).depth().low, 0.25);
  problem.start_policy = corpus::StartPolicy::pass_over;
  const Enclosure found = BracketTruth(problem).depth();
  EXPECT_TRUE(found.low <= 0x1p-6 && found.high >= 0x1p-6 && found.low > 0x1p-7);
}

TEST(BracketTruth, ClearanceOfAPassedOverStartIsThatOfItsRay) {
  corpus::Case problem;
  problem.a.shape = Ellipsoid<double>{Vec(1, 1, 1)};
  problem.b.shape = Cone<double>{1, 1};
  problem.b.position = Vec(0, 0, 2.25);  // the ball's pole is 1/4 below the cone's base
  problem.b.displacement = Vec(0, 0, 1);
  problem.target_distance = 1;
  problem.start_policy = corpus::StartPolicy::pass_over;
  const auto expect = [&](double clearance) {
    const BracketTruth truth(problem);
    EXPECT_EQ(truth.outcome(), Outcome::miss);
    const Enclosure found = truth.clearance();
    EXPECT_TRUE(found.low <= clearance && found.high >= clearance) << found.low << " " << found.high;
    EXPECT_LE(found.high - found.low, clearance / 16);
  };
  expect(0.25);
  problem.b.position[2] = 2.875;  // the start is 1/8 in
  expect(0.125);
}

TEST(BracketTruth, RefusesBadInput) {
  corpus::Case problem = two_ellipsoids();
  problem.a.shape = Ellipsoid<double>{Vec(1, -1, 1)};
  EXPECT_THROW(BracketTruth{problem}, std::invalid_argument);
  problem.a.shape = Sum<double>{};
  EXPECT_THROW(BracketTruth{problem}, std::invalid_argument);
  problem.a.shape = HullOf<double>{{nullptr}};
  EXPECT_THROW(BracketTruth{problem}, std::invalid_argument);
  problem = two_ellipsoids();
  problem.spin_a.rotation = Vec(0, 0, 1);
  EXPECT_THROW(BracketTruth{problem}, std::invalid_argument);
  EXPECT_THROW(BracketTruth(two_ellipsoids(), 1e-99), std::invalid_argument);
}

}  // namespace
}  // namespace graze::oracle
