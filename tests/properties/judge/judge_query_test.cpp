// The judge of the queries convicts made-up answers whose fault is known, and acquits our own.
#include "properties/judge/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engines/guarantees.hpp"
#include "properties/judge/own_frames.hpp"

namespace graze::law {
namespace {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Interval;

// Answers are handed in: of the method only the row, kappa 64, counts.
const engine::Method& method_for(Query query) {
  return *engine::find_method(query, query == Query::penetration                                 ? "epa"
                                     : query == Query::penetration_along || query == Query::line ? "mpr"
                                                                                                 : "gjk");
}

// A cube of side 2 about the origin, B a cube of side 1 whose centre is at x, moving by v.
Case cubes(Query query, const Vec3<double>& x, const Vec3<double>& v = {0, 0, 0}) {
  Case problem;
  problem.id = "test/cubes";
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b.shape = Box<double>{{0.5, 0.5, 0.5}};
  problem.b.position = x;
  problem.b.displacement = v;
  problem.query = query;
  problem.direction = {2, 0, 0};
  return problem;
}

Answer ours(const Case& problem) {
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    if (method.query == problem.query) return method.answer(problem);
  }
  return {};
}

Judgement judged(const Case& problem, const Answer& answer) {
  Truth truth(problem);
  return judge_query(truth, method_for(problem.query), answer);
}

// The judge accepts our answer, and finds the named fault in it after the change.
void falls(const Case& problem, std::string Judgement::*fault, const std::function<void(Answer&)>& change) {
  Answer answer = ours(problem);
  const Judgement before = judged(problem, answer);
  EXPECT_FALSE(before.faulty()) << before.wrong << before.off << before.bad_contact;
  change(answer);
  EXPECT_NE(judged(problem, answer).*fault, "");
}

constexpr double kOff = 1e-12;

TEST(QueryJudge, Overlap) {
  const Case apart = cubes(Query::overlap, {2, 0, 0}), in = cubes(Query::overlap, {1.25, 0, 0});
  falls(apart, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::initially_overlapping; });
  falls(in, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::miss; });
  falls(apart, &Judgement::bad_contact, [](Answer& a) { a.normal = Vec3<double>(-1, 0, 0); });
  falls(apart, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::invalid_input; });
}

// A bracket that says of itself that it is wide is held to no width.
TEST(QueryJudge, WhatHasNotConvergedIsOverNoLimit) {
  const Case apart = cubes(Query::distance, {2, 0.25, 0});
  Answer answer = ours(apart);
  answer.separation->lower /= 2;
  EXPECT_GT(judged(apart, answer).errors.over_limit, 1);
  answer.stalled = true;
  const Judgement open = judged(apart, answer);
  EXPECT_TRUE(open.stalled);
  EXPECT_TRUE(std::isnan(open.errors.over_limit));
}

TEST(QueryJudge, Distance) {
  const Case apart = cubes(Query::distance, {2, 0.25, 0});
  falls(apart, &Judgement::off, [](Answer& a) { a.separation->lower -= kOff; });
  falls(apart, &Judgement::off, [](Answer& a) { a.separation->upper += kOff; });
  falls(apart, &Judgement::off,
        [](Answer& a) { std::swap(a.separation->lower += kOff, a.separation->upper); });
  falls(apart, &Judgement::bad_contact, [](Answer& a) { a.normal *= -1; });
  falls(apart, &Judgement::bad_contact, [](Answer& a) { a.point_a.x() += kOff; });
  falls(apart, &Judgement::bad_contact, [](Answer& a) { a.point_b.y() += 0.125; });
  // A wide answer that reports that it did not converge has no fault. A wide and false one has.
  Answer wide = ours(apart);
  wide.stalled = true;
  wide.separation = Interval{0.25, 0.75};
  EXPECT_FALSE(judged(apart, wide).faulty());
  EXPECT_TRUE(judged(apart, wide).stalled);
  wide.separation = Interval{0.6, 0.75};
  EXPECT_NE(judged(apart, wide).off, "");
}

TEST(QueryJudge, Penetration) {
  const Case in = cubes(Query::penetration, {1.25, 0, 0});
  falls(in, &Judgement::off, [](Answer& a) { a.depth->lower -= kOff; });
  falls(in, &Judgement::off, [](Answer& a) { a.depth->upper += kOff; });
  falls(in, &Judgement::bad_contact, [](Answer& a) { a.normal = Vec3<double>(0, 1, 0); });
  falls(in, &Judgement::bad_contact, [](Answer& a) { a.point_b = a.point_a; });
  falls(in, &Judgement::wrong, [](Answer& a) { a.depth.reset(); });
}

