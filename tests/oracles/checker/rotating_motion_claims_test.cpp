// The claims that a rotating proof may make about a body's pivot, its ball, the place of its own frame and
// its speed, in every floating-point environment of the check. The truth can be read off each case.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracles/checker/check_rotating_proof.hpp"
#include "tests/oracles/arithmetic/environments.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::check_rotating_proof;
using oracle::RotatingCheckCost;
using V = Vec3<double>;

constexpr double kPi = std::numbers::pi;

RotatingProof miss(const V& axis, AxisFrame frame) {
  RotatingProof proof;
  proof.toi_lower = kInfinity<double>;
  proof.chain = {{1, axis, frame}};
  return proof;
}
std::string refusal(const Case& problem, const RotatingProof& proof, RotatingCheckCost* cost = nullptr) {
  return to_string(check_rotating_proof(problem, proof, cost).refusal);
}
// The same with A and B exchanged.
std::string refusal_of_swapped(Case problem, RotatingProof proof) {
  std::swap(problem.a, problem.b);
  std::swap(problem.spin_a, problem.spin_b);
  for (TimeSlice& slice : proof.chain) {
    slice.axis = -slice.axis;
    if (slice.frame != AxisFrame::world)
      slice.frame = slice.frame == AxisFrame::a ? AxisFrame::b : AxisFrame::a;
  }
  return refusal(problem, proof);
}

// A bar rotates once about its middle, through a post. The post does not rotate, so none of its points is a
// pivot that counts. The pivot in the case is the bar's own. If it counted in one bound and not in another,
// the post would seem not to move in the bar's axes.
TEST(RotatingMotion, ThePivotOfAPostDoesNotHoldItStillInTheBarsAxes) {
  Case problem;
  problem.a.shape = Box<double>{V(2, 0.125, 0.125)};
  problem.spin_a.rotation = V(0, 0, 2 * kPi);
  problem.b.position = V(0, 1, 0);
  for (const V& pivot : {V(0, -1, 0), V(0, 0, 0), V(0, -1, 1e-9), V(1e30, 0, 0)}) {
    problem.spin_b.pivot = pivot;
    const RotatingProof across = miss(V(0, 1, 0), AxisFrame::a);
    EXPECT_EQ(refusal(problem, across), "slice_false");
    EXPECT_EQ(refusal_of_swapped(problem, across), "slice_false");
    // Out of the bar's reach: so it is whatever the pivot.
    Case apart = problem;
    apart.b.position = V(0, 0, 1);
    EXPECT_EQ(refusal(apart, miss(V(0, 0, 1), AxisFrame::a)), "accepted");
    EXPECT_EQ(refusal_of_swapped(apart, miss(V(0, 0, 1), AxisFrame::a)), "accepted");
  }
}

// A ball of radius 1 goes round a point at distance 5, once or many times: nothing at 5.5 from that point is
// clear of it, all beyond 6 is.
TEST(RotatingMotion, ABallByAnyNameSweepsItsRadius) {
  const Shape<double> balls[] = {
      Sphere<double>{1},
      Ellipsoid<double>{V(1, 1, 1)},
      Capsule<double>{1, 0},
      rounded<double>(Point<double>{}, 1),
      rounded<double>(Ellipsoid<double>{V(0.5, 0.5, 0.5)}, 0.5),
      sum<double>(Ellipsoid<double>{V(0.5, 0.5, 0.5)}, Sphere<double>{0.5}),
      hull_of<double>(Ellipsoid<double>{V(1, 1, 1)}, Sphere<double>{0.5}),
      posed<double>(Ellipsoid<double>{V(1, 1, 1)}, V(0, 0, 0), Quaternion<double>{1, 2, 3, 4}),
  };
  for (const Shape<double>& ball : balls) {
    Case problem;
    problem.a.shape = ball;
    problem.a.position = V(5, 0, 0);
    problem.spin_a.pivot = V(-5, 0, 0);
    for (const double angle : {2 * kPi, 1e6}) {
      problem.spin_a.rotation = V(0, 0, angle);
      for (const double height : {5.5, 5.999}) {
        problem.b.position = V(0, height, 0);
        EXPECT_NE(refusal(problem, miss(V(0, 1, 0), AxisFrame::world)), "accepted") << angle << " " << height;
        EXPECT_NE(refusal_of_swapped(problem, miss(V(0, 1, 0), AxisFrame::world)), "accepted");
      }
      RotatingCheckCost cost;
      problem.b.position = V(0, 6.001, 0);
      EXPECT_EQ(refusal(problem, miss(V(0, 1, 0), AxisFrame::world), &cost), "accepted") << angle;
      EXPECT_EQ(refusal_of_swapped(problem, miss(V(0, 1, 0), AxisFrame::world)), "accepted") << angle;
    }
  }
}

