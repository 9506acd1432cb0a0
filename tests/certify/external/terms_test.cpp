// A case in the terms of an engine: the question that it gets, and the case that its answer is judged by.
#include "certify/external/terms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "balls.hpp"
#include "certify/external/read_answer.hpp"

namespace graze::external {
namespace {

using corpus::Case;
using engine::Answer;
using engine::Failure;

Declaration engine_of(std::vector<std::string> shapes) {
  Declaration engine;
  engine.name = "mine";
  engine.scalar = "double";
  engine.shapes = std::move(shapes);
  return engine;
}
Offer offer_of(Question question) {
  Offer offer;
  offer.question = question;
  offer.holds = {.time = true, .normal = true, .witnesses = true};
  offer.holds_distance = offer.holds_depth = true;
  return offer;
}
const Offer kCast = offer_of(Question::cast);

Terms terms_of(const Declaration& engine, const Case& problem, const Offer& offer = kCast) {
  return in_terms_of(engine, offer, problem, false);
}

Case boxes() {
  Case problem = test::hit();
  problem.a.shape = Box<double>{{1, 2, 3}};
  problem.b.shape = Box<double>{{0.5, 0.5, 0.25}};
  return problem;
}

TEST(Terms, RoundToFloatWhatIsAskedAndWhatIsSeen) {
  Declaration engine = engine_of({"sphere"});
  engine.scalar = "float";
  Case problem = test::hit();
  problem.b.position[1] = 0.1;
  problem.t_max = 0.7;
  const Terms terms = terms_of(engine, problem);
  ASSERT_EQ(terms.refused, "");
  EXPECT_EQ(terms.asked.b.position[1], static_cast<double>(0.1F));
  EXPECT_EQ(terms.seen.b.position[1], static_cast<double>(0.1F));
  EXPECT_EQ(terms.asked.t_max, static_cast<double>(0.7F));
  problem.b.position[1] = 1e39;
  EXPECT_NE(terms_of(engine, problem).refused, "");
}

TEST(Terms, HaveUnitQuaternions) {
  Case problem = test::hit();
  problem.a.orientation = {3, 0, 4, 0};
  problem.b.orientation = {0, 0, 0, -1e-200};
  const Terms terms = terms_of(engine_of({"sphere"}), problem);
  ASSERT_EQ(terms.refused, "");
  EXPECT_NEAR(terms.asked.a.orientation.w, 0.6, 1e-15);
  EXPECT_NEAR(terms.asked.a.orientation.y, 0.8, 1e-15);
  EXPECT_EQ(terms.asked.b.orientation.z, -1);
}

TEST(Terms, HandOverBoxesAsHullsWhereOnlyHullsAreTaken) {
  const Terms terms = terms_of(engine_of({"hull"}), boxes());
  ASSERT_EQ(terms.refused, "");
  const auto* hull = std::get_if<Hull<double>>(&terms.asked.a.shape);
  ASSERT_NE(hull, nullptr);
  EXPECT_EQ(hull->size(), 8U);
  for (const Vec3<double>& vertex : hull->vertices()) EXPECT_EQ(vertex.cwiseAbs(), Vec3<double>(1, 2, 3));
  // One that takes boxes gets boxes.
  EXPECT_TRUE(
      std::holds_alternative<Box<double>>(terms_of(engine_of({"hull", "box"}), boxes()).asked.a.shape));
  EXPECT_NE(terms_of(engine_of({"hull"}), test::hit()).refused.find("sphere"), std::string::npos);
}

TEST(Terms, BringLengthsIntoRangeByAPowerOfTwoAndAnswersBack) {
  Declaration engine = engine_of({"sphere"});
  engine.lengths = {.least = 1.0 / 128, .most = 1.0 / 32};
  const Terms terms = terms_of(engine, test::hit());
  ASSERT_EQ(terms.refused, "");
  ASSERT_LT(terms.exponent, 0);
  EXPECT_EQ(std::get<Sphere<double>>(terms.asked.a.shape).radius, std::ldexp(1, terms.exponent));
  EXPECT_EQ(terms.asked.b.position[0], std::ldexp(4, terms.exponent));
  // The judged case is the original, bit for bit.
  EXPECT_EQ(terms.seen.b.position[0], 4);
  EXPECT_EQ(terms.seen.b.displacement[0], -5);
  const double x = std::ldexp(1, terms.exponent);
  const Answer answer = read_answer(
      R"({"schema": "graze.answer/1", "id": "q", "outcome": "hit", "time": 0.5, "normal": [1, 0, 0], "point_a": [)" +
          std::to_string(x) + R"(, 0, 0], "point_b": [)" + std::to_string(x) + ", 0, 0]}",
      "q", kCast, terms);
  ASSERT_EQ(answer.failure, Failure::none) << answer.message;
  EXPECT_EQ(answer.toi_lower, 0.5);  // a time has no length in it
  EXPECT_NEAR(answer.point_a[0], 1, 1e-3);
}

TEST(Terms, AddTheMarginToTheTargetDistanceThatIsSeen) {
  Declaration engine = engine_of({"sphere"});
  engine.margin = 0.125;
  const Terms terms = terms_of(engine, test::hit());
  EXPECT_EQ(terms.asked.target_distance, 0);
  EXPECT_EQ(terms.seen.target_distance, 0.125);
  // A query about t = 0 knows none: there a body is as much larger.
  const Terms now = terms_of(engine, test::hit(), offer_of(Question::distance));
  EXPECT_EQ(now.seen.target_distance, 0);
  EXPECT_FALSE(std::holds_alternative<Sphere<double>>(now.seen.a.shape) &&
               std::get<Sphere<double>>(now.seen.a.shape).radius == 1);
}

TEST(Terms, HoldAAtRestWhereMotionIsRelative) {
  Declaration engine = engine_of({"sphere"});
  engine.relative_motion = true;
  Case problem = test::hit();
  problem.a.displacement = {1, 2, 0};
  const Terms terms = terms_of(engine, problem);
  EXPECT_EQ(terms.asked.a.displacement, Vec3<double>(0, 0, 0));
  EXPECT_EQ(terms.asked.b.displacement, Vec3<double>(-6, -2, 0));
}

TEST(Terms, MovePivotsToTheOriginWhereOnlyThatIsTaken) {
  Declaration engine = engine_of({"hull", "sphere"});
  engine.pivots = false;
  Case problem = boxes();
  problem.spin_a = {.rotation = {0, 0, 1}, .pivot = {1, 0, 0}};
  const Terms terms = terms_of(engine, problem, offer_of(Question::rotating_cast));
  ASSERT_EQ(terms.refused, "");
  EXPECT_TRUE(terms.asked.spin_a.pivot.isZero(0));
  EXPECT_EQ(terms.asked.a.position, Vec3<double>(1, 0, 0));
  double least = 0;
  for (const Vec3<double>& vertex : std::get<Hull<double>>(terms.asked.a.shape).vertices())
    least = std::min(least, vertex[0]);
  EXPECT_EQ(least, -2);
  // A ball has no vertices to move.
  problem = test::hit();
  problem.spin_a = {.rotation = {0, 0, 1}, .pivot = {1, 0, 0}};
  EXPECT_NE(terms_of(engine, problem, offer_of(Question::rotating_cast)).refused.find("pivot"),
            std::string::npos);
}

TEST(Terms, LetAPointBeARayWhicheverBodyItIs) {
  const Offer ray = offer_of(Question::ray);
  Case problem = test::hit();
  problem.a.shape = Point<double>{};
  const Terms terms = terms_of(engine_of({"sphere"}), problem, ray);
  ASSERT_EQ(terms.refused, "");
  EXPECT_TRUE(terms.swapped);
  EXPECT_TRUE(std::holds_alternative<Sphere<double>>(terms.asked.a.shape));
  EXPECT_TRUE(std::holds_alternative<Point<double>>(terms.seen.a.shape));
  EXPECT_NE(write_question(ray, terms, "q7").find(R"("id": "q7", "query": "ray")"), std::string::npos);
  EXPECT_NE(write_question(ray, terms, "q7").find("\"origin\": [0, 0, 0], \"direction\": [5, 0, 0]"),
            std::string::npos)
      << write_question(ray, terms, "q7");
  // Its normal is from the asked A to the ray, and comes back from the case's A.
  const Answer answer = read_answer(
      R"({"schema": "graze.answer/1", "id": "q7", "outcome": "hit", "time": 0.5, "normal": [-1, 0, 0],
          "point_a": [1, 0, 0], "point_b": [2, 0, 0]})",
      "q7", ray, terms);
  ASSERT_EQ(answer.failure, Failure::none) << answer.message;
  EXPECT_EQ(answer.normal, Vec3<double>(1, 0, 0));
  EXPECT_EQ(answer.point_a, Vec3<double>(2, 0, 0));
  EXPECT_EQ(answer.point_b, Vec3<double>(1, 0, 0));
  EXPECT_NE(terms_of(engine_of({"sphere"}), test::hit(), ray).refused, "");
}

