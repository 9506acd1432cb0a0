#include <gtest/gtest.h>
#include <graze/detail/pairs/cso.hpp>
#include <graze/distance.hpp>
#include <graze/swept_overlap.hpp>

#include "tests/shared/query_truth.hpp"

namespace graze {
namespace {

using namespace test;

constexpr SweptMethod kMethods[] = {SweptMethod::gjk, SweptMethod::mpr, SweptMethod::before_after};

template <class S>
class SweptOverlap : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SweptOverlap, Scalars);

// Over u scale: a verdict may be wrong where clearance or depth is below it.
constexpr double kSlack = 64;

TYPED_TEST(SweptOverlap, TheVerdictIsTheExactOne) {
  using S = TypeParam;
  for (const Pairs pairs : kPairs) {
    Draw draw{91};
    int hits = 0, misses = 0;
    for (int round = 0; round < 300; ++round) {
      auto [a, b] = draw_pair<S>(draw, pairs, round);
      const bool whole = pairs == Pairs::lattice || pairs == Pairs::flat;
      b.position = whole ? lattice_point<S>(draw, 4) : draw.vector<S>(3);
      // At A, or a little beside it.
      b.displacement = S(-2) * b.position + (whole ? lattice_point<S>(draw, 3) : draw.vector<S>(3));
      SweptOverlapOptions<S> options;
      corpus::Case problem = case_of(a, b);
      if (round % 5 == 0) options.t_max = kInfinity<S>;
      if (round % 5 == 1) options.t_max = 40;  // far beyond C
      problem.t_max = double(options.t_max);
      const oracle::LinearTruth truth(problem);
      const double limit = kSlack * double(kUnitRoundoff<S>) * truth.scale().high;
      const bool contact = truth.outcome() != Outcome::miss;
      if ((contact ? truth.depth() : truth.clearance()).high <= limit) continue;
      (contact ? hits : misses)++;
      for (const SweptMethod method : kMethods) {
        options.method = method;
        const SweptOverlapResult<S> r = swept_overlap(a, b, options);
        ASSERT_EQ(r.outcome, contact ? Outcome::hit : Outcome::miss)
            << name(pairs) << ' ' << round << ' ' << static_cast<int>(method);
        if (contact) continue;
        // The axis separates: C at t = 0 and at the end of the path lies on the far side of 0.
        const detail::Cso<S> cso(a, b);
        const Vec3<S> n = r.normal;
        EXPECT_NEAR(n.norm(), 1, 8 * kUnitRoundoff<S>);
        const double slack = 64 * double(kUnitRoundoff<S>) * double(cso.scale());
        const double h = double(n.dot(cso.support(n).w)) + double(cso.radius());
        EXPECT_LT(h, slack) << name(pairs) << ' ' << round << ' ' << static_cast<int>(method);
        if (!(options.t_max < kInfinity<S>)) {
          EXPECT_GT(double(n.dot(cso.direction())), -slack) << name(pairs) << ' ' << round;
        } else {
          const double s = double(cso.to_parameter(options.t_max)), end = s * double(n.dot(cso.direction()));
          EXPECT_LT(h - end, slack * std::max(s, 1.0))
              << name(pairs) << ' ' << round << ' ' << static_cast<int>(method);
        }
      }
    }
    EXPECT_GT(hits, 30) << name(pairs);
    EXPECT_GT(misses, 30) << name(pairs);
  }
}

TYPED_TEST(SweptOverlap, ABulletThroughPaperIsSeen) {
  using S = TypeParam;
  // Thinner than the step by 1e6: sampling the ends, or the middle, sees nothing.
  const Body<S> paper{.shape = Box<S>{{1, 1, S(1e-6)}}};
  Body<S> bullet{.shape = Sphere<S>{S(1e-3)}, .position = {0, 0, S(-1.7)}, .displacement = {0, 0, 3}};
  for (const SweptMethod method : kMethods) {
    SweptOverlapOptions<S> options;
    options.method = method;
    bullet.position[0] = 0;
    EXPECT_EQ(swept_overlap(paper, bullet, options).outcome, Outcome::hit);
    options.t_max = S(0.25);
    EXPECT_EQ(swept_overlap(paper, bullet, options).outcome, Outcome::miss) << "the path ends before";
    options.t_max = 1;
    bullet.position[0] = S(1.125);
    EXPECT_EQ(swept_overlap(paper, bullet, options).outcome, Outcome::miss) << "beside";
    options.target_distance = S(0.25);
    EXPECT_EQ(swept_overlap(paper, bullet, options).outcome, Outcome::hit);
  }
}

TYPED_TEST(SweptOverlap, TouchingAtTheLastMomentAndSlidingCount) {
  using S = TypeParam;
  const Body<S> box{.shape = Box<S>{{1, 1, 1}}};
  for (const SweptMethod method : kMethods) {
    SweptOverlapOptions<S> options;
    options.method = method;
    const Body<S> arrives{.shape = Box<S>{{1, 1, 1}}, .position = {5, 0, 0}, .displacement = {-3, 0, 0}};
    EXPECT_EQ(swept_overlap(box, arrives, options).outcome, Outcome::hit);
    const Body<S> slides{.shape = Box<S>{{1, 1, 1}}, .position = {5, 2, 0}, .displacement = {-8, 0, 0}};
    EXPECT_EQ(swept_overlap(box, slides, options).outcome, Outcome::hit);
    const Body<S> leaves{.shape = Box<S>{{1, 1, 1}}, .position = {2, 0, 0}, .displacement = {8, 0, 0}};
    EXPECT_EQ(swept_overlap(box, leaves, options).outcome, Outcome::hit);
    const Body<S> rests{.shape = Box<S>{{1, 1, 1}}, .position = {3, 0, 0}};
    EXPECT_EQ(swept_overlap(box, rests, options).outcome, Outcome::miss);
  }
}

// The search ends its path where A is left behind, but the axis of a miss must separate the bodies for all of
// it.
TYPED_TEST(SweptOverlap, TheAxisOfAMissPartsTheBodiesToTheEnd) {
  using S = TypeParam;
  const double u = kUnitRoundoff<S>;
  Draw draw{94};
  int misses = 0;
  for (int round = 0; round < 400; ++round) {
    const Body<S> a{.shape = Ellipsoid<S>{{1, S(0.5), S(0.25)}}, .orientation = draw.turn<S>()};
    const Body<S> b{.shape = sum<S>(Box<S>{{1, S(0.25), S(0.125)}}, Segment<S>{{0, 0, 0}, {1, 0, 0}}),
                    .position = draw.vector<S>(4),
                    .orientation = draw.turn<S>(),
                    .displacement = draw.vector<S>(4)};
    for (const SweptMethod method : kMethods) {
      for (const S t_max : {S(1), S(1e4), kInfinity<S>}) {
        const auto r = swept_overlap(a, b, SweptOverlapOptions<S>{.method = method, .t_max = t_max});
        if (r.outcome != Outcome::miss) continue;
        ++misses;
        const double rate = r.normal.template cast<double>().dot(b.displacement.template cast<double>());
        const double gap = distance(a, b).upper;  // an upper bound of the gap along any axis
        if (t_max == kInfinity<S>) {
          EXPECT_GE(rate, -16 * u * double(b.displacement.norm()))
              << round << ' ' << static_cast<int>(method);
        } else {
          EXPECT_GE(gap + double(t_max) * rate,
                    -256 * u * (8 + double(t_max) * double(b.displacement.norm())))
              << round << ' ' << static_cast<int>(method);
        }
      }
    }
  }
  EXPECT_GT(misses, 400);
}

TEST(SweptOverlapCost, BeforeAndAfterIsTheSumWithTwiceTheScan) {
  // The same supports: what differs is the work in each (bench/queries_bench.cpp).
  Draw draw{92};
  int of_sum = 0, of_both = 0;
  for (int round = 0; round < 100; ++round) {
    const Body<double> a{.shape = draw.hull<double>(30, 1)};
    const Body<double> b{.shape = draw.hull<double>(30, 1),
                         .position = draw.vector<double>(3),
                         .displacement = draw.vector<double>(3)};
    const auto sum = swept_overlap(a, b), both = swept_overlap_before_after(a, b);
    EXPECT_EQ(sum.outcome, both.outcome);
    of_sum += sum.counters.supports;
    of_both += both.counters.supports;
  }
  EXPECT_NEAR(double(of_both) / of_sum, 1, 0.05);  // except for ties between the two ends
}

TEST(SweptOverlapDoor, BadInputIsRefused) {
  EXPECT_EQ(swept_overlap<double>({.shape = Hull<double>()}, {}).invalid, Invalid::empty_hull);
  EXPECT_EQ(swept_overlap<double>({}, {}, {.t_max = -1}).invalid, Invalid::bad_horizon);
  EXPECT_EQ(swept_overlap_before_after<double>({}, {}, {.t_max = NAN}).outcome, Outcome::invalid_input);
}

}  // namespace
}  // namespace graze
