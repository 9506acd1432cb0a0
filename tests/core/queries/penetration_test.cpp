#include <gtest/gtest.h>
#include <graze/distance.hpp>
#include <graze/penetration.hpp>

#include "tests/shared/query_truth.hpp"

namespace graze {
namespace {

using namespace test;

template <class S>
class Penetration : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Penetration, Scalars);

// Test slack, over u scale: the worst of 5,000 pairs a family was 2.4 (a needle or a sheet near the noise:
// 25).
constexpr double kSlack = 8;
constexpr double kThinSlack = 64;

// Everything a result claims, against the exact oracle. Returns false for bodies that are apart.
template <class S>
bool check(const Body<S>& a, const Body<S>& b, const PenetrationResult<S>& r, double slack, const char* what,
           int round) {
  const oracle::LinearTruth truth(case_of(a, b));
  const bool contact = truth.outcome() != Outcome::miss;
  const double limit = slack * double(kUnitRoundoff<S>) * truth.scale().high;
  if (!contact) {
    EXPECT_TRUE(r.outcome == Outcome::miss || truth.distance().high <= limit) << what << ' ' << round;
    return false;
  }
  const double depth = truth.depth().low;
  if (r.outcome == Outcome::miss) {
    EXPECT_LE(depth, limit) << what << ' ' << round;
    return true;
  }
  EXPECT_EQ(r.outcome, Outcome::initially_overlapping) << what << ' ' << round;
  EXPECT_LE(r.lower, depth + limit) << what << ' ' << round;
  EXPECT_GE(r.upper, depth - limit) << what << ' ' << round;
  EXPECT_LE(r.lower, r.upper);
  if (r.stalled) return true;
  EXPECT_LE(double(r.upper) - double(r.lower), limit) << what << ' ' << round;
  // h(n) of the normal itself, exact. The witnesses are on their bodies and as far apart as the depth, along
  // n.
  const Vec3<double> n = widened<S>(r.normal);
  EXPECT_NEAR(n.norm(), 1, 8 * double(kUnitRoundoff<S>));
  EXPECT_LE(truth.normal_error(n).high, depth + limit) << what << ' ' << round;
  const double off = limit + 2 * double(kUnitRoundoff<S>) * b.position.norm();
  EXPECT_LE(truth.distance_from_body('a', 0, widened<S>(r.point_a)).high, off) << what << ' ' << round;
  EXPECT_LE(truth.distance_from_body('b', 0, widened<S>(r.point_b)).high, off) << what << ' ' << round;
  const Vec3<double> apart = widened<S>(r.point_a) - widened<S>(r.point_b);
  EXPECT_NEAR(apart.norm(), depth, 2 * off) << what << ' ' << round;
  EXPECT_GE(n.dot(apart), depth - 2 * off) << what << ' ' << round;
  return true;
}

TYPED_TEST(Penetration, LeastDepthIsTheExactOne) {
  using S = TypeParam;
  for (const Pairs pairs : kPairs) {
    Draw draw{71};
    int contacts = 0, stalls = 0;
    for (int round = 0; round < 400; ++round) {
      const auto [a, b] = draw_pair<S>(draw, pairs, round);
      const PenetrationResult<S> r = penetration(a, b);
      contacts += check(a, b, r, kSlack, name(pairs), round);
      stalls += r.stalled;
    }
    EXPECT_GT(contacts, 100) << name(pairs);
    EXPECT_EQ(stalls, 0) << name(pairs);
  }
}

// Vertices nearer to each other than some of their faces' rounding: needles, sheets, a crumb in a room.
TYPED_TEST(Penetration, ThinBodiesKeepAnHonestBracket) {
  using S = TypeParam;
  Draw draw{72};
  int contacts = 0, stalls = 0;
  const auto squashed = [&](const Vec3<double>& half) {
    std::vector<Vec3<S>> v;
    for (int i = 0; i < 8; ++i) v.push_back(draw.vector<double>(1).cwiseProduct(half).template cast<S>());
    return Hull<S>(std::span<const Vec3<S>>(v));
  };
  for (int round = 0; round < 600; ++round) {
    const double thin = std::pow(10.0, -(round % 17));
    Body<S> a{.shape = squashed({1, 1, thin})}, b{.shape = squashed({1, 1, thin / 2})};
    if (round % 3 == 1) b = {.shape = squashed({1, thin, thin}), .position = draw.vector<S>(0.3)};
    if (round % 3 == 2) b = {.shape = squashed({thin, thin, thin}), .position = draw.vector<S>(0.3 * thin)};
    if (round % 2) b.orientation = draw.turn<S>();
    const PenetrationResult<S> r = penetration(a, b);
    contacts += check(a, b, r, kThinSlack, "thin", round);
    stalls += r.stalled;
  }
  EXPECT_GT(contacts, 200);
  EXPECT_LE(stalls, 12);  // all of them where the thickness itself is a few dozen u
}

TYPED_TEST(Penetration, TouchingIsADepthOfNothingWithANormal) {
  using S = TypeParam;
  const Body<S> box{.shape = Box<S>{{1, 2, 3}}};
  for (const Vec3<S>& at :
       {Vec3<S>(2, 0, 0), Vec3<S>(S(0.5), 4, 1), Vec3<S>(2, 4, 0), Vec3<S>(2, -4, 6), Vec3<S>(0, 0, -6)}) {
    const Body<S> other{.shape = Box<S>{{1, 2, 3}}, .position = at};
    const PenetrationResult<S> r = penetration(box, other);
    ASSERT_EQ(r.outcome, Outcome::initially_overlapping) << at.transpose();
    EXPECT_EQ(r.lower, 0);
    EXPECT_LE(r.upper, 64 * kUnitRoundoff<S>);
    EXPECT_FALSE(r.stalled);
    EXPECT_NEAR(r.normal.norm(), 1, 4 * kUnitRoundoff<S>);
    EXPECT_GE(r.normal.dot(at), S(1.9)) << "from A to B";
    EXPECT_LE((r.point_a - r.point_b).norm(), 64 * kUnitRoundoff<S>);
  }
}

TYPED_TEST(Penetration, FlatAndSmallerSetsOfEveryDimension) {
  using S = TypeParam;
  const Body<S> point{.shape = Point<S>{}};
  const Body<S> segment{.shape = Hull<S>{{-1, 0, 0}, {1, 0, 0}}};
  const Body<S> triangle{.shape = Hull<S>{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
  for (const auto* a : {&point, &segment, &triangle}) {
    for (const auto* b : {&point, &segment, &triangle}) {
      const PenetrationResult<S> r = penetration(*a, *b);
      ASSERT_EQ(r.outcome, Outcome::initially_overlapping);
      EXPECT_EQ(r.upper, 0);
      EXPECT_FALSE(r.stalled);
      EXPECT_NEAR(r.normal.norm(), 1, 4 * kUnitRoundoff<S>);
      EXPECT_LE((r.point_a - r.point_b).norm(), 8 * kUnitRoundoff<S>);
    }
    // Rounded by a ball: its radius, whatever the core.
    const Body<S> ball{.shape = Sphere<S>{S(0.5)}};
    const PenetrationResult<S> r = penetration(*a, ball);
    EXPECT_NEAR(r.upper, 0.5, 8 * kUnitRoundoff<S>);
    EXPECT_NEAR(r.lower, 0.5, 8 * kUnitRoundoff<S>);
    EXPECT_NEAR((r.point_a - r.point_b).norm(), 0.5, 8 * kUnitRoundoff<S>);
  }
}

TYPED_TEST(Penetration, MovingByTheDepthSeparates) {
  using S = TypeParam;
  Draw draw{73};
  int contacts = 0;
  for (int round = 0; round < 200; ++round) {
    auto [a, b] = draw_pair<S>(draw, round % 2 ? Pairs::hulls : Pairs::balls, round);
    const PenetrationResult<S> r = penetration(a, b), swapped = penetration(b, a);
    EXPECT_EQ(r.outcome, swapped.outcome);
    if (r.outcome != Outcome::initially_overlapping || r.lower < S(1e-3)) continue;
    ++contacts;
    const S slack = 64 * kUnitRoundoff<S>;
    EXPECT_NEAR(r.upper, swapped.upper, slack) << round;
    Body<S> moved = b;
    moved.position = b.position + (r.upper + slack) * r.normal;
    EXPECT_EQ(penetration(a, moved).outcome, Outcome::miss) << round;
    // No shorter move does, in this direction or another.
    for (const Vec3<S>& n : {r.normal, unit(draw.vector<S>(1)), unit(draw.vector<S>(1))}) {
      moved.position = b.position + (r.lower - slack) * n;
      EXPECT_EQ(penetration(a, moved).outcome, Outcome::initially_overlapping) << round;
    }
  }
  EXPECT_GT(contacts, 50);
}

TYPED_TEST(Penetration, CurvedBodiesByTheirClosedForms) {
  using S = TypeParam;
  const S slack = 64 * 14 * kUnitRoundoff<S>;  // 64 u over a scale of 14, the floor's diagonal
  const Body<S> floor{.shape = Box<S>{{5, 5, 1}}, .position = {0, 0, -1}};
  const Body<S> can{.shape = Cylinder<S>{S(0.5), 1}, .position = {S(0.25), S(0.5), S(0.75)}};
  PenetrationResult<S> r = penetration(floor, can);
  EXPECT_NEAR(r.upper, 0.25, slack);
  EXPECT_NEAR(r.lower, 0.25, slack);
  const Body<S> egg{.shape = Ellipsoid<S>{{1, S(0.5), S(0.75)}}, .position = {S(0.25), S(0.5), S(0.5)}};
  r = penetration(floor, egg);
  EXPECT_NEAR(r.upper, 0.25, slack);
  EXPECT_LE(r.lower, S(0.25) + slack);
  EXPECT_TRUE(r.stalled || r.lower >= S(0.25) - slack);
  EXPECT_NEAR(r.normal[2], 1, 1e-3);
  const Body<S> capsule{.shape = Capsule<S>{S(0.5), 1}, .position = {0, 0, S(1.25)}};
  r = penetration(floor, capsule);
  EXPECT_NEAR(r.upper, 0.25, slack);
  EXPECT_NEAR(r.lower, 0.25, slack);
}

// The header's claims about the points, also for cores that are apart and an axis that is known only to the
// root of the rounding.
TYPED_TEST(Penetration, ShallowPointsOfRoundedBodiesAreBroughtTogether) {
  using S = TypeParam;
  Draw draw{62};
  for (int round = 0; round < 200; ++round) {
    const Body<S> a{.shape = Cylinder<S>{1, 1}, .orientation = draw.turn<S>()};
    Body<S> b{
        .shape = Capsule<S>{S(0.5), S(0.25)}, .position = draw.vector<S>(4), .orientation = draw.turn<S>()};
    const auto apart = distance(a, b);
    if (!(apart.lower > 0)) continue;
    b.position -= (apart.upper + std::pow(S(2), S(-2 - round % 12))) * apart.normal;
    const auto r = penetration(a, b);
    if (r.outcome != Outcome::initially_overlapping || r.stalled) continue;
    // The scale is below 4. The slack is doubled for the rounding of the coordinates.
    const double limit = 2 * 64 * double(kUnitRoundoff<S>) * 4, depth = double(r.upper);
    const Vec3<double> n = r.normal.template cast<double>(),
                       x = r.point_a.template cast<double>() - r.point_b.template cast<double>();
    EXPECT_NEAR(n.dot(x), depth, limit) << round;
    EXPECT_LE((x - n.dot(x) * n).norm(), std::sqrt(2 * depth * limit) + limit) << round;
  }
}

TYPED_TEST(Penetration, RunningOutIsSaidAndKeepsABracket) {
  using S = TypeParam;
  Draw draw{74};
  int stalls = 0;
  for (int round = 0; round < 100; ++round) {
    const Body<S> a{.shape = draw.hull<S>(60, 1)};
    const Body<S> b{.shape = draw.hull<S>(60, 1), .position = draw.vector<S>(0.3)};
    PenetrationOptions<S> options;
    options.max_iterations = 12;
    const PenetrationResult<S> r = penetration(a, b, options);
    stalls += r.stalled;
    check(a, b, r, kSlack, "budget", round);
    EXPECT_LE(r.counters.supports, 12 + 12 + 1) << "the first tetrahedron is outside the budget";
  }
  EXPECT_GT(stalls, 20);
}

TYPED_TEST(Penetration, AlongADirectionIsWhereTheLineLeaves) {
  using S = TypeParam;
  for (const Pairs pairs : {Pairs::hulls, Pairs::boxes, Pairs::lattice}) {
    Draw draw{75};
    int contacts = 0;
    for (int round = 0; round < 400; ++round) {
      const auto [a, b] = draw_pair<S>(draw, pairs, round);
      const Vec3<S> d = pairs == Pairs::lattice ? lattice_point<S>(draw, 2) : draw.vector<S>(1);
      if (d == Vec3<S>::Zero()) continue;
      const PenetrationResult<S> r = penetration_along(a, b, d);
      corpus::Case problem = case_of(a, b);
      problem.b.displacement = widened<S>(d);
      const oracle::LinearTruth truth(problem);
      const double limit = kSlack * double(kUnitRoundoff<S>) * truth.scale().high;
      const bool contact = truth.distance_at(0).high == 0;
      if (!contact) {
        EXPECT_TRUE(r.outcome == Outcome::miss || truth.distance_at(0).high <= limit) << round;
        continue;
      }
      if (r.outcome == Outcome::miss) {
        EXPECT_LE(oracle::LinearTruth(case_of(a, b)).depth().high, limit) << name(pairs) << ' ' << round;
        continue;
      }
      ASSERT_EQ(r.outcome, Outcome::initially_overlapping) << name(pairs) << ' ' << round;
      EXPECT_FALSE(r.stalled) << name(pairs) << ' ' << round;
      ++contacts;
      // Both ends are near the boundary of C: not outside it by more than the limit, nor inside it.
      const double t_lower = double(r.lower) / widened<S>(d).norm(),
                   t_upper = double(r.upper) / widened<S>(d).norm();
      EXPECT_LE(truth.distance_at(t_lower).high, limit) << name(pairs) << ' ' << round;
      EXPECT_LE(truth.distance_at(t_upper).high, 4 * limit) << name(pairs) << ' ' << round;
      corpus::Case beyond = problem;
      beyond.b.displacement = Vec3<double>::Zero();
      beyond.b.position += widened<S>(d) * t_upper;
      const oracle::LinearTruth there(beyond);
      const double left = there.outcome() == Outcome::miss ? 0 : there.depth().high;
      EXPECT_LE(left, limit + 4e-16) << name(pairs) << ' ' << round;
      EXPECT_GE(r.normal.dot(d), -limit) << name(pairs) << ' ' << round;
      const Vec3<double> apart = widened<S>(r.point_a) - widened<S>(r.point_b);
      EXPECT_LE((apart - widened<S>(d) * t_lower).norm(), 4 * limit) << name(pairs) << ' ' << round;
    }
    EXPECT_GT(contacts, 100) << name(pairs);
  }
}

TEST(PenetrationDoor, BadInputIsRefused) {
  EXPECT_EQ(penetration<double>({.shape = Sphere<double>{-1}}, {}).invalid, Invalid::negative_extent);
  const Body<double> box{.shape = Box<double>{{1, 1, 1}}};
  EXPECT_EQ(penetration_along(box, box, Vec3<double>(0, 0, 0)).invalid, Invalid::out_of_range);
  EXPECT_EQ(penetration_along(box, box, Vec3<double>(0, NAN, 0)).invalid, Invalid::not_finite);
  EXPECT_EQ(penetration(box, box, {.max_iterations = 0}).invalid, Invalid::bad_tolerance);
  EXPECT_EQ(penetration(box, box, {.request = Request::verdict}).normal.norm(), 0);
}

}  // namespace
}  // namespace graze
