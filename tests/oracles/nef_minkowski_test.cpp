// The third judge: CGAL's Minkowski sum of Nef polyhedra has the hull's extreme points, and the same line
// interval.
#include "oracles/nef_minkowski.hpp"

#include <gtest/gtest.h>

#include <set>

#include "oracles/exact_body.hpp"
#include "oracles/exact_cso.hpp"
#include "oracles/linear_program.hpp"
#include "oracles/linear_truth.hpp"
#include "tests/oracles/small_pairs.hpp"

namespace graze::oracle {
namespace {

RationalPoint difference(const RationalPoint& l, const RationalPoint& r) {
  return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

TEST(NefSum, HasTheExtremePointsOfTheHullOfDifferencesAndItsLineInterval) {
  SmallPairs pairs(3);
  int judged = 0, hits = 0, misses = 0;
  while (judged < 50) {
    corpus::Case problem = pairs.pair();
    problem.a.shape = pairs.shape(3);
    problem.b.shape = pairs.hull(3, pairs.random.integer(4, 6), 3);
    problem.t_max = 4;
    std::optional<NefCso> sum;
    try {
      sum = nef_cso(problem);
    } catch (const std::invalid_argument&) {
      continue;  // a flat hull was drawn
    }
    ++judged;
    // Each extreme point of the sum is a difference of vertices; each difference lies in the sum's
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
}

}  // namespace
}  // namespace graze::oracle
