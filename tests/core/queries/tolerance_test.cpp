// Distance and penetration to a tolerance of the caller's. The bracket is as narrow as requested, holds the
// closed answer, and costs less than the narrowest one. The depth of rounded bodies whose cores are apart.
#include <gtest/gtest.h>

#include <graze/distance.hpp>
#include <graze/penetration.hpp>

#include "tests/shared/turning_bodies.hpp"

namespace graze {
namespace {

using test::Draw;

TEST(QueryTolerance, DistanceIsBracketedAsNarrowlyAsAsked) {
  Draw draw{51};
  int cheaper = 0, apart = 0;
  for (int round = 0; round < 200; ++round) {
    const Body<double> a{.shape = Ellipsoid<double>{{draw.between(0.1, 1), draw.between(0.1, 1), 0.5}}};
    const Body<double> b{.shape = Ellipsoid<double>{{0.25, draw.between(0.1, 1), draw.between(0.1, 1)}},
                         .position = draw.vector<double>(4),
                         .orientation = draw.turn<double>()};
    const auto best = distance(a, b, {.request = Request::everything});
    if (!(best.upper > 0)) continue;
    ++apart;
    int before = 0;
    for (const double tolerance : {1e-9, 1e-6, 1e-3}) {
      const auto r = distance(a, b, {.request = Request::everything, .tolerance = tolerance});
      // Scale is below 10: the boxes' centres are at most 7 apart.
      EXPECT_LE(r.upper - r.lower, 10 * tolerance);
      EXPECT_LE(r.lower, best.upper);
      EXPECT_GE(r.upper, best.lower);
      cheaper += r.counters.supports < before;
      before = r.counters.supports;
    }
  }
  EXPECT_GE(apart, 150);
  EXPECT_GE(cheaper, apart);
}

// However wide the bracket, the points are as far apart as its upper end. This also holds where the axis,
// which a tolerance or the rounding of a small distance leaves tilted, is not the way from one point to the
// other.
TEST(QueryTolerance, TheClosestPointsAreAsFarApartAsUpper) {
  Draw draw{54};
  int tilted = 0;
  for (int round = 0; round < 200; ++round) {
    const Body<double> a{.shape = Ellipsoid<double>{{1, 0.5, 0.25}}, .orientation = draw.turn<double>()};
    Body<double> b{.shape = rounded<double>(Ellipsoid<double>{{0.5, 1, 0.75}}, 0.5),
                   .position = draw.vector<double>(4),
                   .orientation = draw.turn<double>()};
    if (round % 2 == 0) {  // nearly in contact
      const auto apart = distance(a, b);
      b.position -= (apart.upper - 1e-12) * apart.normal;
    }
    for (const double tolerance : {0.0, 1e-6, 1e-3, 1e-1}) {
      const auto r = distance(a, b, {.tolerance = tolerance});
      if (!(r.lower > 0)) continue;
      EXPECT_NEAR((r.point_b - r.point_a).norm(), r.upper, 1e-13) << round << ' ' << tolerance;
      tilted += r.normal.dot(r.point_b - r.point_a) < r.upper - 1e-9;
    }
  }
  EXPECT_GT(tilted, 20);
}

// The depth of balls has a closed form, and their cores are points, apart.
TEST(QueryTolerance, PenetrationOfRoundedBodiesWithCoresApart) {
  Draw draw{52};
  for (int round = 0; round < 200; ++round) {
    const double radius = draw.between(0.5, 1);
    Body<double> a{.shape = rounded<double>(Ellipsoid<double>{{0.5, 0.5, 0.5}}, radius)}, b = a;
    b.position = unit(draw.vector<double>(1)) * draw.between(1.1, 1.9);
    b.orientation = draw.turn<double>();
    const double depth = 2 * (radius + 0.5) - b.position.norm();
    ASSERT_GT(depth, 0);
    for (const double tolerance : {0.0, 1e-4}) {
      const auto r = penetration(a, b, {.request = Request::everything, .tolerance = tolerance});
      ASSERT_EQ(r.outcome, Outcome::initially_overlapping);
      const double slack = 1e-12 + 10 * tolerance;  // scale below 10, roots of the ellipsoid's support
      EXPECT_LE(r.lower, depth + slack);
      EXPECT_GE(r.upper, depth - slack);
      EXPECT_LE(r.upper - r.lower, slack);
    }
  }
}

template <class S>
struct Twice {
  Body<S> a, b;
};

// Flat and slim ellipsoids in float: the axis is known to the root of the rounding only until it is refined.
TEST(QueryTolerance, RefinedAxesOfSmoothCoresApart) {
  Draw draw{53};
  int contacts = 0;
  for (int round = 0; round < 400; ++round) {
    const auto pair = [&]<class S>(S, Draw seeded) {
      Twice<S> out;
      const auto size = [&] { return static_cast<S>(seeded.between(0.05, 1)); };
      const S radius = static_cast<S>(seeded.between(0.25, 0.5));
      out.a.shape = rounded<S>(Ellipsoid<S>{{size(), size(), size()}}, radius);
      out.b.shape = rounded<S>(Cone<S>{size(), size()}, radius);
      out.b.position = seeded.template vector<S>(1.5);
      out.b.orientation = seeded.template turn<S>();
      return out;
    };
    const auto single = pair(0.0F, draw);
    const auto both = pair(0.0, draw);
    (void)draw.bits();
    const auto narrow = penetration(single.a, single.b, {.request = Request::everything});
    const auto wide = penetration(both.a, both.b, {.request = Request::everything});
    if (narrow.outcome != Outcome::initially_overlapping || wide.outcome != narrow.outcome) continue;
    ++contacts;
    // Inputs rounded to float: 2^-24 of scale, below 5 here, a few times over. The guarantee's kappa is 64.
    EXPECT_NEAR(narrow.upper, wide.upper, 64 * 0x1p-24 * 5);
  }
  EXPECT_GE(contacts, 150);
}

}  // namespace
}  // namespace graze
