// The third judge: CGAL's Minkowski sum of Nef polyhedra has the hull's extreme points, and the same line
// interval.
#include "oracles/polytope/nef_minkowski.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/exact_cso.hpp"
#include "oracles/polytope/linear_program.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

RationalPoint difference(const RationalPoint& l, const RationalPoint& r) {
  return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

TEST(NefSum, HasTheExtremePointsOfTheHullOfDifferencesAndItsLineInterval) {
  SmallPairs pairs(3);
  int judged = 0, hits = 0, misses = 0, flat_bodies = 0;
  while (judged < 150) {
    corpus::Case problem = judged < 50 ? pairs.pair() : pairs.composed_pair();
    if (judged < 50) {
      problem.a.shape = pairs.shape(3);
      problem.b.shape = pairs.hull(3, pairs.random.integer(4, 6), 3);
    }
    if (exact_body(problem.a).vertices.size() * exact_body(problem.b).vertices.size() > 100) continue;
    problem.t_max = 4;
    std::optional<NefCso> sum;
    try {
      sum = nef_cso(problem);
    } catch (const std::invalid_argument&) {
      continue;  // a flat CSO was drawn
    }
    ++judged;
    const auto is_flat = [](const Shape<double>& shape) {
      return std::holds_alternative<Segment<double>>(shape) ||
             std::holds_alternative<Triangle<double>>(shape);
    };
    flat_bodies += is_flat(problem.a.shape) || is_flat(problem.b.shape);
    // Each extreme point of the sum is a difference of vertices, and each difference lies in the sum's
    // half-spaces.
    const ExactBody a = exact_body(problem.a), b = exact_body(problem.b);
    std::set<RationalPoint> differences;
    for (const RationalPoint& p : a.vertices) {
      for (const RationalPoint& q : b.vertices) differences.insert(difference(p, q));
    }
    for (const RationalPoint& p : sum->vertices) ASSERT_EQ(differences.count(p), 1u);
    for (const NefCso::HalfSpace& h : sum->half_spaces) {
      int on_it = 0;
      for (const RationalPoint& p : differences) {
        const Rational reach = h.normal[0] * p[0] + h.normal[1] * p[1] + h.normal[2] * p[2];
        ASSERT_LE(reach, h.offset);
        on_it += reach == h.offset;
      }
      ASSERT_GE(on_it, 3);
    }
    const RationalPoint v = difference(b.displacement, a.displacement);
    if (v == RationalPoint{0, 0, 0}) continue;
    const LinearTruth truth(problem);
    const auto interval = sum->clip(v);
    const auto contact = truth.contact_interval();
    ASSERT_EQ(interval.has_value(), contact.has_value());
    if (interval) {
      ASSERT_EQ(nearest_double(interval->first), contact->t_in);
      ASSERT_EQ(nearest_double(interval->second), contact->t_out);
    }
    if (truth.outcome() == Outcome::hit) {
      ++hits;
      ASSERT_EQ(interval->first.get_str(), truth.toi_exact());
      ASSERT_EQ(toi_by_linear_program(problem).value(), interval->first);
    }
    if (truth.outcome() == Outcome::miss) {
      ++misses;
      ASSERT_TRUE(!interval || sgn(interval->second) < 0 || interval->first > Rational(problem.t_max));
    }
  }
  EXPECT_GE(hits, 10);
  EXPECT_GE(misses, 5);
  EXPECT_GE(flat_bodies, 20);
}

// A sum as one body has the extreme points of the Nef sum of its parts: A + B = A - (-B).
TEST(NefSum, OfTheNegatedPartIsTheSumsBody) {
  SmallPairs pairs(61);
  int judged = 0;
  while (judged < 30) {
    const Hull<double> first = pairs.hull(3, 5, 2), second = pairs.hull(pairs.random.integer(1, 3), 5, 2);
    std::vector<Vec> negated;
    for (const Vec& x : second.vertices()) negated.push_back(-x);
    corpus::Case problem;
    problem.a.shape = first;
    problem.b.shape = Hull<double>(negated);
    std::optional<NefCso> nef;
    try {
      nef = nef_cso(problem);
    } catch (const std::invalid_argument&) {
      continue;  // flat
    }
    ++judged;
    std::vector<IntVec> points;
    for (const RationalPoint& p : exact_body({.shape = sum<double>(first, second)}).vertices) {
      points.push_back({p[0].get_num(), p[1].get_num(), p[2].get_num()});
    }
    const ConvexHull hull = convex_hull(points);
    for (const RationalPoint& p : nef->vertices) {
      const IntVec extreme{p[0].get_num(), p[1].get_num(), p[2].get_num()};
      ASSERT_NE(std::find(hull.vertices.begin(), hull.vertices.end(), extreme), hull.vertices.end());
    }
    for (const NefCso::HalfSpace& h : nef->half_spaces) {
      for (const IntVec& p : points) {
        ASSERT_LE(h.normal[0] * p.x + h.normal[1] * p.y + h.normal[2] * p.z, h.offset);
      }
    }
  }
}

TEST(NefSum, RefusesAFlatCsoAndRoundedBodies) {
  corpus::Case problem;
  problem.a.shape = Segment<double>{Vec(0, 0, 0), Vec(1, 0, 0)};
  problem.b.shape = Segment<double>{Vec(0, 0, 0), Vec(0, 1, 0)};
  EXPECT_THROW((void)nef_cso(problem), std::invalid_argument);
  problem.b.shape = Segment<double>{Vec(0, 0, 0), Vec(2, 0, 0)};  // parallel: CGAL's own sum crashes
  EXPECT_THROW((void)nef_cso(problem), std::invalid_argument);
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Sphere<double>{1};
  EXPECT_THROW((void)nef_cso(problem), std::invalid_argument);
}

}  // namespace
}  // namespace graze::oracle
