// Rotating proofs made by hand, whose truth can be read off the case, and refusals by name.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "oracles/checker/check_rotating_proof.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::check_rotating_proof;
using oracle::RotatingCheckCost;
using oracle::RotatingRefusal;
using oracle::RotatingVerdict;
using enum oracle::RotatingRefusal;

constexpr double kInf = kInfinity<double>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;
using V = Vec3<double>;

#define EXPECT_ACCEPTED(problem, proof)                                                         \
  do {                                                                                          \
    const RotatingVerdict verdict_ = check_rotating_proof(problem, proof);                      \
    EXPECT_TRUE(verdict_.accepted()) << to_string(verdict_.refusal) << ": " << verdict_.detail; \
  } while (false)
#define EXPECT_REFUSED(why, problem, proof)                                       \
  do {                                                                            \
    const RotatingVerdict verdict_ = check_rotating_proof(problem, proof);        \
    EXPECT_STREQ(to_string(verdict_.refusal), to_string(why)) << verdict_.detail; \
    EXPECT_FALSE(verdict_.detail.empty());                                        \
    EXPECT_EQ(verdict_.detail.find('\n'), std::string::npos);                     \
  } while (false)

RotatingProof lower(double toi, std::vector<TimeSlice> chain) {
  RotatingProof proof;
  proof.toi_lower = toi;
  proof.chain = std::move(chain);
  return proof;
}
RotatingProof miss(std::vector<TimeSlice> chain) { return lower(kInf, std::move(chain)); }

struct Pair {
  std::uint32_t a, b;
  double weight = 0;
};
RotatingProof upper(double toi, std::initializer_list<Pair> pairs) {
  RotatingProof proof;
  proof.toi_upper = toi;
  for (const Pair& pair : pairs) {
    const auto i = static_cast<std::size_t>(proof.contact_size++);
    proof.contact[i].a.vertex = pair.a;
    proof.contact[i].b.vertex = pair.b;
    proof.weight[i] = pair.weight;
  }
  return proof;
}

// The same with A and B exchanged.
Case swapped(Case problem) {
  std::swap(problem.a, problem.b);
  std::swap(problem.spin_a, problem.spin_b);
  return problem;
}
RotatingProof swapped(RotatingProof proof) {
  for (TimeSlice& slice : proof.chain) {
    slice.axis = -slice.axis;
    if (slice.frame != AxisFrame::world)
      slice.frame = slice.frame == AxisFrame::a ? AxisFrame::b : AxisFrame::a;
  }
  for (SupportPair& pair : proof.contact) std::swap(pair.a, pair.b);
  return proof;
}

// A cube of half width 1 a `height` above a plate with its upper face at z = 0. It rotates by a quarter about
// x. Its lowest edge is at height - (sin t + cos t).
Case box_over_plate(double height) {
  Case problem;
  problem.a.shape = Box<double>{V(100, 100, 1)};
  problem.a.position = V(0, 0, -1);
  problem.b.shape = Box<double>{V(1, 1, 1)};
  problem.b.position = V(0, 0, height);
  problem.spin_b.rotation = V(kPi / 2, 0, 0);
  return problem;
}

TEST(RotatingProof, BoxThatSpinsOverAPlate) {
  const TimeSlice up{1, V(0, 0, 2), AxisFrame::world};
  EXPECT_ACCEPTED(box_over_plate(1.5), miss({up}));
  EXPECT_ACCEPTED(box_over_plate(1.41421356238), miss({up}));  // sqrt(2) and 5e-12
  EXPECT_REFUSED(slice_false, box_over_plate(1.41421356236), miss({up}));
  EXPECT_REFUSED(slice_false, box_over_plate(1.5), miss({{1, V(0, 0, -2), AxisFrame::world}}));

  const double first = kPi / 4 - std::acos(1.4 / std::sqrt(2)), t = first / (kPi / 2);
  const Case hit = box_over_plate(1.4);
  EXPECT_ACCEPTED(hit, lower(t - 1e-9, {{t - 1e-9, up.axis, AxisFrame::world}}));
  EXPECT_REFUSED(slice_false, hit, lower(t + 1e-12, {{t + 1e-12, up.axis, AxisFrame::world}}));
  // Its corner (-1, -1, -1) in the tetrahedron of four corners of the plate.
  EXPECT_ACCEPTED(hit, upper(t + 1e-9, {{4, 0}, {5, 0}, {6, 0}, {0, 0}}));
  EXPECT_REFUSED(contact_not_proved, hit, upper(t - 1e-12, {{4, 0}, {5, 0}, {6, 0}, {0, 0}}));
  EXPECT_REFUSED(contact_not_proved, hit, upper(t + 1e-9, {{4, 1}, {5, 1}, {6, 1}, {0, 1}}));
  EXPECT_REFUSED(contact_not_proved, hit, upper(t + 1e-9, {{4, 0}, {5, 0}, {6, 0}, {4, 0}}));
  EXPECT_ACCEPTED(swapped(hit), swapped(upper(t + 1e-9, {{4, 0}, {5, 0}, {6, 0}, {0, 0}})));
}

