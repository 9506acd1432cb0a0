// The lecture's ConservativeAdvancement, as printed, and its answers. Each test names one line of it, a case
// on which that line is wrong, core's answer there, and the truth.
//
//   while(distance < epsilon)
//       runs while the shapes are near, but must run while they are apart
//   if(toi > 1) return false;  ...; return true;
//       returns a contact beyond the end of the frame as a hit
//   dt = distance / Dot(normal, vB - vA)
//       is positive only for the normal from B to A, and divides along an axis on which the bodies do not
//       approach, although that axis proves a miss
//
// The loop is transliterated with one switch for each correction, so that a line is shown to be wrong with
// all the others right. It has an iteration budget, unlike the printed one.
#include <gtest/gtest.h>
#include <graze/cast.hpp>
#include <graze/distance.hpp>

#include "tests/shared/query_truth.hpp"

namespace graze {
namespace {

using namespace test;

struct Corrected {
  bool condition = false, normal = false, end = false, division = false;
};
constexpr Corrected all_but(bool condition, bool normal, bool end, bool division) {
  return {condition, normal, end, division};
}

struct Printed {
  bool answer = false;  // what the loop returns
  double toi = 0;
  bool ended = true;  // false: the budget ran out
};

// FindClosestFeatures: distance and unit normal from A to B at the time toi, or NaN for a time that is not
// finite.
struct Features {
  double distance;
  Vec3<double> normal;
};
Features find_closest_features(Body<double> a, Body<double> b, double toi) {
  a.position += toi * a.displacement;
  b.position += toi * b.displacement;
  const DistanceResult<double> d = distance(a, b);
  if (d.invalid != Invalid::none) return {NAN, Vec3<double>::Constant(NAN)};
  return {d.lower, d.normal};
}

Printed conservative_advancement_as_printed(const Body<double>& a, const Body<double>& b, double epsilon,
                                            Corrected corrected) {
  constexpr int kBudget = 1000;
  Printed out;
  Features f = find_closest_features(a, b, out.toi);
  for (int i = 0; corrected.condition ? f.distance > epsilon : f.distance < epsilon; ++i) {
    if (i == kBudget) {
      out.ended = false;
      return out;
    }
    if (out.toi > 1) return out;
    const Vec3<double> normal = corrected.normal ? Vec3<double>(-f.normal) : f.normal;
    const double closing = normal.dot(b.displacement - a.displacement);
    if (corrected.division && !(closing > 0)) return out;
    out.toi += f.distance / closing;
    f = find_closest_features(a, b, out.toi);
  }
  if (corrected.end && out.toi > 1) return out;
  out.answer = true;
  return out;
}

constexpr double kEpsilon = 1e-9;  // of lengths of order 1: "sufficiently small"
constexpr Corrected kEverything{true, true, true, true};

const Body<double> kBox{.shape = Box<double>{{1, 1, 1}}};

Body<double> box_at(const Vec3<double>& position, const Vec3<double>& displacement) {
  return {.shape = Box<double>{{1, 1, 1}}, .position = position, .displacement = displacement};
}

// All three methods of core give the outcome and the time that the exact oracle gives.
void expect_ours_right(const Body<double>& a, const Body<double>& b) {
  const oracle::LinearTruth truth(case_of(a, b));
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    CastOptions<double> options;
    options.method = method;
    const CastResult<double> r = cast(a, b, options);
    EXPECT_EQ(r.outcome, truth.outcome());
    if (r.outcome == Outcome::hit) {
      EXPECT_NEAR(r.toi_lower, truth.toi_lower(), 1e-14);
    }
  }
}

TEST(PrintedLoop, WithEveryCorrectionItIsRightOnThePlainCases) {
  const Body<double> arrives = box_at({4, 0, 0}, {-4, 0, 0}), beside = box_at({4, 3, 0}, {-4, 0, 0});
  const Printed hit = conservative_advancement_as_printed(kBox, arrives, kEpsilon, kEverything);
  EXPECT_TRUE(hit.answer && hit.ended);
  EXPECT_NEAR(hit.toi, 0.5, 1e-9);
  EXPECT_FALSE(conservative_advancement_as_printed(kBox, beside, kEpsilon, kEverything).answer);
  expect_ours_right(kBox, arrives);
  expect_ours_right(kBox, beside);
}

TEST(PrintedLoop, RunsWhileTheShapesAreNearSoThatEveryGapIsAHitAtZero) {
  const Body<double> arrives = box_at({4, 0, 0}, {-4, 0, 0}), departs = box_at({4, 0, 0}, {4, 0, 0});
  for (const Body<double>& b : {arrives, departs}) {
    for (const Corrected& corrected : {Corrected{}, all_but(false, true, true, true)}) {
      const Printed r = conservative_advancement_as_printed(kBox, b, kEpsilon, corrected);
      EXPECT_TRUE(r.answer) << "a hit";
      EXPECT_EQ(r.toi, 0) << "two units apart";
    }
    expect_ours_right(kBox, b);  // 0.5, and a miss
  }
}

TEST(PrintedLoop, ReturnsAContactAfterTheEndOfTheFrame) {
  // Contact at t = 1.5. The one step goes there, finds no distance left, and the loop ends.
  const Body<double> late = box_at({5, 0, 0}, {-2, 0, 0});
  const Printed r =
      conservative_advancement_as_printed(kBox, late, kEpsilon, all_but(true, true, false, true));
  EXPECT_TRUE(r.answer);
  EXPECT_EQ(r.toi, 1.5);
  expect_ours_right(kBox, late);  // a miss
}

TEST(PrintedLoop, WithTheNormalFromAToBTimeRunsBackwards) {
  const Body<double> arrives = box_at({4, 0, 0}, {-4, 0, 0});
  const Printed r =
      conservative_advancement_as_printed(kBox, arrives, kEpsilon, all_but(true, false, true, false));
  // The farther back, the larger the distance: each step doubles it, until it is no number and ends the loop.
  EXPECT_TRUE(r.answer) << "a hit";
  EXPECT_LT(r.toi, -1e50);
  // And with the check for an axis on which they do not approach, every hit is a miss.
  EXPECT_FALSE(
      conservative_advancement_as_printed(kBox, arrives, kEpsilon, all_but(true, false, true, true)).answer);
  expect_ours_right(kBox, arrives);
}

TEST(PrintedLoop, DividesByAnAxisOnWhichTheyDoNotApproach) {
  // Sliding past at a distance of 1: n.v = 0, the step is infinite, the distance there is no number, and
  // "no number > epsilon" ends the loop.
  const Body<double> past = box_at({0, 3, 0}, {4, 0, 0});
  Printed r = conservative_advancement_as_printed(kBox, past, kEpsilon, all_but(true, true, false, false));
  EXPECT_TRUE(r.answer) << "a hit";
  EXPECT_FALSE(std::isfinite(r.toi));
  expect_ours_right(kBox, past);  // a miss
  // Departing from where they touch at t = -0.5: the step goes back to it.
  const Body<double> departs = box_at({4, 0, 0}, {4, 0, 0});
  r = conservative_advancement_as_printed(kBox, departs, kEpsilon, all_but(true, true, true, false));
  EXPECT_TRUE(r.answer) << "a hit";
  EXPECT_EQ(r.toi, -0.5);
  expect_ours_right(kBox, departs);  // a miss
}

TEST(PrintedLoop, ItsEpsilonTurnsNearIntoHit) {
  // Past each other at a tenth of epsilon: a miss, and the axis that proves it is at hand.
  const double epsilon = 1e-4;
  const Body<double> past = box_at({4, 2 + epsilon / 10, 0}, {-8, 0, 0});
  const Printed r = conservative_advancement_as_printed(kBox, past, epsilon, kEverything);
  EXPECT_TRUE(r.answer);
  expect_ours_right(kBox, past);
}

TEST(PrintedLoop, SweepingBothAndTestingOverlapSaysNothingOfWhen) {
  // Crossing the same place at different times: the swept shapes overlap, the bodies never meet.
  const Body<double> a{.shape = Box<double>{{1, 1, 1}}, .position = {-6, 0, 0}, .displacement = {12, 0, 0}};
  const Body<double> b{.shape = Box<double>{{1, 1, 1}}, .position = {0, -24, 0}, .displacement = {0, 48, 0}};
  const Body<double> swept_a{.shape = Box<double>{{7, 1, 1}}}, swept_b{.shape = Box<double>{{1, 25, 1}}};
  EXPECT_EQ(distance(swept_a, swept_b).upper, 0) << "the sweeps overlap";
  // Both are at the crossing at t = 1/2. This moves B's passage to the start.
  Body<double> early = b;
  early.position = {0, -4, 0};
  const Body<double> swept_early{.shape = Box<double>{{1, 25, 1}}, .position = {0, 20, 0}};
  EXPECT_EQ(distance(swept_a, swept_early).upper, 0);
  EXPECT_EQ(oracle::LinearTruth(case_of(a, early)).outcome(), Outcome::miss);
  expect_ours_right(a, early);
  expect_ours_right(a, b);  // a hit
}

}  // namespace
}  // namespace graze