TEST(Terms, RefuseWhatTheEngineDoesNotTake) {
  Declaration engine = engine_of({"sphere", "hull", "box"});
  Case problem = test::hit();
  problem.t_max = kInfinity<double>;
  EXPECT_EQ(terms_of(engine, problem).refused, "its path has no end");
  problem = test::hit();
  problem.target_distance = 0.1;
  EXPECT_EQ(terms_of(engine, problem).refused, "it has a target distance");
  engine.most_aspect = 2;
  const Terms beyond = terms_of(engine, boxes());
  EXPECT_NE(beyond.refused, "");
  EXPECT_TRUE(beyond.beyond_limits);
  EXPECT_EQ(in_terms_of(engine, kCast, boxes(), true).refused, "");
}

// ---- Answers ----

Answer read(const std::string& line) {
  return read_answer(line, "q1", kCast, terms_of(engine_of({"sphere"}), test::hit()));
}
std::string answer(const std::string& rest) {
  return R"({"schema": "graze.answer/1", "id": "q1", )" + rest + "}";
}
constexpr const char* kRest = R"("normal": [1, 0, 0], "point_a": [1, 0, 0], "point_b": [1, 0, 0])";

TEST(Answers, AreRead) {
  const Answer hit =
      read(answer(R"("outcome": "hit", "time": {"lower": 0.25, "upper": 0.5}, )" + std::string(kRest)));
  EXPECT_EQ(hit.failure, Failure::none) << hit.message;
  EXPECT_EQ(hit.outcome, Outcome::hit);
  EXPECT_EQ(hit.toi_lower, 0.25);
  EXPECT_EQ(hit.toi_upper, 0.5);
  EXPECT_EQ(hit.normal, Vec3<double>(1, 0, 0));
  EXPECT_EQ(read(answer(R"("outcome": "miss")")).outcome, Outcome::miss);
  EXPECT_TRUE(read(answer(R"("outcome": "unsupported", "message": "no")")).declined);
  EXPECT_EQ(read(answer(R"("outcome": "miss", "time": "nan", "normal": 7)")).failure, Failure::none)
      << "fields that a miss does not have are not looked at";
}

