// The hull of integer points does not depend on their size: of few bits and of many it is decided in different numbers.
#include "oracles/polytope/exact_cso.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace graze::oracle {
namespace {

// Differences of two sets: most faces of their hull are parallelograms, whose corners tie exactly.
std::vector<IntVec> differences(std::mt19937_64& random, int bits) {
  const auto number = [&] {
    Integer out = 0;
    for (int k = 0; k < bits; k += 16) out = (out << 16) + static_cast<long>(random() >> 48);
    return random() % 2 == 0 ? out : Integer(-out);
  };
  const auto points = [&](int count) {
    std::vector<IntVec> out;
    for (int i = 0; i < count; ++i) out.push_back({number(), number(), number()});
    return out;
  };
  std::vector<IntVec> out;
  const std::vector<IntVec> a = points(12), b = points(8);
  for (const IntVec& p : a) {
    for (const IntVec& q : b) out.push_back(p - q);
  }
  return out;
}

std::vector<IntVec> scaled(const std::vector<IntVec>& points, int shift) {
  std::vector<IntVec> out;
  for (const IntVec& p : points) out.push_back({p.x << shift, p.y << shift, p.z << shift});
  return out;
}

// The planes of its faces, each once, its normal without a common factor: which vertices come first, and how a
// parallelogram is cut in two, is the hull's affair.
std::set<std::pair<IntVec, Integer>> planes(const ConvexHull& hull, int shift) {
  std::set<std::pair<IntVec, Integer>> out;
  for (const HalfSpace& h : hull.half_spaces) {
    const Integer common = gcd(gcd(h.normal.x, h.normal.y), h.normal.z);
    const Integer offset = h.offset / common;
    EXPECT_EQ(offset * common, h.offset);
    EXPECT_EQ((offset >> shift) << shift, offset);
    out.emplace(IntVec{h.normal.x / common, h.normal.y / common, h.normal.z / common}, offset >> shift);
  }
  return out;
}

TEST(ExactCso, OfAnySizeTheHullIsTheSame) {
  std::mt19937_64 random(17);
  for (int round = 0; round < 8; ++round) {
    // Coordinates of 97 bits, of up to 160, which fit into the wide integers, of 161 and of 497.
    const std::vector<IntVec> points = differences(random, 96);
    const ConvexHull hull = convex_hull(points);
    ASSERT_EQ(hull.dimension, 3);
    const auto faces = planes(hull, 0);
    EXPECT_LT(faces.size(), hull.facets.size()) << "no parallelogram";
    for (const int shift : {61, 62, 63, 64, 400})
      EXPECT_EQ(planes(convex_hull(scaled(points, shift)), shift), faces) << shift;
    // No point lies beyond a face, and each face has three on it.
    for (const auto& [normal, offset] : faces) {
      int on = 0;
      for (const IntVec& p : points) {
        const Integer beyond = dot(normal, p) - offset;
        ASSERT_LE(sgn(beyond), 0);
        on += sgn(beyond) == 0 ? 1 : 0;
      }
      EXPECT_GE(on, 3);
    }
  }
}

TEST(ExactCso, OfABoxAboutTheOriginTheFacesAreSix) {
  std::vector<IntVec> points = {{0, 0, 0}};
  for (const long x : {-1, 0, 2}) {
    for (const long y : {-3, 0, 1}) {
      for (const long z : {-1, 0, 1}) points.push_back({x, y, z});
    }
  }
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.dimension, 3);
  EXPECT_EQ(planes(hull, 0).size(), 6U);
  for (const int shift : {0, 158, 200})
    EXPECT_EQ(planes(convex_hull(scaled(points, shift)), shift), planes(hull, 0));
}

}  // namespace
}  // namespace graze::oracle
