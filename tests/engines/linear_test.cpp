// The engine table, with every method in its scalar, and the table of their guarantees.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "corpus/format/case_io.hpp"
#include "engines/guarantees.hpp"
#include "engines/method.hpp"

namespace graze::engine {
namespace {

// B falls by 10 onto A, from 1 above it, in numbers that float has to round.
corpus::Case falling_ball() {
  corpus::Case problem;
  problem.id = "test/falling-ball";
  problem.a.shape = Box<double>{{1, 1, 0.1}};
  problem.b.shape = Sphere<double>{0.3};
  problem.b.position = {0.1, 0.2, 1.4};
  problem.b.displacement = {0, 0, -10};
  return problem;
}

// The same with a cube: a case that every method answers.
corpus::Case falling_cube() {
  corpus::Case problem = falling_ball();
  problem.b.shape = Box<double>{{0.3, 0.3, 0.3}};
  return problem;
}

TEST(Methods, AreCaGjkMprCertifiedAndExactInBothScalars) {
  EXPECT_EQ(methods(Kind::linear).size(), 10U);
  for (const char* name : {"ca", "gjk", "mpr", "certified", "exact"}) {
    ASSERT_NE(find_method(Kind::linear, name), nullptr);
    EXPECT_EQ(find_method(Kind::linear, name)->scalar, "double");
    const Method* in_float = find_method(Kind::linear, std::string(name) + "/float");
    ASSERT_NE(in_float, nullptr);
    EXPECT_EQ(in_float->unit_roundoff, 0x1p-24);
    const std::string tier = name;
    EXPECT_EQ(in_float->tier, tier == "exact" || tier == "certified" ? tier : "standard");
  }
  EXPECT_EQ(find_method(Kind::linear, "mp"), nullptr);
}

TEST(Methods, HitInTheirOwnPrecision) {
  for (const Method& method : methods(Kind::linear)) {
    const Answer answer = method.ask(falling_cube(), {.request = Request::everything});
    ASSERT_EQ(answer.outcome, Outcome::hit) << method.full_name();
    EXPECT_NEAR(answer.toi_lower, 0.1, 1024 * method.unit_roundoff) << method.full_name();
    EXPECT_EQ(answer.toi_lower,
              method.scalar == "float" ? static_cast<float>(answer.toi_lower) : answer.toi_lower);
  }
}

TEST(Methods, SeeTheCaseRoundedToTheirScalar) {
  const corpus::Case problem = falling_ball();
  for (const Method& method : methods(Kind::linear)) {
    const corpus::Case seen = method.seen(problem);
    EXPECT_EQ(corpus::same_case(seen, problem), method.scalar == "double");
    if (method.scalar == "float") {
      EXPECT_EQ(seen.b.position.z(), static_cast<double>(1.4F));
      EXPECT_EQ(std::get<Sphere<double>>(seen.b.shape).radius, static_cast<double>(0.3F));
    }
  }
}

TEST(Methods, NeverAnswerAnotherQuestionSilently) {
  corpus::Case spinning = falling_ball(), overlap = falling_ball();
  spinning.spin_b.rotation = {0, 1e-9, 0};
  overlap.query = corpus::Query::overlap;
  EXPECT_TRUE(unsupported(Kind::linear, falling_ball()).empty());
  for (const corpus::Case* problem : {&spinning, &overlap}) {
    EXPECT_FALSE(unsupported(Kind::linear, *problem).empty());
    for (const Method& method : methods(Kind::linear)) {
      EXPECT_EQ(method.ask(*problem, {}).outcome, Outcome::invalid_input);
    }
  }
}

TEST(Methods, PassInvalidInputOnWithItsReason) {
  corpus::Case problem = falling_ball();
  problem.b.orientation = {0, 0, 0, 0};
  for (const Method& method : methods(Kind::linear)) {
    const Answer answer = method.ask(problem, {});
    EXPECT_EQ(answer.outcome, Outcome::invalid_input);
    EXPECT_EQ(answer.invalid, Invalid::zero_quaternion);
  }
}

TEST(Methods, TakeTime) {
  for (const Method& method : methods(Kind::linear)) EXPECT_GT(method.time_ns(falling_cube(), {}, 3), 0);
}

TEST(Methods, ExactOnesRefuseWhatIsNotForTheirTier) {
  const auto asked = [](const corpus::Case& problem) {
    for (const char* name : {"exact/double", "exact/float"}) {
      const Answer answer = find_method(Kind::linear, name)->ask(problem, {});
      EXPECT_EQ(answer.invalid, is_exact_question(problem) ? Invalid::none : Invalid::not_exact);
    }
    return is_exact_question(problem);
  };
  EXPECT_TRUE(asked(falling_cube()));
  EXPECT_TRUE(asked(falling_ball()));
  corpus::Case problem = falling_cube();
  problem.target_distance = 0.5;
  EXPECT_TRUE(asked(problem));
  problem.b.shape = Cylinder<double>{1, 1};
  EXPECT_FALSE(asked(problem));
  problem = falling_cube();
  problem.a.shape = swept<double>(problem.a.shape, Vec3<double>(0, 0, 0.5));
  EXPECT_TRUE(asked(problem));
  problem.a.shape = hull_of<double>(problem.a.shape, Point<double>{});
  EXPECT_FALSE(asked(problem));
}

TEST(Queries, ExactOnesAnswerOverlapDistanceSweptOverlapAndLine) {
  int exact = 0;
  for (const Method& method : methods(Kind::query)) {
    EXPECT_NE(find_guarantee(guarantees(), method), nullptr) << method.full_name();
    if (!method.is_exact()) continue;
    ++exact;
    corpus::Case problem = falling_cube();
    problem.query = method.query;
    const Answer answer = method.answer(problem);
    const bool at_rest = method.query == corpus::Query::overlap || method.query == corpus::Query::distance;
    EXPECT_EQ(answer.outcome, at_rest ? Outcome::miss : Outcome::hit);
    EXPECT_EQ(answer.separation.has_value(), method.query == corpus::Query::distance);
    EXPECT_EQ(answer.t_in.has_value(), method.query == corpus::Query::line);
    problem.b.shape = Cylinder<double>{0.3, 0.3};
    EXPECT_EQ(method.answer(problem).invalid, Invalid::not_exact);
  }
  EXPECT_EQ(exact, 8);
}

TEST(Guarantees, HaveARowForEveryMethod) {
  for (const Method& method : methods(Kind::linear)) {
    EXPECT_NE(find_guarantee(guarantees(), method), nullptr) << method.full_name();
  }
}

TEST(Guarantees, HoldSpheresAndTargetDistancesToTheRoundedConstant) {
  Guarantee row;
  row.kappa_polytope = 1;
  row.kappa_rounded = 2;
  corpus::Case problem = falling_ball();
  EXPECT_EQ(row.kappa(problem), 2);
  problem.b.shape = Point<double>{};
  EXPECT_EQ(row.kappa(problem), 1);
  problem.target_distance = 0.5;
  EXPECT_EQ(row.kappa(problem), 2);
  EXPECT_EQ(row.contact_kappa(problem), 2);
  row.kappa_contact = 3;
  EXPECT_EQ(row.contact_kappa(problem), 3);
}

TEST(Guarantees, AllowTierExactNothing) {
  for (const Method& method : methods(Kind::linear)) {
    if (!method.is_exact()) continue;
    const Guarantee& row = *find_guarantee(guarantees(), method);
    EXPECT_EQ(row.kappa_polytope, 0);
    EXPECT_EQ(row.kappa_rounded, 0);
    EXPECT_EQ(row.stall_cap, 0);
  }
}

TEST(Guarantees, SayHowMuchWorkAnAnswerTakesAtMost) {
  for (const Guarantee& row : guarantees()) EXPECT_TRUE(row.most_supports) << row.name();
  const auto row = parse_guarantees(R"({"schema": "graze.guarantees/1", "rows": [{"method": "ca",
    "scalar": "float", "tier": "standard", "kappa_polytope": 1, "kappa_rounded": 1, "stall_cap": 0,
    "most_supports": 256, "mechanism": ""}]})");
  EXPECT_EQ(row.at(0).most_supports, 256);
}

