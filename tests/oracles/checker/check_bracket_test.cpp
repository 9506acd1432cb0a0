// check_bracket gives the verdicts that check_proof gives for each bound alone, for a proof and for the proof
// with either bound moved to the other. The proofs of the exact tier come as they are, and with bounds that
// are wider, narrower or missing, axes reversed, and portals with a wrong point. Those of the certified tier
// come with a target distance.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/cast.hpp>
#include <iostream>

#include "corpus/families.hpp"
#include "oracles/checker/check_proof.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::MovedBounds;
using oracle::Verdict;

double moved_by(double x, int units) {
  for (; units > 0; --units) x = std::nextafter(x, kInfinity<double>);
  for (; units < 0 && x > 0; ++units) x = std::nextafter(x, 0.0);
  return x;
}

struct Counts {
  int proofs = 0, accepted = 0, refused = 0, lower_accepted = 0, upper_accepted = 0, neither = 0;
};

void compare(const Case& problem, const Proof& proof, Counts& counts) {
  MovedBounds moved;
  const Verdict together = oracle::check_bracket(problem, proof, moved);
  const Verdict alone = oracle::check_proof(problem, proof);
  ASSERT_EQ(together.refusal, alone.refusal) << problem.id;
  ASSERT_EQ(together.detail, alone.detail) << problem.id;
  ++counts.proofs;
  ++(alone.accepted() ? counts.accepted : counts.refused);

  const bool bracket = proof.toi_lower < proof.toi_upper && proof.toi_upper < kInfinity<double>;
  MovedBounds expected;
  if (bracket && alone.accepted()) {
    Proof raised = proof, lowered = proof;
    raised.toi_lower = proof.toi_upper;
    lowered.toi_upper = proof.toi_lower;
    expected = {oracle::check_proof(problem, raised).accepted(),
                oracle::check_proof(problem, lowered).accepted()};
    counts.neither += !expected.lower_accepted && !expected.upper_accepted;
  }
  // A refused proof says nothing of its bounds.
  if (!alone.accepted() && bracket) return;
  ASSERT_EQ(moved.lower_accepted, expected.lower_accepted) << problem.id;
  ASSERT_EQ(moved.upper_accepted, expected.upper_accepted) << problem.id;
  counts.lower_accepted += moved.lower_accepted;
  counts.upper_accepted += moved.upper_accepted;
}

// The proof with its bounds moved about, and spoilt.
void compare_variants(const Case& problem, const Proof& proof, Counts& counts) {
  compare(problem, proof, counts);
  if (!(proof.toi_upper < kInfinity<double>)) return;
  for (const auto& [lower, upper] : {std::pair(-1, 0), std::pair(0, 1), std::pair(-2, -1), std::pair(1, 2),
                                     std::pair(-3, 0), std::pair(0, 4)}) {
    Proof variant = proof;
    variant.toi_lower = moved_by(proof.toi_lower, lower);
    variant.toi_upper = moved_by(proof.toi_upper, upper);
    compare(problem, variant, counts);
  }
  Proof from_zero = proof;
  from_zero.toi_lower = 0;
  compare(problem, from_zero, counts);
  Proof backward = proof;
  backward.axis_sign = -proof.axis_sign;
  backward.axis = -proof.axis;
  compare(problem, backward, counts);
  Proof misplaced = proof;
  misplaced.portal[0].a.vertex = 0;
  compare(problem, misplaced, counts);
}

void report(const char* what, const Counts& counts) {
  std::cout << "[  counts  ] " << what << ": " << counts.proofs << " proofs, accepted " << counts.accepted
            << ", refused " << counts.refused << ", accepted when raised " << counts.lower_accepted
            << ", when lowered " << counts.upper_accepted << ", neither " << counts.neither << "\n";
}

Counts compare_family(const char* name, Tier tier, std::uint64_t seeds, double target_distance = 0) {
  Counts counts;
  const corpus::Family& family = *corpus::find_family(name);
  for (const double hardness : family.levels) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      Case problem = family.generate(hardness, seed);
      problem.target_distance = target_distance;
      CastOptions<double> options{.tier = tier, .request = Request::proof};
      options.t_max = problem.t_max;
      options.target_distance = target_distance;
      const CastResult<double> result = cast(problem.a, problem.b, options);
      if (result.proof) compare_variants(problem, *result.proof, counts);
    }
  }
  report(name, counts);
  return counts;
}

TEST(CheckBracket, SaysOfProofsOfTheExactTierWhatThreeChecksSay) {
  for (const char* name : {"hulls", "hulls_rotated", "random"}) {
    const Counts counts = compare_family(name, Tier::exact, 150);
    EXPECT_GT(counts.accepted, 2000) << name;
    EXPECT_GT(counts.refused, 1000) << name;
    EXPECT_GT(counts.neither, 2000) << name;
    EXPECT_GT(counts.upper_accepted, 20) << name;
  }
  const Counts sums = compare_family("combinators", Tier::exact, 1500);
  EXPECT_GT(sums.accepted, 300);
  EXPECT_GT(sums.refused, 100);
  EXPECT_GT(sums.neither, 200);
}

// Ties, and times that are doubles.
TEST(CheckBracket, SaysTheSameOfAlignedBoxesAndOfTouchingStarts) {
  for (const char* name : {"aligned_boxes", "touching"}) {
    const Counts counts = compare_family(name, Tier::exact, 60);
    EXPECT_GT(counts.accepted, 500) << name;
    EXPECT_GT(counts.refused, 100) << name;
    EXPECT_GT(counts.lower_accepted, 20) << name;
    EXPECT_GT(counts.upper_accepted, 100) << name;
  }
}

TEST(CheckBracket, SaysTheSameOfCurvedShapesAndTargetDistances) {
  for (const char* name : {"random", "curved"}) {
    const Counts counts = compare_family(name, Tier::certified, 16, 0.25);
    EXPECT_GT(counts.accepted, 100) << name;
    EXPECT_GT(counts.refused, 50) << name;
    EXPECT_GT(counts.neither, 20) << name;
  }
}

}  // namespace
}  // namespace graze::test
