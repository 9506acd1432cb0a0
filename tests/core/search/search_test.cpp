// Parts of the searches by themselves: what they hand on where they stop, what they say of a miss, what they
// keep in order, and what they count.
#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <graze/detail/queries/penetration_query.hpp>
#include <graze/detail/search/robust/advancement.hpp>

#include <graze/cast.hpp>
#include <graze/detail/search/robust/epa.hpp>
#include <graze/detail/search/robust/leaving.hpp>
#include <graze/penetration.hpp>
#include <memory>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

constexpr double kU = kUnitRoundoff<double>;

TEST(SearchParts, NothingIsCountedBeforeItIsDone) {
  const Counters c;
  EXPECT_EQ(c.iterations, 0);
  EXPECT_EQ(c.supports, 0);
  EXPECT_EQ(c.gjk_iterations, 0);
  EXPECT_EQ(c.portal_steps, 0);
  EXPECT_EQ(c.exact_decisions, 0);
  EXPECT_EQ(c.poses, 0);
}

TEST(SearchParts, WhatIsCountedAddsUp) {
  Counters sum{.iterations = 1,
               .supports = 2,
               .gjk_iterations = 3,
               .portal_steps = 4,
               .exact_decisions = 5,
               .poses = 6};
  sum += Counters{.iterations = 10,
                  .supports = 20,
                  .gjk_iterations = 30,
                  .portal_steps = 40,
                  .exact_decisions = 50,
                  .poses = 60};
  EXPECT_EQ(sum.iterations, 11);
  EXPECT_EQ(sum.supports, 22);
  EXPECT_EQ(sum.gjk_iterations, 33);
  EXPECT_EQ(sum.portal_steps, 44);
  EXPECT_EQ(sum.exact_decisions, 55);
  EXPECT_EQ(sum.poses, 66);
}

// Also where a body is let in by a look at its bits alone.
TEST(SearchParts, AQuaternionOfZeroIsRefusedWhateverTheShape) {
  Draw draw{220};
  const Shape<double> shapes[] = {Point<double>{}, Segment<double>{{0, 0, 0}, {1, 0, 0}}, Sphere<double>{1},
                                  Box<double>{{1, 1, 1}}, draw.hull<double>(8, 1)};
  for (const Shape<double>& shape : shapes) {
    const Body<double> none{.shape = shape, .orientation = {0, 0, 0, 0}}, one{.shape = shape};
    EXPECT_EQ(cast(none, one).invalid, Invalid::zero_quaternion) << shape.index();
    EXPECT_EQ(cast(one, none).invalid, Invalid::zero_quaternion) << shape.index();
    EXPECT_EQ(cast(one, one).invalid, Invalid::none) << shape.index();
  }
}

// --- where a search by distance may stop

// A ray cast that is in contact where the clip lets it begin keeps the clip's axis.
TEST(SearchParts, ARayCastThatEndsWhereItBeginsKeepsItsAxis) {
  const Body<double> a{.shape = Box<double>{{1, 1, 1}}};
  const Body<double> b{.shape = Box<double>{{1, 1, 1}}, .position = {4, 0, 0}, .displacement = {-4, 0, 0}};
  const detail::Cso<double> cso(a, b);
  const auto limits = detail::sweep_limits(cso, CastOptions<double>{});
  Counters counters;
  const V axis(1, 0, 0);
  const auto sweep = detail::gjk_ray_cast(cso, limits, cso.to_parameter(0.5), axis, counters);
  EXPECT_EQ(sweep.outcome, Outcome::hit);
  EXPECT_EQ(sweep.n, axis);
}

// --- hulls

TEST(SearchParts, AHullKnowsTheRangeOfItsNumbers) {
  const std::vector<V> small = {V(0x1p-40, 0, 0), V(0, -0x1p-30, 0), V(0, 0, 0x1p-50)};
  const Hull<double> hull{std::span<const V>(small)};
  EXPECT_EQ(hull.largest(), 0x1p-30);
  EXPECT_EQ(hull.smallest_nonzero(), 0x1p-50);
}