TEST(Answers, ThatAreHostileFailAndNothingThrows) {
  const std::pair<std::string, Failure> all[] = {
      {"", Failure::garbage},
      {"null", Failure::garbage},
      {"{", Failure::garbage},
      {std::string(100000, '['), Failure::garbage},
      {std::string(100, '-'), Failure::garbage},
      {std::string("\0\0\0", 3), Failure::garbage},
      {"\"\\", Failure::garbage},
      {"{\"a\": NaN", Failure::garbage},
      {answer(R"("outcome": "miss")") + answer(R"("outcome": "miss")"), Failure::garbage},
      {answer(R"("outcome": "maybe")"), Failure::garbage},
      {answer(R"("outcome": "miss", "outcome": "hit")"), Failure::garbage},
      {answer(R"("outcome": "miss", "colour": 1)"), Failure::garbage},
      {R"({"schema": "graze.answer/2", "id": "q1", "outcome": "miss"})", Failure::garbage},
      {R"({"schema": "graze.answer/1", "outcome": "miss"})", Failure::garbage},
      {R"({"schema": "graze.answer/1", "id": "q2", "outcome": "miss"})", Failure::wrong_id},
      {R"({"schema": "graze.answer/1", "id": 1, "outcome": "miss"})", Failure::garbage},
      {answer(R"("outcome": "hit")"), Failure::garbage},
      {answer(R"("outcome": "hit", "time": "soon")"), Failure::garbage},
      {answer(R"("outcome": "hit", "time": [0.5])"), Failure::garbage},
      {answer(R"("outcome": "hit", "time": {"lower": 0.5})"), Failure::garbage},
      {answer(R"("outcome": "hit", "time": NaN, )" + std::string(kRest)), Failure::non_finite},
      {answer(R"("outcome": "hit", "time": -Infinity, )" + std::string(kRest)), Failure::non_finite},
      {answer(R"("outcome": "hit", "time": 1e999, )" + std::string(kRest)), Failure::garbage},
      {answer(R"("outcome": "hit", "time": {"lower": 0.5, "upper": NaN}, )" + std::string(kRest)),
       Failure::non_finite},
      {answer(R"("outcome": "hit", "time": {"lower": 0.6, "upper": 0.5}, )" + std::string(kRest)),
       Failure::out_of_range},
      {answer(R"("outcome": "hit", "time": -1e-300, )" + std::string(kRest)), Failure::out_of_range},
      {answer(R"("outcome": "hit", "time": 1.0000001, )" + std::string(kRest)), Failure::out_of_range},
      {answer(
           R"("outcome": "hit", "time": 0.5, "normal": [0, 0, 0], "point_a": [1, 0, 0], "point_b": [1, 0, 0])"),
       Failure::out_of_range},
      {answer(
           R"("outcome": "hit", "time": 0.5, "normal": [1, 0], "point_a": [1, 0, 0], "point_b": [1, 0, 0])"),
       Failure::garbage},
      {answer(R"("outcome": "hit", "time": 0.5, "normal": [1, 0, 0])"), Failure::garbage},
  };
  for (const auto& [line, failure] : all) {
    const Answer bad = read(line);
    EXPECT_EQ(to_text(bad.failure), to_text(failure)) << line.substr(0, 200) << "\n" << bad.message;
    EXPECT_FALSE(bad.message.empty());
    EXPECT_LT(bad.message.size(), 600U);
  }
}

}  // namespace
}  // namespace graze::external
