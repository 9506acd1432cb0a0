// A library that is called in bytes gets the same questions as one that is called in lines and is judged
// alike. A fault within it is found in the same way as a fault of a program.
#include "certify/external/frames.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "balls.hpp"
#include "certify/external/engine.hpp"
#include "engines/adapter/host_frames.hpp"

namespace graze::external {
namespace {

using engine::Answer;
using engine::Failure;

EngineOptions library(const char* file, bool frames) {
  EngineOptions options{.command = file, .library_host = {ENGINE_HOST}, .host_takes_frames = frames};
  options.limits.time = std::chrono::milliseconds(2000);
  return options;
}

std::vector<Shape<double>> shapes() {
  using V = Vec3<double>;
  const std::vector<V> corners = {V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)};
  const Shape<double> hull = Hull<double>(std::span<const V>(corners));
  return {Point<double>{},
          Segment<double>{V(0, 0, 1), V(1, 0, 0)},
          Triangle<double>{V(0, 0, 1), V(1, 0, 0), V(0, 1, 0)},
          Sphere<double>{0.25},
          Capsule<double>{0.25, 0.5},
          Cylinder<double>{0.25, 0.5},
          Cone<double>{0.25, 0.5},
          Box<double>{{1, 2, 3}},
          Ellipsoid<double>{{1, 2, 3}},
          hull,
          posed<double>(Box<double>{{1, 2, 3}}, V(0.1, 0.2, 0.3), {0.5, 0.5, 0.5, -0.5}),
          rounded<double>(hull, 0.125),
          sum<double>(Box<double>{{1, 2, 3}}, Sphere<double>{0.5}),
          hull_of<double>(Segment<double>{V(0, 0, 1), V(1, 0, 0)}, hull)};
}

corpus::Case pair_of(const Shape<double>& a, const Shape<double>& b) {
  corpus::Case problem = test::balls(-5);
  problem.a.shape = a;
  problem.b.shape = b;
  problem.a.orientation = {0.6, 0, 0.8, 0};
  problem.a.displacement = {0.5, 0.25, 1.0 / 3};
  problem.spin_b = {.rotation = {0.1, 0.2, 0.3}, .pivot = {1, 2, 3}};
  problem.t_max = 2;
  problem.target_distance = 0.0625;
  problem.start_policy = StartPolicy::pass_over;
  return problem;
}

std::string text_of(const Answer& answer) {
  std::string text = answer.message + to_text(answer.outcome).data();
  const auto add = [&](double x) { text += fmt::format(" {}", x); };
  for (const double x : {answer.toi_lower, answer.toi_upper}) add(x);
  for (const Vec3<double>& v : {answer.normal, answer.point_a, answer.point_b}) {
    for (const double x : v) add(x);
  }
  for (const auto& length : {answer.separation, answer.depth}) {
    if (length) add(length->lower), add(length->upper);
  }
  return text;
}

TEST(Frames, TellWhatLinesTell) {
  Engine by_lines(library(ECHO_LIBRARY, false)), by_frames(library(ECHO_LIBRARY, true));
  ASSERT_EQ(by_lines.methods().size(), 5U);
  std::set<std::string> heard;
  std::size_t asked = 0;
  for (const Shape<double>& a : shapes()) {
    for (const Shape<double>& b : {Shape<double>(Point<double>{}), a}) {
      for (std::size_t m = 0; m < by_lines.methods().size(); ++m) {
        corpus::Case problem = pair_of(a, b);
        const engine::Method& method = by_lines.methods()[m];
        // The ray and rotating methods do not know a target distance.
        if (method.name.ends_with("-ray")) problem.target_distance = 0;
        if (method.kind == engine::Kind::rotating) problem.target_distance = 0;
        if (!method.refuses(problem).empty()) continue;
        const Answer one = method.ask(problem, {}), two = by_frames.methods()[m].ask(problem, {});
        ASSERT_EQ(one.failure, Failure::none) << one.message;
        ASSERT_EQ(two.failure, Failure::none) << two.message;
        EXPECT_EQ(text_of(one), text_of(two)) << method.question_name();
        heard.insert(text_of(one));
        ++asked;
      }
    }
  }
  // All questions differ, except that for two points both passes of the loop ask the same one.
  EXPECT_GT(asked, 100U);
  EXPECT_GE(heard.size() + 5, asked);
}

TEST(Frames, FindACrashAndGoOn) {
  Engine engine(library(BALL_LIBRARY, true));
  const engine::Method& cast = engine.methods().front();
  EXPECT_EQ(cast.answer(test::hit()).toi_lower, 0.5);
  corpus::Case fall = test::hit();
  fall.b.shape = Sphere<double>{13};
  fall.b.position = {40, 0, 0};
  const Answer crash = cast.answer(fall);
  EXPECT_EQ(crash.failure, Failure::crashed) << crash.message;
  EXPECT_NE(crash.message.find("SIGABRT"), std::string::npos) << crash.message;
  corpus::Case hang = fall;
  hang.b.shape = Sphere<double>{17};
  const Answer hung = cast.answer(hang);
  EXPECT_EQ(hung.failure, Failure::hung) << hung.message;
  EXPECT_EQ(cast.answer(test::hit()).toi_lower, 0.5);
  EXPECT_EQ(engine.finish(), 0);
}

TEST(Frames, AskForATime) {
  Engine engine(library(BALL_LIBRARY, true));
  const Answer timed = engine.ask(engine.declaration().offers.front(), test::hit(), 100);
  ASSERT_TRUE(timed.ns);
  EXPECT_GT(*timed.ns, 0);
  EXPECT_FALSE(engine.ask(engine.declaration().offers.front(), test::hit()).ns);
}

// An answer of a frame as read, of a ball that is hit.
Answer read(const std::function<void(adapter::frames::AnswerFrame&)>& change) {
  Engine engine(library(BALL_LIBRARY, true));
  const Offer& offer = engine.declaration().offers.front();
  const Terms terms = in_terms_of(engine.declaration(), offer, test::hit(), true);
  adapter::frames::AnswerFrame frame;
  frame.id = 7;
  frame.outcome = GRAZE_ENGINE_HIT;
  frame.answer.time = 0.5;
  frame.answer.time_upper = std::nan("");
  frame.answer.normal[0] = 1;
  change(frame);
  return read_answer_frame({reinterpret_cast<const char*>(&frame), sizeof frame}, 7, offer, terms);
}

TEST(Frames, AreHeldToWhatLinesAre) {
  EXPECT_EQ(read([](auto&) {}).toi_lower, 0.5);
  EXPECT_EQ(read([](auto& f) { f.answer.time = std::nan(""); }).failure, Failure::non_finite);
  EXPECT_EQ(read([](auto& f) { f.answer.time = kInfinity<double>; }).failure, Failure::non_finite);
  EXPECT_EQ(read([](auto& f) { f.answer.time = -0.25; }).failure, Failure::out_of_range);
  EXPECT_EQ(read([](auto& f) { f.answer.time_upper = 0.25; }).failure, Failure::out_of_range);
  EXPECT_EQ(read([](auto& f) { f.answer.normal[1] = 2; }).failure, Failure::out_of_range);
  EXPECT_EQ(read([](auto& f) { f.answer.normal[1] = std::nan(""); }).failure, Failure::non_finite);
  EXPECT_EQ(read([](auto& f) { f.outcome = 99; }).failure, Failure::garbage);
  EXPECT_EQ(read([](auto& f) { f.magic = 1; }).failure, Failure::garbage);
  EXPECT_EQ(read([](auto& f) { f.id = 8; }).failure, Failure::wrong_id);
  EXPECT_TRUE(read([](auto& f) { f.outcome = GRAZE_ENGINE_UNSUPPORTED; }).declined);
}

}  // namespace
}  // namespace graze::external
