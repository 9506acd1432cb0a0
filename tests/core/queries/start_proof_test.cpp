// A start in contact is proved by four support pairs around the origin, unless it is one by rounding alone.
#include <gtest/gtest.h>

#include <graze/cast.hpp>

#include "corpus/case.hpp"
#include "oracles/checker/check_proof.hpp"
#include "tests/shared/turning_bodies.hpp"

namespace graze {
namespace {

using test::Draw;

TEST(StartProof, DeepOverlapsOfSolidsAreProved) {
  Draw draw{41};
  int proved = 0, asked = 0;
  for (int round = 0; round < 300; ++round) {
    corpus::Case problem;
    problem.a = {.shape = test::any_shape(draw, round % 9), .displacement = draw.vector<double>(1)};
    problem.b = {.shape = test::any_shape(draw, (round / 9) % 9),
                 .position = draw.vector<double>(0.05),
                 .orientation = draw.turn<double>()};
    const auto r = cast(problem.a, problem.b, {.request = Request::everything});
    if (r.outcome != Outcome::initially_overlapping) continue;
    ++asked;
    ASSERT_TRUE(r.proof);
    const oracle::Verdict verdict = oracle::check_proof(problem, *r.proof);
    EXPECT_TRUE(verdict.accepted()) << verdict.detail;
    if (r.proof->toi_upper != 0) continue;
    ++proved;
    EXPECT_EQ(r.proof->portal_size, 4);
  }
  EXPECT_GE(asked, 200);
  // The rest: the search ends on a segment or a triangle that holds the origin, as of two balls.
  EXPECT_GE(proved, asked * 4 / 5);
}

// A start that touches may have no four pairs beyond rounding. Then nothing is claimed, and the checker
// accepts that.
TEST(StartProof, ATouchClaimsNothingThatIsNotProved) {
  corpus::Case problem;
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b = {.shape = Box<double>{{1, 1, 1}}, .position = {2, 0.25, 0.5}, .displacement = {-1, 0, 0}};
  const auto r = cast(problem.a, problem.b, {.request = Request::everything});
  ASSERT_EQ(r.outcome, Outcome::initially_overlapping);
  ASSERT_TRUE(r.proof);
  EXPECT_EQ(r.proof->toi_upper, kInfinity<double>);
  EXPECT_TRUE(oracle::check_proof(problem, *r.proof).accepted());
}

// The methods of standard tier by their names, the exact one too, through the one call.
TEST(StartProof, EveryMethodByNameAgreesOnADeepStart) {
  const Body<double> a{.shape = Box<double>{{1, 2, 0.5}}};
  const Body<double> b{.shape = Box<double>{{0.5, 0.25, 1}}, .position = {0.25, 0.125, 0.5}};
  for (const Method method :
       {Method::exact_portal, Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
    const auto r = cast(a, b, {.method = method, .request = Request::everything});
    EXPECT_EQ(r.outcome, Outcome::initially_overlapping);
    EXPECT_EQ(r.method, method);
  }
}

}  // namespace
}  // namespace graze
