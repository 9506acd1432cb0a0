// The judge convicts made-up answers whose fault is known, and no others.
#include "properties/judge/judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "corpus/curate/location.hpp"
#include "corpus/format/case_io.hpp"
#include "engines/guarantees.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {
namespace {

constexpr double kU = kUnitRoundoff<double>;
constexpr double kInf = kInfinity<double>;

// A made-up method. Only its given answers are judged.
engine::Method method_of(const engine::Guarantee& row, double unit_roundoff = kU) {
  return {.name = row.method,
          .scalar = row.scalar,
          .tier = row.tier,
          .unit_roundoff = unit_roundoff,
          .guarantee = &row};
}
const engine::Guarantee kRow{.method = "made_up",
                             .scalar = "double",
                             .tier = "standard",
                             .kappa_polytope = 1024,
                             .kappa_rounded = 1024,
                             .mechanism = ""};
engine::Guarantee exact_row(const char* scalar) {
  return {.method = "made_up", .scalar = scalar, .tier = "exact", .kappa_contact = 16, .mechanism = ""};
}

// Two unit cubes, B two above A: they touch at t = 1/4, and the scale is the diagonal, 2 sqrt(3).
corpus::Case falling_cube() {
  corpus::Case problem;
  problem.id = "test/falling-cube";
  problem.a.shape = problem.b.shape = Box<double>{{1, 1, 1}};
  problem.b.position = {0.25, 0.5, 3};
  problem.b.displacement = {0, 0, -4};
  return problem;
}
const double kScale = 2 * std::sqrt(3.0);

engine::Answer right_answer() {
  engine::Answer answer;
  answer.outcome = Outcome::hit;
  answer.toi_lower = answer.toi_upper = 0.25;
  answer.normal = {0, 0, 1};
  answer.point_a = answer.point_b = {0.5, 0.5, 1};
  return answer;
}

// Axis z proves t >= 1/4. The pair of vertices (1, 1, 1) of A and (1, 1, -1) of B, with three others of their
// faces, meets the path. One corner pair is not on the path, so the portal takes a triangle around it.
Proof right_proof() {
  Proof proof;
  proof.has_axis = true;
  proof.axis = {0, 0, 1};
  proof.toi_lower = proof.toi_upper = 0.25;
  // CSO vertices a - b over the top face of A and the bottom of B: x in [-2.25, 1.75], y in [-2.5, 1.5].
  proof.portal_size = 3;
  proof.portal[0] = {.a = {.vertex = 7}, .b = {.vertex = 0}};  // (1.75, 1.5)
  proof.portal[1] = {.a = {.vertex = 4}, .b = {.vertex = 1}};  // (-2.25, -0.5)
  proof.portal[2] = {.a = {.vertex = 5}, .b = {.vertex = 2}};  // (1.75, -2.5)
  return proof;
}

Judgement judged(const engine::Answer& answer, bool ask_oracle = true,
                 const corpus::Case& problem = falling_cube()) {
  Truth truth(problem);
  return judge(truth, method_of(kRow), answer, Request::everything, ask_oracle);
}

TEST(Judge, AcquitsARightAnswerAndMeasuresNoError) {
  const Judgement j = judged(right_answer());
  EXPECT_FALSE(j.faulty()) << j.wrong << j.late << j.off << j.bad_contact;
  EXPECT_TRUE(j.by_oracle);
  EXPECT_EQ(j.errors.backward, 0);
  EXPECT_EQ(j.errors.forward, 0);
  EXPECT_EQ(j.proof, ProofState::none);
}

TEST(Judge, NeedsNoOracleWhereAnAcceptedProofSettlesAll) {
  engine::Answer answer = right_answer();
  answer.proof = right_proof();
  const Judgement j = judged(answer, false);
  EXPECT_EQ(j.proof, ProofState::accepted) << j.false_proof;
  EXPECT_FALSE(j.by_oracle);
  EXPECT_FALSE(j.faulty());
}

TEST(Judge, AsksTheOracleWhereTheBracketGoesBeyondWhatTheProofProves) {
  engine::Answer answer = right_answer();
  answer.proof = right_proof();
  answer.toi_lower = answer.toi_upper = 0.26;  // within the proof's verdict, but late
  const Judgement j = judged(answer, false);
  EXPECT_EQ(j.proof, ProofState::accepted) << j.false_proof;
  EXPECT_TRUE(j.by_oracle);
  EXPECT_FALSE(j.late.empty());
}

TEST(Judge, ConvictsAFalseProofEvenOfARightAnswer) {
  engine::Answer answer = right_answer();
  answer.proof = right_proof();
  answer.proof->toi_lower = std::nextafter(0.25, 1);
  const Judgement j = judged(answer, false);
  EXPECT_EQ(j.proof, ProofState::refused);
  EXPECT_FALSE(j.false_proof.empty());
  EXPECT_TRUE(j.by_oracle);
  EXPECT_TRUE(j.wrong.empty());
}

TEST(Judge, ConvictsATimeThatIsLateByTwiceTheLimitAndNotByHalf) {
  for (const double factor : {2.0, 0.5}) {
    engine::Answer answer = right_answer();
    // |v| = 4, head on: t later by d / 4 goes d deep.
    answer.toi_lower = answer.toi_upper = 0.25 + factor * 1024 * kU * kScale / 4;
    const Judgement j = judged(answer);
    EXPECT_EQ(!j.late.empty(), factor > 1) << j.late;
    EXPECT_EQ(!j.off.empty(), factor > 1) << j.off;
    EXPECT_TRUE(j.wrong.empty());
  }
}

TEST(Judge, AnEarlyTimeIsOffButNotLate) {
  engine::Answer answer = right_answer();
  answer.toi_lower = 0.24;
  const Judgement j = judged(answer);
  EXPECT_TRUE(j.late.empty());
  EXPECT_FALSE(j.off.empty());
  EXPECT_NEAR(j.errors.backward, 0.01 * 4 / kScale, 1e-12);
  EXPECT_NEAR(j.errors.forward, 0.01 * 4 / kScale, 1e-12);
}

TEST(Judge, ConvictsAWrongMiss) {
  engine::Answer answer;
  answer.outcome = Outcome::miss;
  answer.toi_lower = answer.toi_upper = kInf;
  EXPECT_FALSE(judged(answer).wrong.empty());
}

TEST(Judge, ConvictsAWrongHit) {
  corpus::Case problem = falling_cube();
  problem.b.position.x() = 3;
  EXPECT_FALSE(judged(right_answer(), true, problem).wrong.empty());
}

TEST(Judge, ExcusesAVerdictThatLessThanTheLimitDecides) {
  corpus::Case problem = falling_cube();
  problem.b.position.x() = 2 + 16 * kU;  // misses by 16 u
  const Judgement hit = judged(right_answer(), true, problem);
  EXPECT_TRUE(hit.wrong.empty()) << hit.wrong;
  EXPECT_TRUE(hit.within_tolerance);

  problem.b.position.x() = 2 - 16 * kU;  // hits, as deep
  engine::Answer answer;
  answer.outcome = Outcome::miss;
  answer.toi_lower = answer.toi_upper = kInf;
  const Judgement miss = judged(answer, true, problem);
  EXPECT_TRUE(miss.wrong.empty()) << miss.wrong;
  EXPECT_TRUE(miss.within_tolerance);
}

TEST(Judge, AStallIsCountedAndItsBracketStillJudged) {
  engine::Answer answer;
  answer.outcome = Outcome::not_converged;
  answer.toi_lower = 0.2;
  answer.toi_upper = kInf;
  const Judgement honest = judged(answer);
  EXPECT_TRUE(honest.stalled);
  EXPECT_FALSE(honest.faulty());

  answer.toi_lower = 0.3;
  EXPECT_FALSE(judged(answer).late.empty());

  answer.toi_lower = 0.1;
  answer.toi_upper = 0.2;  // claims contact by 0.2
  EXPECT_FALSE(judged(answer).early.empty());
}

// An answer that did not converge has no promised width. Its errors are measured and compared with no limit.
TEST(Judge, WhatHasNotConvergedIsOverNoLimit) {
  engine::Answer answer = right_answer();
  answer.toi_lower = 0.2;
  const Judgement hit = judged(answer);
  EXPECT_GT(hit.errors.over_limit, 1);
  answer.outcome = Outcome::not_converged;
  const Judgement open = judged(answer);
  EXPECT_EQ(open.errors.backward, hit.errors.backward);
  EXPECT_TRUE(std::isnan(open.errors.over_limit));
}

// Two cones, apex to apex: the oracle's own bracket of the time is 1e-5 wide, what tier certified promises 1e-12.
TEST(Judge, WhatTheOracleLeavesOpenIsOverNoLimit) {
  const corpus::ReadResult cases =
      corpus::read_file((corpus::corpus_directory() / "cases" / "round.jsonl").string());
  const auto found = std::find_if(cases.cases.begin(), cases.cases.end(), [](const corpus::Case& problem) {
    return problem.id == "round/cone-on-cone-apexes";
  });
  ASSERT_NE(found, cases.cases.end());
  const std::span<const engine::Method> all = engine::methods();
  const auto certified = std::find_if(all.begin(), all.end(), [](const engine::Method& method) {
    return method.kind == engine::Kind::linear && method.full_name() == "certified/double";
  });
  ASSERT_NE(certified, all.end());
  Truth truth(*found);
  const Judgement judgement = judge(truth, *certified, certified->answer(*found), Request::everything, true);
  EXPECT_FALSE(judgement.faulty());
  EXPECT_GT(judgement.errors.backward, 1e-6);
  EXPECT_LE(judgement.errors.over_limit, 1);
}

TEST(Judge, ConvictsAFlippedNormalALongOneAndAWitnessOffItsBody) {
  engine::Answer answer = right_answer();
  answer.normal = {0, 0, -1};
  EXPECT_FALSE(judged(answer).bad_contact.empty());
  answer = right_answer();
  answer.normal = {1, 0, 0};  // perpendicular to the motion, and no normal there
  EXPECT_FALSE(judged(answer).bad_contact.empty());
  answer = right_answer();
  answer.normal *= 1 + 1e-12;
  EXPECT_FALSE(judged(answer).bad_contact.empty());
  answer = right_answer();
  answer.point_b.z() += 1e-11;  // inside B
  EXPECT_TRUE(judged(answer).bad_contact.empty());
  answer.point_a.z() += 1e-11;
  EXPECT_FALSE(judged(answer).bad_contact.empty());
}

TEST(Judge, ConvictsWhatIsNoAnswerAtAll) {
  engine::Answer answer = right_answer();
  answer.toi_lower = std::nan("");
  EXPECT_FALSE(judged(answer).wrong.empty());
  answer = right_answer();
  answer.toi_lower = 0.3;  // above toi_upper
  EXPECT_FALSE(judged(answer).wrong.empty());
  answer = right_answer();
  answer.outcome = Outcome::miss;
  EXPECT_FALSE(judged(answer).wrong.empty());
}

TEST(Judge, AValidCaseMustBeAnsweredAndAnInvalidOneRefused) {
  engine::Answer refusal;
  EXPECT_FALSE(judged(refusal).wrong.empty());
  corpus::Case problem = falling_cube();
  problem.b.orientation = {0, 0, 0, 0};
  EXPECT_TRUE(judged(refusal, true, problem).wrong.empty());
  EXPECT_FALSE(judged(right_answer(), true, problem).wrong.empty());
  problem = falling_cube();
  problem.a.shape = Box<double>{{1, kInf, 1}};
  EXPECT_FALSE(judged(right_answer(), true, problem).wrong.empty());
}

TEST(Judge, OverAScaleOfZeroOnlyAnErrorOfZeroIsExcused) {
  corpus::Case problem;  // two points in the same place, at rest
  problem.id = "test/points";
  problem.a.shape = problem.b.shape = Point<double>{};
  engine::Answer answer;
  answer.outcome = Outcome::initially_overlapping;
  EXPECT_FALSE(judged(answer, true, problem).faulty());
}

// --- Tier exact: falling from 3 by 3 the cubes touch at t = 1/3, which is no double.
corpus::Case falling_by_three() {
  corpus::Case problem = falling_cube();
  problem.b.displacement = {0, 0, -3};
  return problem;
}

engine::Answer exact_answer() {
  engine::Answer answer = right_answer();
  answer.proof = right_proof();
  answer.toi_lower = answer.proof->toi_lower = 1.0 / 3;  // rounds down
  answer.toi_upper = answer.proof->toi_upper = std::nextafter(1.0 / 3, 1.0);
  return answer;
}

Judgement judged_exactly(const engine::Answer& answer, bool ask_oracle,
                         const corpus::Case& problem = falling_by_three()) {
  Truth truth(problem);
  static const engine::Guarantee kExact = exact_row("double");
  return judge(truth, method_of(kExact), answer, Request::everything, ask_oracle);
}

TEST(JudgeExact, AcquitsTheTwoDoublesNextToTheTime) {
  for (const bool ask_oracle : {false, true}) {
    const Judgement j = judged_exactly(exact_answer(), ask_oracle);
    EXPECT_FALSE(j.faulty()) << j.wrong << j.false_proof << j.bad_contact;
    EXPECT_EQ(j.proof, ProofState::accepted);
    EXPECT_EQ(j.by_oracle, ask_oracle);
  }
}

TEST(JudgeExact, ConvictsABracketThatIsADoubleTooWideByItsProof) {
  engine::Answer answer = exact_answer();
  answer.toi_lower = answer.proof->toi_lower = std::nextafter(answer.toi_lower, 0.0);
  EXPECT_FALSE(judged_exactly(answer, false).wrong.empty());
  answer = exact_answer();
  answer.toi_upper = answer.proof->toi_upper = std::nextafter(answer.toi_upper, 1.0);
  EXPECT_FALSE(judged_exactly(answer, false).wrong.empty());
  // 1/4 is a double: the ends are neighbours, and either is a double too far.
  for (const double beside : {std::nextafter(0.25, 0.0), std::nextafter(0.25, 1.0)}) {
    answer = right_answer();
    answer.proof = right_proof();
    answer.toi_lower = answer.proof->toi_lower = std::min(beside, 0.25);
    answer.toi_upper = answer.proof->toi_upper = std::max(beside, 0.25);
    EXPECT_FALSE(judged_exactly(answer, false, falling_cube()).wrong.empty());
  }
}

TEST(JudgeExact, ConvictsWhatIsADoubleLateOrEarly) {
  engine::Answer answer = exact_answer();
  answer.toi_lower = answer.proof->toi_lower = answer.toi_upper;
  EXPECT_FALSE(judged_exactly(answer, false).false_proof.empty());
  answer = exact_answer();
  answer.toi_upper = answer.proof->toi_upper = answer.toi_lower;
  EXPECT_FALSE(judged_exactly(answer, false).false_proof.empty());
  // The claim of the proof is right, but the answer is something else.
  answer = exact_answer();
  answer.toi_lower = answer.toi_upper;
  EXPECT_FALSE(judged_exactly(answer, false).wrong.empty());
  answer = exact_answer();
  answer.proof.reset();
  EXPECT_FALSE(judged_exactly(answer, false).wrong.empty());
  answer.outcome = Outcome::not_converged;
  EXPECT_FALSE(judged_exactly(answer, false).wrong.empty());
}

TEST(JudgeExact, RoundsTheProvedBracketOutwardToFloat) {
  engine::Answer answer = exact_answer();
  Truth truth(falling_by_three());
  const engine::Guarantee row = exact_row("float");
  const engine::Method in_float = method_of(row, kUnitRoundoff<float>);
  EXPECT_FALSE(judge(truth, in_float, answer, Request::everything, true).wrong.empty());
  answer.toi_upper = 1.0F / 3;  // rounds up
  answer.toi_lower = std::nextafter(1.0F / 3, 0.0F);
  const Judgement j = judge(truth, in_float, answer, Request::everything, true);
  EXPECT_FALSE(j.faulty()) << j.wrong << j.false_proof << j.bad_contact;
}

TEST(JudgeExact, CountsApartWhatTheTierIsNotAsked) {
  corpus::Case problem = falling_by_three();
  problem.b.shape = Cylinder<double>{1, 1};
  engine::Answer refusal;
  refusal.outcome = Outcome::invalid_input;
  refusal.invalid = Invalid::not_exact;
  EXPECT_TRUE(judged_exactly(refusal, true, problem).skipped);
  EXPECT_FALSE(judged_exactly(refusal, true, problem).faulty());
  EXPECT_TRUE(judged_exactly(exact_answer(), false, problem).faulty());
  EXPECT_TRUE(judged_exactly(refusal, false).faulty());
  refusal.invalid = Invalid::too_complex;
  EXPECT_TRUE(judged_exactly(refusal, false, problem).faulty());
}

// Is an answer a fault, or unconverged although the guarantee allows no such answer?
bool fails_as_linear(const corpus::Case& problem) {
  bool fails = false;
  for (const engine::Method& method : engine::methods(engine::Kind::linear)) {
    Truth truth(method.seen(problem));
    const engine::Answer answer = method.ask(problem, {.request = Request::everything});
    const Judgement judgement = judge(truth, method, answer, Request::everything, true);
    EXPECT_TRUE(judgement.false_proof.empty()) << problem.id << ", " << method.full_name();
    const bool stalls = answer.outcome == Outcome::not_converged && method.guarantee->stall_cap == 0;
    fails = fails || stalls || judgement.faulty();
  }
  return fails;
}
bool breaks_a_turning_law(const corpus::Case& problem) {
  const auto breaks = [&](const Law& law) {
    return (law.needs == Needs::oracle || law.name == "rotating_work") &&
           std::ranges::any_of(law.methods(), [&](const Method& method) {
             return law.check(problem, method).holding == Holding::broken;
           });
  };
  return std::ranges::any_of(laws(Kind::rotating), breaks);
}

// One that is right has been mended: it belongs to corpus/cases, where it must stay right.
TEST(KnownFailures, StillFail) {
  const std::string file = GRAZE_SOURCE_DIR "/corpus/known_failures.jsonl";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no failure is known";
  const corpus::ReadResult known = corpus::read_file(file);
  ASSERT_TRUE(known.ok());
  for (const corpus::Case& problem : known.cases) {
    const bool linear = engine::unsupported(Kind::linear, problem).empty(),
               fails = linear ? fails_as_linear(problem) : breaks_a_turning_law(problem);
    EXPECT_TRUE(fails) << problem.id << " is right now: move it to corpus/cases";
  }
}

}  // namespace
}  // namespace graze::law