// A rod of length 2 turns about its end from the x axis towards a ball of radius 0.5 at distance 1 and 90
// degrees: they meet at 60 degrees.
Case rod_and_ball() {
  Case problem;
  problem.a.shape = Segment<double>{V::Zero(), V(2, 0, 0)};
  problem.spin_a.rotation = V(0, 0, 2);
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = V(0, 1, 0);
  return problem;
}

TEST(RotatingProof, RodAboutItsEndInTheFrameOfEitherBody) {
  const double t = kPi / 3 / 2;
  const TimeSlice beside{t - 1e-10, V(0, 3, 0), AxisFrame::a};
  const Case rod = rod_and_ball();
  EXPECT_ACCEPTED(rod, lower(beside.end, {beside}));
  EXPECT_ACCEPTED(swapped(rod), swapped(lower(beside.end, {beside})));
  TimeSlice wrong = beside;
  for (const AxisFrame frame : {AxisFrame::world, AxisFrame::b}) {
    wrong.frame = frame;
    EXPECT_REFUSED(slice_false, rod, lower(wrong.end, {wrong}));
  }
  wrong = beside;
  wrong.end = t + 1e-12;
  EXPECT_REFUSED(slice_false, rod, lower(t, {wrong}));  // the slice claims more than toi_lower does
  // The ball's foot on the rod is at cos 30 degrees of 2.
  const double foot = std::sqrt(3) / 4;
  EXPECT_ACCEPTED(rod, upper(t + 1e-10, {{0, 0, 1 - foot}, {1, 0, foot}}));
  EXPECT_ACCEPTED(rod, upper(t + 1e-10, {{0, 0, 5 * (1 - foot)}, {1, 0, 5 * foot}}));
  EXPECT_REFUSED(contact_not_proved, rod, upper(t - 1e-12, {{0, 0, 1 - foot}, {1, 0, foot}}));
  EXPECT_REFUSED(contact_not_proved, rod, upper(t + 1e-10, {{0, 0, 1 - foot}, {1, 0, foot + 1e-4}}));
  EXPECT_REFUSED(contact_not_proved, rod, upper(t + 1e-10, {{0, 0, 1}}));
}

TEST(RotatingProof, BallWithAPivotOffItsCentre) {
  // Its centre goes round the origin at distance 2. The other ball stands at distance 4, a quarter ahead.
  Case problem;
  problem.a.shape = Sphere<double>{1};
  problem.a.position = V(2, 0, 0);
  problem.spin_a.rotation = V(0, 0, kPi / 2);
  problem.spin_a.pivot = V(-2, 0, 0);
  problem.b.shape = Sphere<double>{1.5};
  problem.b.position = V(0, 4, 0);
  // 20 - 16 sin(theta) = 2.5^2
  const double t = std::asin((20 - 6.25) / 16) / (kPi / 2);
  const V at(2 * std::cos(t * kPi / 2), 2 * std::sin(t * kPi / 2), 0);
  const V along = problem.b.position - at;
  EXPECT_ACCEPTED(problem, lower(t - 1e-10, {{0.3, V(-1, 2, 0), AxisFrame::world},
                                             {t - 1e-10, along, AxisFrame::world}}));
  EXPECT_REFUSED(
      slice_false, problem,
      lower(t + 1e-12, {{0.3, V(-1, 2, 0), AxisFrame::world}, {t + 1e-12, along, AxisFrame::world}}));
  EXPECT_ACCEPTED(problem, upper(t + 1e-10, {{0, 0, 1}}));
  EXPECT_REFUSED(contact_not_proved, problem, upper(t - 1e-12, {{0, 0, 1}}));
  // A target distance brings contact forward: 20 - 16 sin(theta) = 3^2.
  problem.target_distance = 0.5;
  const double sooner = std::asin(11.0 / 16) / (kPi / 2);
  EXPECT_ACCEPTED(problem, upper(sooner + 1e-10, {{0, 0, 1}}));
  EXPECT_REFUSED(contact_not_proved, problem, upper(sooner - 1e-12, {{0, 0, 1}}));
  EXPECT_REFUSED(
      slice_false, problem,
      lower(t - 1e-10, {{0.3, V(-1, 2, 0), AxisFrame::world}, {t - 1e-10, along, AxisFrame::world}}));
}

