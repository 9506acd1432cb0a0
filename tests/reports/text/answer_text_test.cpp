// The two forms of an answer say the same: each line of the block is in the JSON.
#include "reports/text/answer_text.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace graze::tool {
namespace {

using Json = nlohmann::json;
using corpus::Case;
using corpus::Query;

// A number of the JSON as the block writes it. An infinite number is a string, or null where nothing is
// known.
std::string number(const Json& json) {
  if (json.is_null()) return "inf";
  return json.is_string() ? json.get<std::string>() : fmt::format("{}", json.get<double>());
}
std::string interval(const Json& json) {
  return fmt::format("[{}, {}]", number(json.at("lower")), number(json.at("upper")));
}
std::string vector(const Json& json) {
  return fmt::format("({}, {}, {})", number(json.at(0)), number(json.at(1)), number(json.at(2)));
}

// The expected line of the block, from the JSON alone. Throws for a field that the JSON has not.
std::string expected(const std::string& name, const Json& json) {
  const auto text = [&](const char* key) { return json.at(key).get<std::string>(); };
  if (name == "method") return fmt::format("{}, {}, tier {}", text("method"), text("scalar"), text("tier"));
  if (name == "outcome" || name == "because" || name == "query") return text(name.c_str());
  if (name == "toi" || name == "distance" || name == "depth" || name == "t_in" || name == "t_out")
    return interval(json.at(name));
  if (name == "normal" || name == "normal_out" || name == "point_a" || name == "point_b")
    return vector(json.at(name));
  if (name == "stalled")
    return json.at("stalled").get<bool>() ? "the bracket is wider than rounding alone would make it" : "";
  if (name == "hidden")
    return fmt::format("contacts by motions below {} may be missed", number(json.at("hidden_motion")));
  if (name == "plan") {
    std::string plan = text("plan");
    const auto reasons = json.at("reasons").get<std::vector<std::string>>();
    if (!reasons.empty()) plan += fmt::format(": {}", fmt::join(reasons, "; "));
    return plan;
  }
  if (name == "work") {
    std::string work = fmt::format("{} iterations, {} support evaluations", json.at("iterations").get<int>(),
                                   json.at("supports").get<int>());
    if (json.contains("poses")) work += fmt::format(", {} poses", json.at("poses").get<int>());
    return work;
  }
  throw std::out_of_range("no JSON is known for the line " + name);
}

// Checks every line of the block except the first, which is the id. Returns the names of the lines.
std::set<std::string> expect_said(const std::string& block, const std::string& json_line) {
  SCOPED_TRACE(block + json_line);
  const Json json = Json::parse(json_line);
  std::istringstream lines(block);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(json.at("id"), line);
  std::set<std::string> names;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string name, value;
    words >> name >> std::ws;
    names.insert(name);
    std::getline(words, value);
    try {
      EXPECT_EQ(expected(name, json), value);
    } catch (const std::exception& missing) {
      ADD_FAILURE() << name << ": " << missing.what();
    }
  }
  return names;
}

Case named() {
  Case problem;
  problem.id = "test/\"quoted\"";
  return problem;
}

constexpr Counters kWork{.iterations = 3, .supports = 7, .poses = 5};
constexpr double kInf = kInfinity<double>;

TEST(AnswerText, OfACastTheJsonSaysAllThatTheBlockSays) {
  const engine::Method& method = *engine::find_method(engine::Kind::linear, "mpr/float");
  std::set<std::string> seen;
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::initially_overlapping,
                                Outcome::not_converged, Outcome::invalid_input}) {
    for (const bool passed_over : {false, true}) {
      engine::Answer answer{.outcome = outcome,
                            .invalid = Invalid::negative_extent,
                            .toi_lower = 0.25,
                            .toi_upper = outcome == Outcome::not_converged ? kInf : 0.5,
                            .normal = {0.25, -0.5, 1e-300},
                            .point_a = {1, 2, 3},
                            .point_b = {4, 5, -0.0},
                            .passed_over = passed_over,
                            .counters = kWork};
      seen.merge(expect_said(answer_block(named(), method, answer), answer_json(named(), method, answer)));
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"method", "outcome", "because", "toi", "distance", "normal",
                                         "point_a", "point_b", "work"}));
}

TEST(AnswerText, OfARotatingCastTheJsonSaysAllThatTheBlockSays) {
  const engine::Method& method = *engine::find_method(engine::Kind::rotating, "steps/double");
  std::set<std::string> seen;
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::invalid_input}) {
    engine::Answer answer{.outcome = outcome,
                          .invalid = Invalid::not_linear,
                          .toi_lower = 0.25,
                          .toi_upper = 0.5,
                          .passed_over = outcome == Outcome::miss,
                          .counters = kWork,
                          .hidden_motion = 0.125};
    answer.plan.effects = Effects::rotating;
    answer.plan.add(PlanReason::rotation_a);
    answer.plan.add(PlanReason::unseen_spin_b);
    seen.merge(expect_said(answer_block(named(), method, answer), answer_json(named(), method, answer)));
  }
  EXPECT_TRUE(seen.contains("plan") && seen.contains("hidden") && seen.contains("because"));
}

TEST(AnswerText, OfAQueryTheJsonSaysAllThatTheBlockSays) {
  std::set<std::string> seen;
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    for (const bool stalled : {false, true}) {
      Case problem = named();
      problem.query = method.query;
      engine::Answer answer;
      answer.outcome = stalled ? Outcome::not_converged : Outcome::hit;
      answer.separation = {0.25, 0.5};
      answer.depth = {0.125, kInf};
      answer.t_in = {-kInf, -1e308};
      answer.t_out = {kInf, kInf};
      answer.normal = answer.normal_out = {0, 0, 1};
      answer.point_a = answer.point_b = {1, 2, 3};
      answer.has_points = true;
      answer.stalled = stalled;
      answer.counters = kWork;
      seen.merge(expect_said(answer_block(problem, method, answer), answer_json(problem, method, answer)));
      answer = {};
      answer.invalid = Invalid::not_exact;
      seen.merge(expect_said(answer_block(problem, method, answer), answer_json(problem, method, answer)));
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"query", "method", "outcome", "because", "distance", "depth", "t_in",
                                         "t_out", "stalled", "normal", "normal_out", "point_a", "point_b",
                                         "work"}));
}

TEST(AnswerText, OfAPlanTheJsonSaysAllThatTheBlockSays) {
  Plan plan;
  plan.effects = Effects::linear;
  plan.add(PlanReason::unseen_spin_a);
  plan.add(PlanReason::unseen_spin_b);
  const Json json = Json::parse(plan_json(named(), plan));
  std::istringstream lines(plan_block(named(), plan));
  std::string line;
  std::getline(lines, line);
  std::size_t reasons = 0;
  while (std::getline(lines, line)) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2), value = line.substr(12);
    if (name == "because") {
      EXPECT_EQ(json.at("reasons").at(reasons++), value);
    } else {
      EXPECT_EQ(json.at(name), value);
    }
  }
  EXPECT_EQ(reasons, json.at("reasons").size());
}

}  // namespace
}  // namespace graze::tool
