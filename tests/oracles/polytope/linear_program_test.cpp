// Two judges that share the posed vertices and nothing else give the same rationals.
#include "oracles/polytope/linear_program.hpp"

#include <gtest/gtest.h>

#include <map>

#include "corpus/families.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

// sign(distance at t - (r_A + r_B + m)), by the quadratic program
int distance_excess(const corpus::Case& problem, double t) {
  const Rational reach =
      exact_body(problem.a).radius + exact_body(problem.b).radius + Rational(problem.target_distance);
  return cmp(distance_sq_by_quadratic_program(problem, Rational(t)), Rational(reach * reach));
}

TEST(HullAndLinearProgram, GiveTheSameRationalTimeInEveryDimension) {
  constexpr int kCases = 2400;
  SmallPairs pairs(20260101);
  std::map<std::pair<int, Outcome>, int> seen;
  int rotated_hits = 0, grazes = 0, rays = 0, rational_hits = 0;
  for (int i = 0; i < kCases; ++i) {
    const corpus::Case problem = pairs.pair();
    const LinearTruth truth(problem);
    const std::optional<Rational> toi = toi_by_linear_program(problem);
    ASSERT_EQ(toi ? toi->get_str() : "", truth.toi_exact()) << "case " << i;
    if (!toi) {
      ASSERT_EQ(truth.outcome(), Outcome::miss) << "case " << i;
    } else {
      ASSERT_EQ(truth.outcome(), sgn(*toi) == 0 ? Outcome::initially_overlapping : Outcome::hit)
          << "case " << i;
      ASSERT_LE(Rational(truth.toi_lower()), *toi);
      ASSERT_GE(Rational(truth.toi_upper()), *toi);
      rational_hits += truth.toi_lower() < truth.toi_upper();
      ASSERT_TRUE(truth.toi_lower() == truth.toi_upper() ||
                  std::nextafter(truth.toi_lower(), kInfinity<double>) == truth.toi_upper());
    }
    ++seen[{truth.dimension(), truth.outcome()}];
    const bool hit = truth.outcome() == Outcome::hit;
    rotated_hits += hit && !problem.b.orientation.is_identity();
    grazes += hit && truth.dimension() == 3 && truth.depth().high == 0;
    rays += hit && std::isinf(problem.t_max);
  }
  for (int dimension = 0; dimension <= 3; ++dimension) {
    for (const Outcome outcome : {Outcome::initially_overlapping, Outcome::hit, Outcome::miss}) {
      EXPECT_GE((seen[{dimension, outcome}]), 10)
          << "dimension " << dimension << ", outcome " << int(outcome);
    }
  }
  EXPECT_GE(rotated_hits, 100);
  EXPECT_GE(grazes, 5);
  EXPECT_GE(rays, 50);
  EXPECT_GE(rational_hits, 100);
}

// The same for segments, triangles, posed shapes, sums, sweeps and hulls of them.
TEST(HullAndLinearProgram, GiveTheSameRationalTimeForCombinators) {
  constexpr int kCases = 600;
  SmallPairs pairs(20260303);
  std::map<std::pair<int, Outcome>, int> seen;
  std::map<std::size_t, int> kinds;
  for (int i = 0; i < kCases; ++i) {
    const corpus::Case problem = pairs.composed_pair();
    const LinearTruth truth(problem);
    const std::optional<Rational> toi = toi_by_linear_program(problem);
    ASSERT_EQ(toi ? toi->get_str() : "", truth.toi_exact()) << "case " << i;
    ASSERT_EQ(truth.outcome(), !toi             ? Outcome::miss
                               : sgn(*toi) == 0 ? Outcome::initially_overlapping
                                                : Outcome::hit)
        << "case " << i;
    ++seen[{truth.dimension(), truth.outcome()}];
    ++kinds[problem.a.shape.index()];
  }
  for (const Outcome outcome : {Outcome::initially_overlapping, Outcome::hit, Outcome::miss}) {
    EXPECT_GE((seen[{2, outcome}]), 10) << "flat, outcome " << int(outcome);
    EXPECT_GE((seen[{3, outcome}]), 40) << "solid, outcome " << int(outcome);
  }
  const auto drawn = [&](const Shape<double>& like) { return kinds[like.index()]; };
  EXPECT_GE(drawn(Segment<double>{}), 30);
  EXPECT_GE(drawn(Triangle<double>{}), 20);
  EXPECT_GE(drawn(Posed<double>{}), 20);
  EXPECT_GE(drawn(Rounded<double>{}), 20);
  EXPECT_GE(drawn(Sum<double>{}), 60);
  EXPECT_GE(drawn(HullOf<double>{}), 20);
}