TEST(RotatingProof, TurnsThatCannotBeSeenCostOneSlice) {
  // A cylinder rolls on the spot about its own tilted axis, 513 radians, and comes down by 1 to z = 0.
  Case problem;
  problem.a.shape = Box<double>{V(100, 100, 1)};
  problem.a.position = V(0, 0, -1);
  problem.b.shape = Cylinder<double>{1, 2};
  problem.b.position = V(0, 0, 2);
  problem.b.orientation = {1, 1, 0, 0};  // z to -y, exactly
  problem.b.displacement = V(0.5, 0, -1);
  problem.spin_b.rotation = V(0, 513, 0);
  problem.spin_b.pivot = V(0, 0, 0.75);
  for (const double mean : {1e-9, 1e-14}) {
    RotatingCheckCost cost;
    const RotatingProof proof = lower(1 - mean, {{1 - mean, V(0, 0, 1), AxisFrame::world}});
    EXPECT_TRUE(check_rotating_proof(problem, proof, &cost).accepted());
    EXPECT_EQ(cost.pieces, 1);
  }
  EXPECT_REFUSED(undecided, problem, lower(1, {{1, V(0, 0, 1), AxisFrame::world}}));  // it touches there
  EXPECT_REFUSED(slice_false, problem, lower(1, {{1 + 1e-15, V(0, 0, 1), AxisFrame::world}}));

  // A ball about its centre.
  problem.b.shape = Sphere<double>{1};
  problem.spin_b = {V(100, 200, 300), V::Zero()};
  RotatingCheckCost cost;
  const RotatingProof proof = lower(1 - 1e-12, {{1 - 1e-12, V(0, 0, 1), AxisFrame::world}});
  EXPECT_TRUE(check_rotating_proof(problem, proof, &cost).accepted());
  EXPECT_EQ(cost.pieces, 1);
  EXPECT_REFUSED(undecided, problem, lower(1, {{1, V(0, 0, 1), AxisFrame::world}}));
}

TEST(RotatingProof, BothTurnAsOneThroughThousandsOfRadians) {
  Case problem;
  problem.a.shape = Box<double>{V(1, 1, 1)};
  problem.b.shape = Box<double>{V(1, 1, 1)};
  problem.b.position = V(2.25, 0, 0);
  problem.spin_a.rotation = problem.spin_b.rotation = V(0, 0, 5130);
  problem.spin_b.pivot = V(-2.25, 0, 0);
  problem.a.displacement = problem.b.displacement = V(3, 4, 5);
  for (const AxisFrame frame : {AxisFrame::a, AxisFrame::b}) {
    RotatingCheckCost cost;
    EXPECT_TRUE(check_rotating_proof(problem, miss({{1, V(1, 0, 0), frame}}), &cost).accepted());
    EXPECT_EQ(cost.pieces, 1);
  }
  EXPECT_REFUSED(slice_false, problem, miss({{1, V(1, 0, 0), AxisFrame::world}}));
  // Turning against each other about one point they are within sqrt(2) and 2.25 - 1.
  problem.spin_b.rotation = -problem.spin_a.rotation;
  EXPECT_REFUSED(slice_false, problem, miss({{1, V(1, 0, 0), AxisFrame::a}}));
}