// Heights are compared relative to a point near the middle of the bounds, along every axis.
TEST(SearchParts, HeightsAreComparedAboutTheMiddle) {
  std::vector<V> far;
  for (const double x : {0.0, 2.0}) far.push_back(V(x, 2 * x, -4 * x));
  const Hull<double> hull{std::span<const V>(far)};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(hull.choice_scan(i)[0], -hull.choice_scan(i)[1]) << i;
}

// --- EPA

// Neighbours of the polytope's faces are each other's, whatever faces go and are moved in memory.
TEST(SearchParts, FacesOfEpaKeepTheirNeighbours) {
  Draw draw{221};
  int removed = 0;
  for (int round = 0; round < 20; ++round) {
    const auto corner = [](const V& w) {
      detail::CsoPoint<double> p;
      p.w = w;
      return p;
    };
    auto p = std::make_unique<detail::EpaPolytope<double>>();
    ASSERT_TRUE(
        p->start({corner(V(1, 1, 1)), corner(V(1, -1, -1)), corner(V(-1, 1, -1)), corner(V(-1, -1, 1))}));
    for (int step = 0; step < 40; ++step) {
      const V n = unit(draw.vector<double>(1));
      // Beyond the face that looks along n most, so far out that it sees others.
      std::size_t seen = 0;
      double most = -2;
      for (std::size_t f = 0; f < p->faces(); ++f) {
        if (p->face(f).alive && p->face(f).n.dot(n) > most) {
          most = p->face(f).n.dot(n);
          seen = f;
        }
      }
      const std::size_t before = p->faces();
      const V w = (2 + step) * p->face(seen).n;
      if (!p->add(corner(w), seen, 0.0)) continue;
      removed += p->faces() <= before ? 1 : 0;
      for (std::size_t f = 0; f < p->faces(); ++f) {
        const auto& face = p->face(f);
        if (!face.alive) continue;  // its slot waits for another face
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_LT(face.across[k], p->faces());
          const auto& beyond = p->face(face.across[k]);
          ASSERT_TRUE(beyond.alive);
          bool shared = false;
          for (std::size_t m = 0; m < 3; ++m) {
            shared = shared || (beyond.across[m] == f && beyond.v[m] == face.v[(k + 1) % 3] &&
                                beyond.v[(m + 1) % 3] == face.v[k]);
          }
          ASSERT_TRUE(shared) << round << ' ' << step << ' ' << f << ' ' << k;
        }
      }
    }
  }
  EXPECT_GT(removed, 20);
}

TEST(SearchParts, RefiningAnAxisCountsItsSupports) {
  const Body<double> a{.shape = Ellipsoid<double>{{1, 0.5, 0.25}}};
  const Body<double> b{.shape = Ellipsoid<double>{{0.5, 1, 0.75}}, .position = {3, 1, 0.5}};
  const detail::Cso<double> cso(a, b);
  detail::Simplex<double> simplex;
  simplex.add(cso.support(V(-1, 0, 0)));
  detail::Distance<double> d;
  d.upper = 4;
  d.lower = 0;
  Counters counters;
  detail::refine_axis(cso, simplex, d, 0.0, counters);
  EXPECT_GT(counters.supports, 0);
  EXPECT_LE(counters.supports, 16);
}

// --- portals

// The weights of a portal's own point put it on the line, as near as rounding can: twice refined.
TEST(SearchParts, ThePortalsPointIsOnTheLine) {
  Draw draw{222};
  for (int round = 0; round < 500; ++round) {
    detail::Portal<double> portal;
    portal.size = 3;
    // Corners at thirds of a turn about the line, near and far.
    const double angle = draw.between(0, 6);
    for (std::size_t i = 0; i < 3; ++i) {
      const double far = std::exp2(draw.between(-12, 0)), at = angle + 2.0943951 * static_cast<double>(i);
      portal.p[i].q = {far * std::cos(at), far * std::sin(at), draw.between(-1, 1)};
    }
    const auto l = detail::portal_weights(portal);
    EXPECT_NEAR(l[0] + l[1] + l[2], 1, 3 * kU);  // each weight rounded once
    double x = 0, y = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      x += l[i] * portal.p[i].q[0];
      y += l[i] * portal.p[i].q[1];
      size += l[i] * portal.p[i].q.head<2>().norm();
    }
    EXPECT_LE(std::hypot(x, y), 8 * kU * size) << round;
  }
}

