// Certification of the queries: made-up methods on questions that are asked as they are, and what is kept.
#include "certify/certification.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/intake.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "properties/judge/judge.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Ask;
using engine::Method;

// Cubes of side 2, the second 3 away along x: a distance of 1.
Case cubes(Query query) {
  Case problem;
  problem.id = "test/cubes";
  problem.a.shape = problem.b.shape = Box<double>{{1, 1, 1}};
  problem.b.position = {3, 0, 0};
  problem.b.displacement = {-4, 0, 0};
  problem.query = query;
  problem.direction = {1, 0, 0};
  return problem;
}

Answer right_answer(const Case&, const Ask&) {
  Answer answer;
  answer.outcome = Outcome::miss;
  answer.separation = {1, 1};
  answer.has_points = true;
  answer.normal = {1, 0, 0};
  answer.point_a = {1, 0, 0};
  answer.point_b = {2, 0, 0};
  return answer;
}
Answer stalled_answer(const Case& problem, const Ask& ask) {
  Answer answer = right_answer(problem, ask);
  answer.separation = {0.5, 1.5};
  answer.stalled = true;
  return answer;
}
Answer wrong_answer(const Case& problem, const Ask& ask) {
  Answer answer = right_answer(problem, ask);
  answer.separation = {1.25, 1.25};
  return answer;
}

Method distance_by(Answer (*ask)(const Case&, const Ask&)) {
  static const engine::Guarantee kRow{.query = "distance",
                                      .method = "made_up",
                                      .scalar = "double",
                                      .tier = "standard",
                                      .kappa_polytope = 64,
                                      .kappa_rounded = 64,
                                      .stall_cap = 0.5,
                                      .mechanism = "a test"};
  return {.kind = engine::Kind::query,
          .query = Query::distance,
          .name = "made_up",
          .scalar = "double",
          .tier = "standard",
          .unit_roundoff = kUnitRoundoff<double>,
          .ask = ask,
          .seen = [](const Case& problem) { return problem; },
          .guarantee = &kRow};
}

Certification certified(const std::vector<const Method*>& methods, const Case& problem) {
  return certify({{.kind = engine::Kind::query, .family = "given", .cases = {problem}}},
                 {.methods = methods, .threads = 2});
}
Certification certified(const Method& method, const Case& problem) {
  return certified(std::vector<const Method*>{&method}, problem);
}

struct AnyQuestion {
  Query query;
  bool curved;
  double x;  // of B: the bodies are apart, or deep in each other
};
std::vector<AnyQuestion> every_question() {
  std::vector<AnyQuestion> all;
  for (const bool curved : {false, true}) {
    for (const double x : {3.0, 1.5}) {
      for (const Query query : {Query::line, Query::overlap, Query::distance, Query::penetration,
                                Query::penetration_along, Query::swept_overlap}) {
        all.push_back({query, curved, x});
      }
    }
  }
  return all;
}

TEST(QueryCertification, AStallIsKeptToBeSavedAndCountsAgainstTheCap) {
  const Method made_up_stalled_answer = distance_by(stalled_answer);
  const Certification stalled = certified(made_up_stalled_answer, cubes(Query::distance));
  EXPECT_EQ(stalled.tallies.at(0).cases, 1U);
  EXPECT_EQ(stalled.tallies.at(0).stalled, 1U);
  ASSERT_EQ(stalled.convicted.size(), 1U);
  EXPECT_TRUE(corpus::same_case(stalled.convicted[0], cubes(Query::distance)));
  EXPECT_EQ(stalled.breaches.size(), 1U);

  const Method made_up_right_answer = distance_by(right_answer);
  const Certification right = certified(made_up_right_answer, cubes(Query::distance));
  EXPECT_TRUE(right.convicted.empty());
  EXPECT_TRUE(right.breaches.empty());
}

TEST(QueryCertification, AQuestionIsAskedAsItIsAndOfItsOwnMethodsAlone) {
  const Method made_up_wrong_answer = distance_by(wrong_answer);
  const Certification wrong = certified(made_up_wrong_answer, cubes(Query::distance));
  EXPECT_EQ(wrong.tallies.at(0).at_fault, 1U);
  ASSERT_EQ(wrong.breaches.size(), 1U);
  EXPECT_NE(wrong.breaches[0].find("test/cubes"), std::string::npos) << wrong.breaches[0];
  EXPECT_EQ(wrong.convicted.at(0).id, "test/cubes");
  EXPECT_EQ(certified(made_up_wrong_answer, cubes(Query::line)).tallies.at(0).cases, 0U);
}

// Ours answer rightly, of polytopes and of curved shapes, apart and deep in each other.
TEST(QueryCertification, EveryQueryOfOursIsJudged) {
  std::vector<const Method*> all;
  for (const Method& method : engine::methods(engine::Kind::query)) all.push_back(&method);
  for (const auto& [query, curved, x] : every_question()) {
    SCOPED_TRACE(fmt::format("{}, {}, at {}", corpus::name_of(query), curved ? "curved" : "cubes", x));
    Case problem = cubes(query);
    problem.b.position = {x, 0.25, 0.125};
    problem.direction = {1, 0.5, 0.25};
    if (curved) problem.a.shape = Ellipsoid<double>{{1, 1.5, 2}};
    const Certification result = certified(all, problem);
    std::size_t cases = 0;
    for (const Tally& tally : result.tallies) {
      EXPECT_TRUE(tally.cases == 0 || tally.method->query == query);
      cases += tally.cases;
    }
    EXPECT_GE(cases, 2U);
    EXPECT_TRUE(result.breaches.empty()) << result.breaches.at(0);
  }
}