TEST(RotatingProof, ScrewMotionsAndBothTurningAreCutIntoPieces) {
  // Two cubes turn about the line through their centres, against each other, and approach along it.
  Case problem;
  problem.a.shape = Box<double>{V(1, 1, 1)};
  problem.b.shape = Box<double>{V(1, 1, 1)};
  problem.b.position = V(0, 0, 3);
  problem.b.displacement = V(0, 0, -2);
  problem.spin_a.rotation = V(0, 0, 513);
  problem.spin_b.rotation = V(0, 0, -400);
  RotatingCheckCost cost;
  const RotatingProof along = lower(0.5 - 1e-10, {{0.5 - 1e-10, V(0, 0, 1), AxisFrame::world}});
  EXPECT_TRUE(check_rotating_proof(problem, along, &cost).accepted());
  EXPECT_EQ(cost.pieces, 1);                                                              // n x w = 0
  EXPECT_REFUSED(undecided, problem, lower(0.5, {{0.5, V(0, 0, 1), AxisFrame::world}}));  // they touch

  // Side by side, 2 sqrt(2) and a little apart: no contact whatever their angles, as a slice that is cut.
  problem.b.position = V(2.9, 0, 0);
  problem.b.displacement = V::Zero();
  problem.spin_a.rotation = V(0, 0, 20);
  problem.spin_b.rotation = V(0, 0, -30);
  cost = {};
  EXPECT_TRUE(check_rotating_proof(problem, miss({{1, V(1, 0, 0), AxisFrame::world}}), &cost).accepted());
  EXPECT_GT(cost.pieces, 20);
  EXPECT_EQ(cost.slices, 1);
  problem.b.position = V(2.8, 0, 0);
  problem.spin_b.rotation = V(0, 0, 20);  // corner to corner at once
  EXPECT_REFUSED(slice_false, problem, miss({{1, V(1, 0, 0), AxisFrame::world}}));
}

TEST(RotatingProof, WhatTheBudgetLeavesIsRefused) {
  // Two cubes side by side rotate alike, one an eighth of a rotation ahead. Together they reach 2 (cos +
  // sin)(22.5 degrees) = 2.613, each by itself 1.414. Neither is at all angles while the other is at its
  // greatest reach.
  Case problem;
  problem.a.shape = problem.b.shape = Box<double>{V(1, 1, 1)};
  problem.a.orientation = {std::cos(kPi / 8), 0, 0, std::sin(kPi / 8)};
  problem.b.position = V(2.7, 0, 0);
  problem.spin_a.rotation = problem.spin_b.rotation = V(0, 0, 100);
  EXPECT_ACCEPTED(problem, miss({{1, V(1, 0, 0), AxisFrame::world}}));
  problem.spin_a.rotation = problem.spin_b.rotation = V(0, 0, 1e6);
  EXPECT_REFUSED(slice_not_proved, problem, miss({{1, V(1, 0, 0), AxisFrame::world}}));
  problem.b.position = V(2.6, 0, 0);
  EXPECT_REFUSED(slice_false, problem, miss({{1, V(1, 0, 0), AxisFrame::world}}));
}

TEST(RotatingProof, LinearMotionIsASpecialCase) {
  Case problem;
  problem.a.shape = Box<double>{V(1, 1, 1)};
  problem.b.shape = Box<double>{V(1, 1, 1)};
  problem.b.position = V(0, 0.5, 4);
  problem.b.displacement = V(0, 0, -4);
  const auto chain = [](double end) {
    return std::vector<TimeSlice>{{0.25, V(0, 0, 1), AxisFrame::b}, {end, V(0, 0, 1), AxisFrame::a}};
  };
  const double before = std::nextafter(0.5, 0);
  EXPECT_ACCEPTED(problem, lower(before, chain(before)));
  EXPECT_REFUSED(slice_false, problem, lower(0.5, chain(0.5)));
  // Touching is contact, and decided: the point (1, 1, 1) of A is 3 : 1 between two corners of B.
  EXPECT_ACCEPTED(problem, upper(0.5, {{7, 3, 0.75}, {7, 1, 0.25}}));
  EXPECT_REFUSED(contact_not_proved, problem, upper(before, {{7, 3, 0.75}, {7, 1, 0.25}}));
  EXPECT_REFUSED(contact_not_proved, problem, upper(0.5, {{7, 3, 0.75}, {7, 1, std::nextafter(0.25, 0)}}));
  // At the start, and at the end of the time.
  problem.b.position = V(0, 0.5, 2);
  EXPECT_ACCEPTED(problem, upper(0, {{7, 3, 0.75}, {7, 1, 0.25}}));
  problem.b.position = V(0, 0.5, 6);
  EXPECT_ACCEPTED(problem, upper(1, {{7, 3, 0.75}, {7, 1, 0.25}}));
  problem.b.position = V(0, 0.5, 10);
  EXPECT_REFUSED(upper_beyond_end, problem, upper(2, {{7, 3, 0.75}, {7, 1, 0.25}}));
}