// --- starts that leave

// The origin a little inside of a disk's rim, seen along the disk's axis: nearer to the rim than the noise
// is on the silhouette, anything else is not.
TEST(SearchParts, ASilhouetteIsFoundFromEverySide) {
  const double noise = 0x1p-20;
  for (int k = 0; k < 64; ++k) {
    const double angle = 0.1 * k;
    for (const double depth : {noise / 4, 4 * noise}) {
      const double from_middle = 1 - depth;
      const Body<double> a{.shape = Cylinder<double>{1, 1}};
      const Body<double> b{.shape = Point<double>{},
                           .position = {from_middle * std::cos(angle), from_middle * std::sin(angle), 0},
                           .displacement = {0, 0, 1}};
      const detail::Cso<double> cso(a, b);
      Counters counters;
      const detail::Frame<double> frame(cso.direction());
      const detail::PortalView<double> view{cso, frame, 1.0, counters};
      const double unit = power_of_two(-cso.length_exponent());
      EXPECT_EQ(detail::on_silhouette(view, unit * noise), depth < noise) << k << ' ' << depth;
    }
  }
}

// For a start whose motion enters the body, a search cut short claims neither that it enters nor that it does
// not.
TEST(SearchParts, ASpentBudgetLeavesAStartOpen) {
  Draw draw{227};
  int open = 0;
  for (int round = 0; round < 3000; ++round) {
    const Body<double> a{.shape = draw.hull<double>(30, 1)};
    const Body<double> b{.shape = draw.hull<double>(30, 1),
                         .position = draw.vector<double>(2),
                         .displacement = draw.vector<double>(1)};
    const detail::Cso<double> cso(a, b);
    auto limits = detail::sweep_limits(cso, CastOptions<double>{});
    Counters counters;
    if (detail::mpr_overlap(cso, limits, counters).outcome != Outcome::initially_overlapping) continue;
    if (detail::start_of(cso, limits, counters) != detail::Start::enters) continue;
    for (limits.budget = 1; limits.budget < 6; ++limits.budget) {
      Counters spent;
      const detail::Start start = detail::start_of(cso, limits, spent);
      EXPECT_NE(start, detail::Start::leaves) << round << ' ' << limits.budget;
      // Open for certain where not even a portal is found, seen from behind.
      const detail::Frame<double> frame(cso.direction());
      const detail::PortalView<double> view{cso, frame, -1.0, spent};
      if (detail::find_portal(view, limits.budget).state != detail::PortalSearch<double>::State::exhausted)
        continue;
      EXPECT_EQ(start, detail::Start::open) << round << ' ' << limits.budget;
      ++open;
    }
  }
  EXPECT_GT(open, 10);
}

// --- proofs of standard answers

// How many of a hundred casts hit, each of which it proves from both sides, to within `slack` of its times.
template <class Pair>
int proved_hits(std::uint64_t seed, const Pair& pair, const CastOptions<double>& options, double slack) {
  Draw draw{seed};
  int hits = 0;
  for (int round = 0; round < 100; ++round) {
    const auto [a, b] = pair(draw);
    const auto r = cast(a, b, options);
    if (r.outcome != Outcome::hit) continue;
    ++hits;
    EXPECT_TRUE(r.proof.has_value()) << round;
    if (!r.proof) continue;
    EXPECT_LE(r.proof->toi_upper - r.toi_upper, slack) << round;
    EXPECT_LE(r.toi_lower - r.proof->toi_lower, slack) << round;
  }
  return hits;
}