// A guarantee of 64 u grants none of these errors: each answer is off by a thousandth.
TEST(QueryCertification, OfCurvedShapesWhatIsOffIsConvicted) {
  for (const auto& [query, curved, x] : every_question()) {
    if (!curved) continue;
    SCOPED_TRACE(fmt::format("{}, at {}", corpus::name_of(query), x));
    Case problem = cubes(query);
    problem.b.position = {x, 0.25, 0.125};
    problem.direction = {1, 0.5, 0.25};
    problem.a.shape = Ellipsoid<double>{{1, 1.5, 2}};
    const engine::Method& ours = law::default_method(query, "double");
    const Answer right = ours.answer(problem);
    EXPECT_EQ(law::judge_curved_query(problem, ours, right).fault(), "");
    // The other verdict.
    Answer other = right;
    const Outcome contact =
        query == Query::line || query == Query::swept_overlap ? Outcome::hit : Outcome::initially_overlapping;
    other.outcome = right.outcome == contact ? Outcome::miss : contact;
    EXPECT_NE(law::judge_curved_query(problem, ours, other).wrong, "");
    // Either end of each bracket, in and out.
    using Bracket = std::optional<engine::Interval>;
    for (Bracket Answer::*const bracket :
         {&Answer::separation, &Answer::depth, &Answer::t_in, &Answer::t_out}) {
      if (!(right.*bracket)) continue;
      const double size = std::abs((right.*bracket)->upper);
      if (size == 0) continue;
      for (const double by : {-1e-3 * size, 1e-3 * size}) {
        Answer moved = right;
        (moved.*bracket)->lower += by;
        (moved.*bracket)->upper += by;
        EXPECT_NE(law::judge_curved_query(problem, ours, moved).fault(), "") << by;
      }
    }
    if (query != Query::distance || !right.has_points) continue;
    Answer off = right;
    off.point_a += 1e-3 * right.normal;
    EXPECT_NE(law::judge_curved_query(problem, ours, off).bad_contact, "");
  }
}

TEST(Intake, SortsEveryQuestionAndCountsWhatNothingJudges) {
  Case curved = cubes(Query::penetration);
  curved.id = "test/curved";
  curved.a.shape = Ellipsoid<double>{{1, 2, 3}};
  Case turning_distance = cubes(Query::distance), turning_line = cubes(Query::line);
  turning_distance.id = "test/turning-distance";
  turning_line.id = "test/turning-line";
  turning_distance.spin_b.rotation = turning_line.spin_b.rotation = {0, 0, 1};
  Case swept = turning_line;
  swept.id = "test/turning-swept";
  swept.query = Query::swept_overlap;
  Intake intake;
  intake.take("given",
              {cubes(Query::cast), cubes(Query::line), cubes(Query::overlap), curved, turning_distance,
               turning_line, swept},
              false);
  ASSERT_EQ(intake.suites.size(), 3U);
  const Suite &linear = intake.suites[0], &asked = intake.suites[1], &rotating = intake.suites[2];
  EXPECT_EQ(intake.questions, 4U);
  ASSERT_EQ(asked.size(), 4U);
  EXPECT_EQ(asked.at(0).query, Query::line);
  EXPECT_EQ(asked.at(1).query, Query::overlap);
  EXPECT_EQ(asked.at(2).id, "test/curved");
  // A query at t = 0 does not depend on the rotation.
  EXPECT_EQ(asked.at(3).id, "test/turning-distance");
  EXPECT_EQ(asked.at(3).spin_b.rotation, Vec3<double>::Zero());
  EXPECT_EQ(intake.left_out, 1U);
  EXPECT_EQ(intake.recast, 2U);
  EXPECT_EQ(linear.kind, engine::Kind::linear);
  EXPECT_EQ(linear.size(), 2U);  // the cast and the overlap's
  EXPECT_EQ(rotating.kind, engine::Kind::rotating);
  EXPECT_EQ(rotating.at(0).id, "test/turning-swept");
  EXPECT_EQ(rotating.at(0).query, Query::cast);
}

TEST(Intake, WhatIsSavedCanBeReadAgain) {
  const std::vector<Case> found = {cubes(Query::cast), cubes(Query::line), cubes(Query::line),
                                   cubes(Query::swept_overlap)};
  std::string text;
  for (const Case& problem : with_own_ids(found)) text += corpus::write_case(problem) + "\n";
  const corpus::ReadResult read = corpus::read_text(text, "saved.jsonl", true);
  EXPECT_TRUE(read.ok()) << read.errors.at(0).text();
  ASSERT_EQ(read.cases.size(), 3U);
  EXPECT_EQ(read.cases[0].id, "test/cubes");
  EXPECT_EQ(read.cases[1].id, "test/cubes/line");
  EXPECT_EQ(read.cases[2].id, "test/cubes/swept_overlap");
}

}  // namespace
}  // namespace graze::tool