TEST(RotatingProof, CurvedPointsMustLieInTheirShapes) {
  // A cylinder that turns about z with its rim towards a ball at distance 1.5.
  Case problem;
  problem.a.shape = Cylinder<double>{1, 1};
  problem.spin_a.rotation = V(0, 0, kPi);
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = V(0, 1.5, 0);
  problem.b.displacement = V(0, -1, 0);
  RotatingProof proof = upper(0.5, {{0, 0, 1}});
  proof.contact[0].a.curved[0] = V(1, 0, 0);
  EXPECT_ACCEPTED(problem, proof);  // carried to (0, 1, 0)
  proof.contact[0].a.curved[0] = V(1 + 1e-15, 0, 0);
  EXPECT_REFUSED(point_outside, problem, proof);
  proof.contact[0].a.curved[0] = V(0, 1, 0);
  EXPECT_REFUSED(contact_not_proved, problem, proof);
}

// Below the tip of an octahedron, on the diagonal that it spins about, no four corners hold a point inside: three and the
// mean of others do.
TEST(RotatingProof, MoreThanFourPairsHoldTheOriginByAMean) {
  const std::vector<V> corners = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  Case problem;
  problem.a.shape = Hull<double>(std::span<const V>(corners));
  problem.spin_a.rotation = V(0, 0, 1);
  problem.b.position = V(0, 0, 0.75);
  EXPECT_REFUSED(undecided, problem, upper(0.5, {{4, 0}, {0, 0}, {2, 0}, {1, 0}}));  // on their border
  const RotatingProof five = upper(0.5, {{4, 0}, {0, 0}, {2, 0}, {1, 0, 0.5}, {3, 0, 0.25}}),
                      six = upper(0.5, {{4, 0}, {0, 0}, {2, 0}, {1, 0, 1}, {3, 0, 1}, {5, 0, 1}});
  EXPECT_ACCEPTED(problem, five);
  EXPECT_ACCEPTED(problem, six);
  const auto weighted = [&](double first, double fourth, double fifth) {
    RotatingProof other = five;
    other.weight[0] = first;
    other.weight[3] = fourth;
    other.weight[4] = fifth;
    return other;
  };
  EXPECT_ACCEPTED(problem, weighted(1, 0.25, 0.5));
  // The mean is a corner, or there is no mean, or there are no weights.
  EXPECT_REFUSED(undecided, problem, weighted(0, 1, 0));
  EXPECT_REFUSED(contact_not_proved, problem, weighted(1, 0, 0));
  EXPECT_REFUSED(weights_missing, problem, weighted(0, 0, 0));
  EXPECT_REFUSED(weights_missing, problem, weighted(1, 1, -0.5));
  // The choice of the three corners counts.
  EXPECT_REFUSED(contact_not_proved, problem, upper(0.5, {{0, 0}, {1, 0}, {2, 0}, {4, 0, 1}, {3, 0, 0.25}}));
  problem.b.position = V(0, 0, 1.25);
  EXPECT_REFUSED(contact_not_proved, problem, five);
  EXPECT_REFUSED(contact_not_proved, problem, six);
}