// The guarantee grants 64 u of the scale to the bracket, and as much to the proof. The scale is below 8, the
// speed above 8.
TEST(SearchParts, AHitOfPolytopesIsProvedFromBothSides) {
  const auto pair = [](Draw& draw) {
    const Body<double> a{.shape = draw.hull<double>(12, 1)};
    const Body<double> b{.shape = draw.hull<double>(12, 1),
                         .position = {5, 0.25, 0},
                         .displacement = draw.vector<double>(1) - V(9, 0, 0)};
    return std::pair(a, b);
  };
  EXPECT_GT(proved_hits(223, pair, {.request = Request::everything}, 2 * 64 * kU), 50);
}

// Rounded ones, whose portals are proved by a filter alone.
TEST(SearchParts, AHitOfRoundedPolytopesIsProvedFromBothSides) {
  const auto pair = [](Draw& draw) {
    const Body<double> a{.shape = rounded<double>(draw.hull<double>(12, 1), 0.25)};
    const Body<double> b{.shape = Sphere<double>{0.5},
                         .position = {5, 0.25, 0},
                         .displacement = draw.vector<double>(1) - V(9, 0, 0)};
    return std::pair(a, b);
  };
  EXPECT_GT(proved_hits(224, pair, {.method = Method::mpr_sweep, .request = Request::everything}, 1e-12), 50);
}

// A path between where float and where double has the top of a hull: each verdict is double's.
TEST(SearchParts, AGrazeBetweenFloatAndDoubleIsDecidedInDouble) {
  Draw draw{225};
  int hits = 0, misses = 0;
  for (int round = 0; round < 400; ++round) {
    // Every corner twice, 1e-9 apart: float cannot tell which is farther out.
    std::vector<V> points;
    for (int i = 0; i < 24; ++i) {
      const V x = unit(draw.vector<double>(1));
      points.push_back(x);
      points.push_back(x * (1 + 1e-9));
    }
    const Body<double> a{.shape = Hull<double>{std::span<const V>(points)}};
    // Past the corner that is highest along n, between the two.
    const V n = unit(draw.vector<double>(1));
    double top = -2;
    V corner = V::Zero();
    for (const V& x : points) {
      if (n.dot(x) > top) {
        top = n.dot(x);
        corner = x;
      }
    }
    const V along = unit(V(n.cross(draw.vector<double>(1))));
    const V middle = corner + ((round % 2 ? -0.5e-9 : 0.5e-9)) * n;
    const Body<double> b{.shape = Point<double>{}, .position = middle - 3 * along, .displacement = 6 * along};
    const auto sure = cast(a, b, {.tier = Tier::exact});
    ASSERT_NE(sure.outcome, Outcome::invalid_input);
    EXPECT_EQ(cast(a, b).outcome, sure.outcome) << round;
    hits += sure.outcome == Outcome::hit;
    misses += sure.outcome == Outcome::miss;
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(misses, 50);
}

// Every step of the quick walk, of discovery and of refinement, evaluates one support point. Two come before
// them, and one in double comes at the end.
TEST(SearchParts, PortalStepsAreCountedAsSupportsAre) {
  Draw draw{226};
  int long_walks = 0;
  for (int round = 0; round < 50; ++round) {
    std::vector<V> points;
    points.reserve(200);
    for (int i = 0; i < 200; ++i) points.push_back(unit(draw.vector<double>(1)));
    const Body<double> a{.shape = Hull<double>{std::span<const V>(points)}};
    const Body<double> b{.shape = Point<double>{}, .position = {3, 0.25, 0.125}, .displacement = {-6, 0, 0}};
    const auto r = cast(a, b, {.method = Method::mpr_sweep, .request = Request::verdict});
    ASSERT_EQ(r.outcome, Outcome::hit);
    EXPECT_LE(r.counters.supports, r.counters.portal_steps + 3) << round;
    long_walks += r.counters.supports > 6;
  }
  EXPECT_GT(long_walks, 10);
}

}  // namespace
}  // namespace graze