TEST(HullAndQuadraticProgram, GiveTheSameSquaredDistance) {
  SmallPairs pairs(7);
  int apart = 0;
  for (int i = 0; i < 500; ++i) {
    const corpus::Case problem = i < 300 ? pairs.pair() : pairs.composed_pair();
    const LinearTruth truth(problem);
    const double t = pairs.random.integer(0, 3) * 0.375;
    const Rational squared = distance_sq_by_quadratic_program(problem, Rational(t));
    const Enclosure expected = enclose_sqrt(squared), found = truth.distance_at(t);
    ASSERT_EQ(expected.low, found.low) << "case " << i;
    ASSERT_EQ(expected.high, found.high) << "case " << i;
    apart += sgn(squared) > 0;
  }
  EXPECT_GE(apart, 100);
  EXPECT_LE(apart, 490);
}

// A rounded TOI against a bisection that asks the quadratic program alone.
TEST(HullAndQuadraticProgram, AgreeOnWhenRoundedBodiesMeet) {
  SmallPairs pairs(11);
  int hits = 0;
  for (int i = 0; i < 120; ++i) {
    corpus::Case problem = pairs.pair();
    problem.target_distance = 0.375;
    const LinearTruth truth(problem);
    ASSERT_EQ(truth.outcome() == Outcome::initially_overlapping, distance_excess(problem, 0) <= 0)
        << "case " << i;
    if (truth.outcome() != Outcome::hit) continue;
    ++hits;
    ASSERT_GE(distance_excess(problem, truth.toi_lower()), 0) << "case " << i;
    ASSERT_LE(distance_excess(problem, truth.toi_upper()), 0) << "case " << i;
  }
  EXPECT_GE(hits, 30);
}

// The corpus's hard families: full doubles, far offsets, grazes, up to 24 vertices.
TEST(HullAndPrograms, AgreeOnEveryFamilyOfTheCorpus) {
  int polytopes = 0, rounded_hits = 0;
  for (const corpus::Family& family : corpus::families()) {
    for (const double hardness : family.levels) {
      for (std::uint64_t seed = 0; seed < 24; ++seed) {
        corpus::Case problem = family.generate(hardness, seed);
        problem.start_policy = StartPolicy::report;  // the program knows no policy
        SCOPED_TRACE(problem.id);
        if (!is_exact_body(problem.a.shape) || !is_exact_body(problem.b.shape)) continue;
        const LinearTruth truth(problem);
        if (truth.is_polytope()) {
          ++polytopes;
          const std::optional<Rational> toi = toi_by_linear_program(problem);
          ASSERT_EQ(toi ? toi->get_str() : "", truth.toi_exact());
        } else if (truth.outcome() == Outcome::hit && !std::isinf(truth.toi_upper())) {
          ++rounded_hits;
          ASSERT_GE(distance_excess(problem, truth.toi_lower()), 0);
          ASSERT_LE(distance_excess(problem, truth.toi_upper()), 0);
        }
      }
    }
  }
  EXPECT_GE(polytopes, 300);
  EXPECT_GE(rounded_hits, 60);
}

TEST(LinearProgram, RefusesWhatIsNotAPolytope) {
  corpus::Case problem;
  problem.b.shape = Sphere<double>{1};
  EXPECT_THROW((void)toi_by_linear_program(problem), std::invalid_argument);
  problem.b.shape = Point<double>{};
  problem.target_distance = 1;
  EXPECT_THROW((void)toi_by_linear_program(problem), std::invalid_argument);
}

}  // namespace
}  // namespace graze::oracle
