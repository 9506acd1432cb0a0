#include <gtest/gtest.h>
#include <graze/cast.hpp>

#include "tests/core/queries/brute_force_ray.hpp"
#include "tests/shared/globe.hpp"
#include "tests/shared/query_truth.hpp"

namespace graze {
namespace {

using namespace test;

template <class S>
class BruteRay : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BruteRay, Scalars);

template <class S>
BruteForceRay<S> ray(const Globe<S>& g, const Vec3<S>& origin, const Vec3<S>& direction, S t_max) {
  return brute_force_ray<S>(g.vertices, g.faces, origin, direction, t_max);
}

// The box as a globe of its own: 12 triangles.
template <class S>
Globe<S> box_faces() {
  Globe<S> out;
  for (std::uint32_t k = 0; k < 8; ++k) {
    out.vertices.push_back(Vec3<S>(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  }
  out.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
               {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return out;
}

TYPED_TEST(BruteRay, AgreesWithTheExactOracle) {
  using S = TypeParam;
  Draw draw{95};
  int hits = 0, misses = 0, inside = 0;
  for (int round = 0; round < 300; ++round) {
    const Globe<S> g = globe<S>(1 + round % 4, 3 + round % 5, 1);
    const Body<S> hull{.shape = Hull<S>(std::span<const Vec3<S>>(g.vertices))};
    const Body<S> point{.position = draw.vector<S>(1.2), .displacement = draw.vector<S>(2)};
    const BruteForceRay<S> r = ray<S>(g, point.position, point.displacement, 1);
    const oracle::LinearTruth truth(case_of(hull, point));
    const double limit = 64 * double(kUnitRoundoff<S>) * truth.scale().high;
    const bool contact = truth.outcome() != Outcome::miss;
    if ((contact ? truth.depth() : truth.clearance()).high <= limit) continue;
    ASSERT_EQ(r.hit, contact) << round;
    (contact ? hits : misses)++;
    inside += truth.outcome() == Outcome::initially_overlapping;
    if (contact) {
      EXPECT_LE(truth.backward_error(double(r.t)).low, limit) << round;
    }
  }
  EXPECT_GT(hits, 60);
  EXPECT_GT(misses, 60);
  EXPECT_GT(inside, 10);
}

// Rays through vertices and along edges: the two faces of an edge agree, whatever the rounding.
TYPED_TEST(BruteRay, SlipsThroughNoEdge) {
  using S = TypeParam;
  Draw draw{96};
  for (int round = 0; round < 100; ++round) {
    const Globe<S> g = globe<S>(1 + round % 4, 3 + round % 5, 1);
    for (const auto& face : g.faces) {
      const Vec3<S> origin = unit(draw.vector<S>(1)) * S(3);
      for (const S weight : {S(0), S(0.375), S(1)}) {
        const Vec3<S> through = weight * g.vertices[face[0]] + (1 - weight) * g.vertices[face[1]];
        // Aimed a little inside of the edge: 1e-5 of the way to the middle.
        const Vec3<S> direction = S(0.99999) * through - origin;
        EXPECT_TRUE(ray<S>(g, origin, direction, kInfinity<S>).hit) << round;
      }
    }
  }
}

TYPED_TEST(BruteRay, TheBoxOfTheLecture) {
  using S = TypeParam;
  const Globe<S> box = box_faces<S>();
  BruteForceRay<S> r = ray<S>(box, {-3, S(0.25), S(0.5)}, {4, 0, 0}, 1);
  ASSERT_TRUE(r.hit);
  EXPECT_EQ(r.t, S(0.5));
  EXPECT_TRUE(r.face == 8 || r.face == 9);
  EXPECT_FALSE(ray<S>(box, {-3, S(0.25), S(0.5)}, {S(1.5), 0, 0}, 1).hit) << "ends before";
  EXPECT_FALSE(ray<S>(box, {-3, S(0.25), S(0.5)}, {-4, 0, 0}, 1).hit) << "behind";
  EXPECT_EQ(ray<S>(box, {0, S(0.25), S(0.5)}, {4, 0, 0}, 1).t, 0) << "inside";
  EXPECT_FALSE(ray<S>(box, {0, 0, 0}, {0, 0, 0}, 1).hit) << "no direction, no line";
  EXPECT_FALSE(ray<S>(box, {0, 0, 0}, {S(NAN), 0, 0}, 1).hit);
}

TYPED_TEST(BruteRay, AgreesWithTheCasts) {
  using S = TypeParam;
  Draw draw{97};
  int hits = 0;
  const Globe<S> g = globe<S>(14, 17, 1);
  const Body<S> hull{.shape = Hull<S>(std::span<const Vec3<S>>(g.vertices))};
  for (int round = 0; round < 300; ++round) {
    Body<S> point{.position = unit(draw.vector<S>(1)) * S(3)};
    point.displacement = draw.vector<S>(0.9) - point.position;
    const BruteForceRay<S> r = ray<S>(g, point.position, point.displacement, 1);
    CastOptions<S> options;
    for (const Method method : {Method::gjk_ray_cast, Method::mpr_sweep}) {
      options.method = method;
      const CastResult<S> c = cast(hull, point, options);
      if (!r.hit) continue;
      ASSERT_EQ(c.outcome, Outcome::hit) << round;
      EXPECT_NEAR(c.toi_lower, r.t, 1024 * kUnitRoundoff<S>) << round;
    }
    hits += r.hit;
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace graze
