// An answer is written as JSON with the protocol's fields and no others, and the loop answers, times and
// refuses.
#include <gtest/gtest.h>
#include <graze_adapter.hpp>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>

namespace graze::adapter {
namespace {

const std::string kQuestion =
    R"({"schema": "graze.question/1", "id": "q1", "query": "distance", "a": {"shape": {"type": "point"}},
        "b": {"shape": {"type": "point"}, "position": [0, 3, 4]})";

std::string one_line(std::string text) {
  for (std::size_t at; (at = text.find('\n')) != std::string::npos;) text.erase(at, 1);
  return text;
}
std::string question(const std::string& more = "") { return one_line(kQuestion) + more + "}"; }

Answer distance(const Question& q) {
  Answer answer = Answer::miss();
  answer.distance = length(q.b.position - q.a.position);
  return answer;
}

TEST(Answers, AreWrittenInFull) {
  Answer answer = Answer::hit({0.25, 0.5});
  answer.normal = Vector{0, 1, 0};
  answer.point_a = Vector{1, 2, 3};
  answer.depth = std::nan("");
  answer.ns = 12;
  answer.message = "a \"word\"";
  EXPECT_EQ(
      write_answer("x/1", answer),
      R"({"schema": "graze.answer/1", "id": "x/1", "outcome": "hit", "time": {"lower": 0.25, "upper": 0.5}, )"
      R"("depth": "nan", "normal": [0, 1, 0], "point_a": [1, 2, 3], "ns": 12, "native": true, )"
      R"("message": "a \"word\""})");
  EXPECT_EQ(write_answer("m", Answer::miss()),
            R"({"schema": "graze.answer/1", "id": "m", "outcome": "miss"})");
}

TEST(Engines, SayWhatTheyAreAndNothingThatIsTheDefault) {
  Engine engine;
  engine.name = "mine";
  engine.scalar = Scalar::float32;
  engine.shapes = {ShapeType::sphere, ShapeType::hull_of};
  engine.queries[Query::cast].answers = {"time"};
  EXPECT_EQ(
      write_engine(engine),
      R"({"schema": "graze.engine/1", "name": "mine", "scalar": "float", "shapes": ["sphere", "hull_of"], )"
      R"("queries": {"cast": {"answers": ["time"]}}})");
  engine.queries[Query::cast].kappa = 4;
  engine.queries[Query::cast].touching = "contact";
  engine.queries[Query::cast].starts = false;
  engine.lengths = {{0.05, 10}};
  engine.relative_motion = true;
  engine.pivots = false;
  engine.most_turn = 3.125;
  engine.timed = true;
  EXPECT_EQ(
      write_engine(engine),
      R"({"schema": "graze.engine/1", "name": "mine", "scalar": "float", "shapes": ["sphere", "hull_of"], )"
      R"("queries": {"cast": {"answers": ["time"], "kappa": 4, "touching": "contact", "starts": false}}, )"
      R"("lengths": [0.05, 10], "motion": "relative", "pivots": false, "most_turn": 3.125, "timed": true})");
}

TEST(Serving, SaysWhatItIsAndAnswersLineByLine) {
  std::istringstream in(question() + "\n\n" + question() + "\n");
  std::ostringstream out;
  Engine engine;
  engine.name = "pipes";
  EXPECT_EQ(serve(engine, distance, in, out), 0);
  const std::string answer = R"({"schema": "graze.answer/1", "id": "q1", "outcome": "miss", "distance": 5})";
  EXPECT_EQ(out.str(), write_engine(engine) + "\n" + answer + "\n" + answer + "\n");
}

TEST(Serving, WhatItDoesNotKnowIsUnsupported) {
  std::string line = question();
  line.replace(line.find("\"distance\""), 10, "\"dream\"");
  EXPECT_EQ(answer_line(distance, line),
            R"({"schema": "graze.answer/1", "id": "q1", "outcome": "unsupported", )"
            R"("message": "query: \"dream\" is not known"})");
}

TEST(Serving, ALineThatIsNoQuestionEndsIt) {
  std::istringstream in("{\"half\": \n" + question() + "\n");
  std::ostringstream out;
  EXPECT_EQ(serve({}, distance, in, out), 2);
  EXPECT_EQ(out.str(), write_engine({}) + "\n");
}

TEST(Timing, CallsAsOftenAsAskedAndPreparesOnce) {
  int prepared = 0;
  int called = 0;
  const auto function = [&](const Question&) {
    ++prepared;
    return [&]() -> Answer {
      ++called;
      return Answer::miss();
    };
  };
  for (const int repeat : {1, 2, 15, 16, 100, 1000}) {
    prepared = called = 0;
    const json::Value answer =
        json::read(answer_line(function, question(", \"repeat\": " + std::to_string(repeat))));
    EXPECT_EQ(prepared, 1);
    EXPECT_EQ(called, repeat);
    EXPECT_EQ(answer.find("ns") != nullptr, repeat > 1) << repeat;
  }
}

TEST(Timing, IsOfOneCall) {
  const auto slow = [](const Question&) -> Answer {
    const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(200);
    while (std::chrono::steady_clock::now() < until) {
    }
    return Answer::miss();
  };
  const json::Value answer = json::read(answer_line(slow, question(", \"repeat\": 30")));
  EXPECT_GE(answer.find("ns")->number, 200e3);
  EXPECT_LT(answer.find("ns")->number, 20e6);  // a busy machine makes it longer
}

}  // namespace
}  // namespace graze::adapter
