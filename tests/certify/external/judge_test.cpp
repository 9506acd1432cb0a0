// The judge's faults for answers of third-party engines: starts in contact, and engines with a margin. Each
// fault stands beside an answer that differs in nothing else and is acquitted.
#include "properties/judge/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "balls.hpp"
#include "certify/external/recorded.hpp"

namespace graze::external {
namespace {

using corpus::Case;
using corpus::Query;
using law::Judgement;

constexpr double kMargin = 0.25, kOver = 1e-6;

Declaration engine_of(double margin = 0) {
  Declaration engine;
  engine.name = "mine";
  engine.scalar = "double";
  engine.shapes = {"sphere", "box", "ellipsoid", "point"};
  engine.margin = margin;
  for (const Question question :
       {Question::cast, Question::rotating_cast, Question::distance, Question::penetration}) {
    Offer offer;
    offer.question = question;
    offer.holds = {.time = true, .normal = true, .witnesses = true};
    offer.holds_distance = offer.holds_depth = true;
    offer.takes_target_distance = true;
    offer.relative_tolerance = kOver;
    engine.offers.push_back(offer);
  }
  return engine;
}
Declaration promising_least_penetration() {
  Declaration engine = engine_of();
  for (Offer& offer : engine.offers) offer.start_normal = engine::StartNormal::least_penetration;
  return engine;
}

// `fields`: the fields of the answer except schema and id.
Judgement judged(const Declaration& engine, const Case& problem, const std::string& fields) {
  const std::string line =
      R"({"schema": "graze.answer/1", "id": ")" + problem.id + R"(", "outcome": )" + fields + "}";
  const Recorded recorded(engine, {{problem.id, line}}, {});
  const std::optional<Question> question = question_of(problem);
  for (std::size_t i = 0; i < engine.offers.size(); ++i) {
    if (engine.offers[i].question != question) continue;
    const engine::Method& method = recorded.methods()[i];
    law::Truth truth(method.seen(problem));
    return law::judge(truth, method, method.answer(problem), engine::kPlain, true);
  }
  throw std::logic_error("no such question");
}
std::string bad_contact(const Declaration& engine, const Case& problem, const std::string& fields) {
  const Judgement judgement = judged(engine, problem, fields);
  EXPECT_EQ(judgement.failed + judgement.wrong + judgement.late + judgement.early + judgement.off, "");
  return judgement.bad_contact;
}

// A box of half extents 1, 2, 3, and one of 0.5 that reaches 0.25 into its face x = 1, or touches it.
Case start(double depth = 0.25) {
  Case problem = test::balls(-1);
  problem.a.shape = Box<double>{{1, 2, 3}};
  problem.b.shape = Box<double>{{0.5, 0.5, 0.5}};
  problem.b.position = {1.5 - depth, 0, 0};
  return problem;
}
// The same kinds of start with other oracles: curved bodies, and a rotating body.
Case curved_start() {
  Case problem = start();
  problem.b.shape = Ellipsoid<double>{{0.5, 0.25, 0.25}};
  return problem;
}
Case turning_start() {
  Case problem = start();
  problem.spin_b.rotation = {0, 0, 1};
  return problem;
}

TEST(AStartInContact, NeedsNoNormalAndNoWitnesses) {
  for (const Case& problem : {start(), start(0), curved_start(), turning_start()}) {
    EXPECT_EQ(bad_contact(engine_of(), problem, R"("initially_overlapping")"), "");
    EXPECT_EQ(bad_contact(engine_of(), problem, R"("initially_overlapping", "normal": [0, 0, 0])"), "");
  }
}

TEST(AStartInContact, HasAUnitNormalIfAny) {
  for (const Case& problem : {start(), start(0), curved_start(), turning_start()}) {
    // Any direction: its meaning is up to the engine.
    EXPECT_EQ(bad_contact(engine_of(), problem, R"("initially_overlapping", "normal": [0, -1, 0])"), "");
    const Judgement shrunk =
        judged(engine_of(), problem, R"("initially_overlapping", "normal": [0.83, 0, 0])");
    EXPECT_EQ(shrunk.failure, engine::Failure::out_of_range) << shrunk.failed;
    EXPECT_NE(shrunk.failed.find("the normal of a start in contact has length 0.83"), std::string::npos)
        << shrunk.failed;
    EXPECT_EQ(judged(engine_of(), problem, R"("initially_overlapping", "normal": [1, "nan", 0])").failure,
              engine::Failure::non_finite);
    // By more than what it is held to, if by less than any scalar's.
    EXPECT_NE(bad_contact(engine_of(), problem, R"("initially_overlapping", "normal": [1.00001, 0, 0])"), "");
  }
}

TEST(AStartInContact, HasWitnessesInItsBodies) {
  const auto points = [](const std::string& a, const std::string& b) {
    return R"("initially_overlapping", "point_a": )" + a + R"(, "point_b": )" + b;
  };
  for (const Case& problem : {start(), curved_start(), turning_start()}) {
    // On the surfaces, and one point within both.
    EXPECT_EQ(bad_contact(engine_of(), problem, points("[1, 0, 0]", "[0.75, 0, 0]")), "");
    EXPECT_EQ(bad_contact(engine_of(), problem, points("[0.8, 0, 0]", "[0.8, 0, 0]")), "");
    EXPECT_NE(bad_contact(engine_of(), problem, points("[1.1, 0, 0]", "[0.75, 0, 0]")), "");
    EXPECT_NE(bad_contact(engine_of(), problem, points("[1, 0, 0]", "[0.65, 0, 0]")), "");
    EXPECT_EQ(judged(engine_of(), problem, R"("initially_overlapping", "point_a": [1, 0, 0])").failure,
              engine::Failure::garbage);
  }
}

TEST(AStartInContact, HasTheNormalThatIsPromised) {
  const Declaration engine = promising_least_penetration();
  const auto normal = [](const std::string& n) { return R"("initially_overlapping", "normal": )" + n; };
  for (const Case& problem : {start(), start(0), curved_start(), turning_start()}) {
    EXPECT_EQ(bad_contact(engine, problem, normal("[1, 0, 0]")), "");
    EXPECT_NE(bad_contact(engine, problem, normal("[-1, 0, 0]")), "");
    EXPECT_NE(bad_contact(engine, problem, normal("[0, 1, 0]")), "");
  }
  // Near enough to be a start by its target distance: the normal parts the bodies that are rounded by it.
  Case near = start(-0.125);
  near.target_distance = 0.25;
  EXPECT_EQ(bad_contact(engine, near, normal("[1, 0, 0]")), "");
  EXPECT_NE(bad_contact(engine, near, normal("[0, 1, 0]")), "");
}

// The ball of radius 0.5 comes along x and touches the one of radius 1 at x = 1.5, with the margin between
// them at 1.75.
std::string hit(double x, double a, double b) {
  return R"("hit", "time": )" + std::to_string((4 - x) / 5) + R"(, "normal": [1, 0, 0], "point_a": [)" +
         std::to_string(a) + R"(, 0, 0], "point_b": [)" + std::to_string(b) + ", 0, 0]";
}

TEST(AMargin, IsGrantedToTheWitnessesOfACast) {
  const Declaration engine = engine_of(kMargin);
  Case turning = test::hit();
  turning.spin_b.rotation = {0, 0, 1};
  for (const Case& problem : {test::hit(), turning}) {
    // On the balls, halfway, and all of it on one of them.
    for (const auto& [a, b] : {std::pair{1.0, 1.25}, {1.125, 1.125}, {1.25, 1.25}, {1.0, 1.0}}) {
      EXPECT_EQ(bad_contact(engine, problem, hit(1.75, a, b)), "") << a << " " << b;
    }
    EXPECT_NE(bad_contact(engine, problem, hit(1.75, 1.26, 1.25)), "");
    EXPECT_NE(bad_contact(engine, problem, hit(1.75, 1.0, 0.99)), "");
    // One that declares none has none.
    EXPECT_EQ(bad_contact(engine_of(), problem, hit(1.5, 1.0, 1.0)), "");
    EXPECT_NE(bad_contact(engine_of(), problem, hit(1.5, 1.125, 1.0)), "");
  }
}

TEST(AMargin, IsInTheUnitOfTheCase) {
  Declaration engine = engine_of(kMargin);
  Case small = test::hit();
  EXPECT_EQ(bad_contact(engine, small, hit(1.75, 1.25, 1.0)), "");
  engine.margin = kMargin / 4;
  EXPECT_NE(bad_contact(engine, small, hit(1.5625, 1.25, 1.0)), "");
}

TEST(AMargin, IsGrantedToTheWitnessesOfQueries) {
  const Declaration engine = engine_of(kMargin);
  const auto points = [](double a, double b) {
    return R"(, "normal": [1, 0, 0], "point_a": [)" + std::to_string(a) + R"(, 0, 0], "point_b": [)" +
           std::to_string(b) + ", 0, 0]";
  };
  for (const bool curved : {false, true}) {
    Case problem = test::balls(0);
    if (curved) problem.b.shape = Ellipsoid<double>{{0.5, 0.5, 0.25}};
    // The balls are 2.5 apart, with the margin 2.25.
    problem.query = Query::distance;
    const std::string apart = R"("miss", "distance": 2.25)";
    for (const auto& [a, b] : {std::pair{1.0, 3.5}, {1.125, 3.375}, {1.25, 3.5}, {1.0, 3.25}})
      EXPECT_EQ(bad_contact(engine, problem, apart + points(a, b)), "") << a << " " << b;
    EXPECT_NE(bad_contact(engine, problem, apart + points(1.26, 3.5)), "");
    EXPECT_NE(bad_contact(engine, problem, apart + points(1.0, 3.24)), "");
    // On their bodies, and nearer to each other than these are.
    EXPECT_NE(bad_contact(engine, problem, apart + points(1.25, 3.25)), "");
    // Their centres are 1 apart: 0.5 deep, with the margin 0.75.
    problem.query = Query::penetration;
    problem.b.position = {1, 0, 0};
    const std::string deep = R"("initially_overlapping", "depth": 0.75)";
    for (const auto& [a, b] : {std::pair{1.0, 0.5}, {1.125, 0.375}, {1.25, 0.5}, {1.0, 0.25}})
      EXPECT_EQ(bad_contact(engine, problem, deep + points(a, b)), "") << a << " " << b;
    EXPECT_NE(bad_contact(engine, problem, deep + points(1.26, 0.5)), "");
    EXPECT_NE(bad_contact(engine, problem, deep + points(1.0, 0.24)), "");
  }
}

}  // namespace
}  // namespace graze::external