// Points of balls are named by an offset, in world axes where they are placed: it ends within the ball, and
// what is left of the radius counts on.
TEST(RotatingProof, OffsetsEndWithinTheirBalls) {
  // Balls of radii 1 and 2, their centres 2.5 apart at t = 0.5. One of them rotates, which moves none of its
  // points.
  Case problem;
  problem.a.shape = Sphere<double>{1};
  problem.spin_a.rotation = V(1, 2, 3);
  problem.b.shape = Sphere<double>{2};
  problem.b.position = V(3, 0, 0);
  problem.b.displacement = V(-1, 0, 0);
  RotatingProof one = upper(0.5, {{0, 0, 1}});
  EXPECT_ACCEPTED(problem, one);
  one.contact[0].a.offset = V(0.5, 0, 0);
  EXPECT_ACCEPTED(problem, one);  // 2 apart, with reaches of 0.5 and 2
  one.contact[0].a.offset = V(-0.5, 0, 0);
  EXPECT_REFUSED(contact_not_proved, problem, one);  // 3 apart
  one.contact[0].a.offset = V(1 + 1e-15, 0, 0);
  EXPECT_REFUSED(point_outside, problem, one);

  // Differences of their points surround the origin: no weight is read.
  RotatingProof four = upper(0.5, {{0, 0}, {0, 0}, {0, 0}, {0, 0}});
  four.weight = {1, 0, 0, 0};
  const V directions[4] = {V(0, 0, 1), V(0, 0.9, -0.4), V(0, -0.9, -0.4), V(1, 0, 0)};
  for (std::size_t i = 0; i < 4; ++i) {
    four.contact[i].a.offset = i < 3 ? V(0.7 * directions[i]) : directions[i];
    four.contact[i].b.offset = i < 3 ? V(-2 * directions[i]) : V(-2, 0, 0);
    if (i < 3) four.contact[i].a.offset[0] = -0.7;
  }
  for (std::size_t i = 0; i < 3; ++i) four.contact[i].b.offset *= 0.9;
  EXPECT_ACCEPTED(problem, four);
  four.contact[3].b.offset = V(2, 0, 0);  // now all of them are on one side
  four.contact[3].a.offset = V(-1, 0, 0);
  four.weight = {0, 0, 0, 1};
  EXPECT_REFUSED(contact_not_proved, problem, four);

  // A crossing's triangle has none.
  RotatingProof crossing = upper(0.5, {{0, 0}, {0, 0}, {0, 0}});
  crossing.crossing = true;
  crossing.contact[1].a.offset = V(0.5, 0, 0);
  EXPECT_REFUSED(malformed, problem, crossing);
}

// At t = 0 all is exact: the boundary of what the pairs span is contact, later it is nothing that balls tell.
TEST(RotatingProof, ContactAtTheStartIsExact) {
  Case problem;
  problem.a.shape = Box<double>{V(1, 1, 1)};
  problem.b.shape = Segment<double>{V(1, 0, 0), V(2, 0, 0)};
  problem.b.position = V(0, 0, 0);
  problem.spin_b.rotation = V(0, 0, 1);
  // Two corners of the face x = 1 across its middle, beside one end of the segment.
  const RotatingProof touch = upper(0, {{1, 0, 0.5}, {7, 0, 0.5}});
  EXPECT_ACCEPTED(problem, touch);
  problem.b.position[0] = 0x1p-52;
  EXPECT_REFUSED(contact_not_proved, problem, touch);
  problem.b.position[0] = 0;
  problem.b.position[1] = 0x1p-60;  // beside the line of the two
  EXPECT_REFUSED(contact_not_proved, problem, touch);
  problem.b.position[1] = 0;
  problem.target_distance = 0x1p-40;
  problem.b.position[0] = 0x1p-40;
  EXPECT_ACCEPTED(problem, touch);
}