TEST(QueryJudge, PenetrationAlong) {
  const Case in = cubes(Query::penetration_along, {0.5, 0, 0});
  falls(in, &Judgement::off, [](Answer& a) { a.depth->upper += kOff; });
  falls(in, &Judgement::off, [](Answer& a) { a.depth->lower = 0.5; });
  falls(in, &Judgement::bad_contact, [](Answer& a) { a.has_points = false; });
}

TEST(QueryJudge, Line) {
  const Case behind = cubes(Query::line, {-4, 0, 0}, {-8, 0, 0}),
             past = cubes(Query::line, {0, 4, 0}, {8, 0, 0});
  falls(behind, &Judgement::off, [](Answer& a) { a.t_in->lower -= kOff; });
  falls(behind, &Judgement::off, [](Answer& a) { a.t_out->upper += kOff; });
  falls(behind, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::miss; });
  falls(past, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::hit; });
}

// For bodies that do not move and touch, contact has no end on either side. For all others it has both ends.
TEST(QueryJudge, ALineWithoutEnds) {
  const Case still = cubes(Query::line, {1.25, 0, 0});
  falls(still, &Judgement::off, [](Answer& a) { a.t_in->lower = -1; });
  falls(still, &Judgement::off, [](Answer& a) { a.t_out->upper = std::numeric_limits<double>::max(); });
  falls(cubes(Query::line, {-4, 0, 0}, {-8, 0, 0}), &Judgement::off,
        [](Answer& a) { a.t_out->upper = kInfinity<double>; });
}

// The ends of a line through what is near are as far out as the target distance, and round so.
TEST(QueryJudge, ALinesScaleIsNoLessThanTheTargetDistance) {
  Case near;
  near.id = "test/points";
  near.b.position = {1, 1, 2};
  near.b.displacement = {1, 0.25, 16};
  near.query = Query::line;
  near.target_distance = 7e21;
  falls(near, &Judgement::off, [](Answer& a) { a.t_out->upper += kOff * 7e21; });
}

TEST(QueryJudge, SweptOverlap) {
  const Case meets = cubes(Query::swept_overlap, {-4, 0, 0}, {8, 0, 0}),
             short_of = cubes(Query::swept_overlap, {-4, 0, 0}, {2, 0, 0});
  falls(meets, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::miss; });
  falls(short_of, &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::hit; });
  // Parts the cubes at the start, not at the end.
  falls(short_of, &Judgement::bad_contact, [](Answer& a) { a.normal = {-0.6, 0.8, 0}; });
}

TEST(QueryJudge, EveryMethodHasARow) {
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    EXPECT_NE(method.guarantee, nullptr) << method.full_name();
  }
}

// Two points, carried out by 4 and back under two turns: their distance, 2e-6, says nothing of how that
// rounds.
TEST(QueryJudge, PositionsInATreeRoundAtTheirOwnSize) {
  const Shape<double> inner =
      posed<double>(Point<double>{}, Vec3<double>(-4, -4, 3.625), Quaternion<double>{0, 1, 0, 0});
  Case swept;
  swept.id = "test/tree";
  swept.b.shape =
      posed<double>(inner, Vec3<double>(0, 0, -3.8125), Quaternion<double>{0, 4000, 22.026481797919132, 10});
  swept.b.position = {4.025634443120516, -7.457564086107801, -3.955803871154785};
  swept.b.orientation = {1, 1, 0, 0};
  swept.b.displacement = {0, 0, -0.00011444091796874999};
  swept.query = Query::swept_overlap;
  // One turn is above a position, beyond the scale by that: 46 u of it.
  const double beyond = Vec3<double>(-4, -4, 3.625).norm() - 2e-6;
  EXPECT_DOUBLE_EQ(unseen_of_trees(swept, 2e-6), 46 * kUnitRoundoff<double> * beyond);
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    if (method.query != Query::swept_overlap || method.is_exact() || method.scalar != "double") continue;
    EXPECT_FALSE(judged(swept, method.answer(swept)).faulty()) << method.full_name();
  }
  EXPECT_EQ(unseen_of_trees(cubes(Query::line, {0, 4, 0}), 2), 0);
}

}  // namespace
}  // namespace graze::law