// A plate rotates under a tile, whose own frame is far out, as that of a piece of a level is. In the plate's
// axes the tile's points bend by their distance from the plate's axis, wherever the tile's frame is.
TEST(RotatingMotion, ABodyAtRestFarOutInItsOwnFrameCostsNoMore) {
  Case problem;
  problem.a.shape = Box<double>{V(2, 2, 0.5)};
  problem.spin_a.rotation = V(0.02, 0.01, 3);
  long long near = 0;
  for (const double out : {0.0, 0x1p10, 0x1p21, 0x1p30}) {
    problem.b.shape = posed<double>(Box<double>{V(1, 1, 0.25)}, V(out, -3 * out, 0), Quaternion<double>{});
    problem.b.position = V(-out, 3 * out, 0.875);
    for (const V& pivot : {V(0, 0, 0), V(0, 1e9, 0)}) {
      problem.spin_b.pivot = pivot;
      RotatingCheckCost cost;
      EXPECT_EQ(refusal(problem, miss(V(0, 0, 1), AxisFrame::a), &cost), "accepted") << out;
      if (out == 0) near = cost.pieces;
      EXPECT_LE(cost.pieces, near + 4) << out;
    }
  }
  EXPECT_LT(near, 32);
}

// Over 1e9 radians, a bound by the second derivatives alone would need slices of a few hundred thousandths.
// The speed along an axis that is nearly that of the rotation is a hundred, for a body of size 1 at a
// distance of 200.
TEST(RotatingMotion, ASliceOfAHundredMillionRadiansIsProvedByItsSpeed) {
  Case problem;
  problem.a.shape =
      sum<double>(Segment<double>{V(0, 0, -1), V(0, 0, 1)}, Segment<double>{V(-1, 0, 0), V(1, 0, 0)});
  problem.spin_a.rotation = V(0, 0, 1e9);
  problem.b.shape = Segment<double>{V(0, -1, 0), V(0, 1, 0)};
  problem.b.position = V(0, 0, 200);
  problem.b.displacement = V(0, 0, -10);
  problem.spin_b.rotation = V(0, 0, 1e9);
  // |n x w| = 50 each.
  for (const double tilt : {5e-8, -5e-8}) {
    RotatingCheckCost cost;
    EXPECT_EQ(refusal(problem, miss(V(tilt, 0, 1), AxisFrame::world), &cost), "accepted");
    EXPECT_EQ(refusal_of_swapped(problem, miss(V(tilt, 0, 1), AxisFrame::world)), "accepted");
    EXPECT_EQ(cost.pieces, 1);
  }
  problem.b.displacement = V(0, 0, -200);
  EXPECT_EQ(refusal(problem, miss(V(5e-8, 0, 1), AxisFrame::world)), "slice_false");
}

// The bodies overlap at the start. The bound claims a time that is above 0 by a bit, and needs a chain.
TEST(RotatingMotion, TheCallersEnvironmentChangesNothingAndIsGivenBack) {
  Case overlap;
  overlap.a.shape = Box<double>{V(3, 3, 3)};
  overlap.spin_a.rotation = V(0, 0, 1);
  overlap.t_max = 5e-324;
  RotatingProof forged;
  forged.toi_lower = 5e-324;
  Case apart = overlap;
  apart.t_max = 1;
  apart.b.position = V(0, 0, 3.0000000001);
  const RotatingProof sound = miss(V(0, 0, 1), AxisFrame::world);
  const auto judge = [&] {
    RotatingCheckCost cost;
    const std::string first = refusal(overlap, forged), second = refusal(apart, sound, &cost);
    return first + " " + second + " " + std::to_string(cost.in_double);
  };
  for (const auto& [name, result, given_back] : in_every_environment(judge)) {
    EXPECT_EQ(result, "chain_too_short accepted 1") << name;
    EXPECT_TRUE(given_back) << name;
  }
}

}  // namespace
}  // namespace graze::test