TEST(RotatingProof, MalformedProofsAndCases) {
  const Case sound = rod_and_ball();
  const RotatingProof proof = [] {
    RotatingProof p = lower(0.5, {{0.25, V(0, 1, 0), AxisFrame::a}, {0.5, V(0, 1, 0), AxisFrame::a}});
    p.toi_upper = 0.53;
    p.contact_size = 2;
    p.contact[1].a.vertex = 1;
    p.weight = {0.57, 0.43, 0, 0};
    return p;
  }();
  EXPECT_ACCEPTED(sound, proof);
  const auto edited = [&](auto edit) {
    RotatingProof other = proof;
    edit(other);
    return other;
  };
  using P = RotatingProof;
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.toi_lower = kNan; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.toi_lower = -1; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.toi_upper = kNan; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.chain[1].end = 0.2; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.chain[0].end = -0.1; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.chain[1].end = kInf; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.chain[1].end = kNan; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.chain[1].axis[2] = kNan; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.chain[1].frame = static_cast<AxisFrame>(3); }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.contact_size = 7; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.contact_size = -1; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.contact[0].a.vertex = 2; }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.contact[0].b.offset = V(0, kNan, 0); }));
  EXPECT_REFUSED(malformed, sound, edited([](P& p) { p.contact[0].b.curved[1][0] = kNan; }));
  EXPECT_REFUSED(axis_missing, sound, edited([](P& p) { p.chain[1].axis = V::Zero(); }));
  EXPECT_REFUSED(chain_too_short, sound, edited([](P& p) { p.chain.pop_back(); }));
  EXPECT_REFUSED(chain_too_short, sound, edited([](P& p) { p.chain.clear(); }));
  EXPECT_REFUSED(contact_missing, sound, edited([](P& p) { p.contact_size = 0; }));
  EXPECT_REFUSED(upper_beyond_end, sound, edited([](P& p) { p.toi_upper = 1.5; }));
  EXPECT_REFUSED(weights_missing, sound, edited([](P& p) { p.weight = {0, 0, 1, 1}; }));
  EXPECT_REFUSED(weights_missing, sound, edited([](P& p) { p.weight[0] = -0.57; }));
  // Absent claims.
  EXPECT_ACCEPTED(sound, RotatingProof{});
  EXPECT_ACCEPTED(sound, edited([](P& p) {
                    p.toi_upper = kInf;
                    p.contact_size = 0;
                  }));

  const auto with = [&](auto edit) {
    Case other = sound;
    edit(other);
    return other;
  };
  EXPECT_REFUSED(malformed, with([](Case& c) { c.spin_a.rotation[0] = kNan; }), proof);
  EXPECT_REFUSED(malformed, with([](Case& c) { c.spin_b.pivot[0] = kInf; }), proof);
  EXPECT_REFUSED(malformed, with([](Case& c) { c.t_max = kNan; }), proof);
  EXPECT_REFUSED(malformed, with([](Case& c) { c.target_distance = -1; }), proof);
  EXPECT_REFUSED(malformed, with([](Case& c) { c.b.shape = Sphere<double>{-1}; }), proof);
  EXPECT_REFUSED(malformed, with([](Case& c) { c.a.shape = Rounded<double>{}; }), proof);
  EXPECT_REFUSED(malformed, with([](Case& c) { c.a.orientation = {0, 0, 0, 0}; }), proof);
  EXPECT_REFUSED(out_of_range, with([](Case& c) { c.spin_b.rotation[0] = 1e-61; }), proof);
  EXPECT_REFUSED(out_of_range, with([](Case& c) { c.target_distance = 1e61; }), proof);
  EXPECT_REFUSED(unsupported, with([](Case& c) { c.start_policy = corpus::StartPolicy::pass_over; }),
                 edited([](P& p) { p.toi_lower = 0; }));
  EXPECT_REFUSED(unsupported, with([](Case& c) {
                   for (int k = 0; k < 70; ++k) c.a.shape = rounded<double>(c.a.shape, 0);
                 }),
                 RotatingProof{});
  // A miss over an endless time has no chain.
  EXPECT_REFUSED(chain_too_short, with([](Case& c) { c.t_max = kInf; }),
                 edited([](P& p) { p.toi_lower = kInf; }));
}

TEST(RotatingProof, PrecisionIsRaisedBeforeItRefuses) {
  // The box turns about the diagonal (1, 1, 0), so that its corners come as low as -sqrt(3) at 54.7 degrees.
  // Both bodies move along at 2^130, and the pivot is 2^60 away along the diagonal: neither changes anything,
  // but they leave doubles and 128 bits no digit for a gap of 0.008.
  Case problem = box_over_plate(1.74);
  problem.spin_b.rotation = V(1.25, 1.25, 0);
  const RotatingProof proof = miss({{1, V(0, 0, 1), AxisFrame::world}});
  RotatingCheckCost plain, hard;
  EXPECT_TRUE(check_rotating_proof(problem, proof, &plain).accepted());
  EXPECT_EQ(plain.in_double, 1);
  problem.a.displacement = problem.b.displacement = V(0, 0, 0x1p130);
  problem.spin_b.pivot = V(0x1p60, 0x1p60, 0);
  EXPECT_TRUE(check_rotating_proof(problem, proof, &hard).accepted());
  EXPECT_EQ(hard.in_double, 0);
  EXPECT_EQ(hard.raised, 1);
  problem.b.position[2] = 1.73;
  EXPECT_REFUSED(slice_false, problem, proof);
  problem.a.displacement = problem.b.displacement = V(0, 0, 0x1p700);
  EXPECT_REFUSED(out_of_range, problem, proof);
}

}  // namespace
}  // namespace graze::test