std::string table_with(const std::string& kappa, const std::string& more) {
  return R"({"schema": "graze.guarantees/1", "rows": [{"method": "ca", "scalar": "float", "tier": "standard",
             "kappa_polytope": )" +
         kappa + R"(, "kappa_rounded": 1, "stall_cap": 0)" + more + "}]}";
}

// The message of the error that reading `text` throws, or empty if it is read.
std::string error_of(const std::string& text) {
  try {
    return parse_guarantees(text).empty() ? "no rows" : "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Guarantees, ARowNamesTheMechanismThatNeedsMore) {
  EXPECT_EQ(error_of(table_with("1024", R"(, "mechanism": "")")), "");
  EXPECT_NE(error_of(table_with("1025", R"(, "mechanism": "")")).find("rows[0].mechanism"),
            std::string::npos);
  EXPECT_EQ(error_of(table_with("1025", R"(, "mechanism": "so it is")")), "");
}

TEST(Guarantees, WhatIsNoRowIsRefusedByItsField) {
  EXPECT_NE(error_of(table_with("1", "")).find("mechanism"), std::string::npos);
  EXPECT_NE(error_of(table_with("-1", R"(, "mechanism": "")")).find("kappa_polytope"), std::string::npos);
  EXPECT_NE(error_of(table_with("\"1\"", R"(, "mechanism": "")")).find("kappa_polytope"), std::string::npos);
  EXPECT_NE(error_of(table_with("1", R"(, "mechanism": "", "more": 1)")).find("more"), std::string::npos);
  for (const std::string most : {"0", "-1", "1.5", "\"256\"", "2147483648"}) {
    EXPECT_NE(error_of(table_with("1", R"(, "mechanism": "", "most_supports": )" + most))
                  .find("rows[0].most_supports: must be a whole number from 1 to 2147483647"),
              std::string::npos)
        << most;
  }
  EXPECT_FALSE(error_of("{").empty());
  EXPECT_FALSE(error_of(R"({"schema": "graze.guarantees/1", "rows": []})").empty());
}

}  // namespace
}  // namespace graze::engine
