// The rotating methods as engines: every one of them, in its scalar.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "corpus/format/case_io.hpp"
#include "engines/guarantees.hpp"
#include "engines/method.hpp"
#include "tests/shared/rotating_cases.hpp"

namespace graze::engine {
namespace {

using test::dipping_bar;
using test::spinning_ball;
using test::turning_bar;
using test::turning_bar_above;

// The root of sin x + cos(x)/4 = 0.7, by halving. x over pi/2 is the time.
double contact_of_turning_bar() {
  double low = 0, high = 1;
  while (high - low > 1e-16 && low + (high - low) / 2 > low && low + (high - low) / 2 < high) {
    const double x = low + (high - low) / 2;
    (std::sin(x) + std::cos(x) / 4 < 0.7 ? low : high) = x;
  }
  return low / 1.5707963267948966;
}

TEST(RotatingMethods, AreSevenInBothScalarsAndEachHasARow) {
  EXPECT_EQ(methods(Kind::rotating).size(), 14U);
  for (const char* name :
       {"steps", "spheres", "ca", "bilateral", "bilateral_published", "plan", "certified"}) {
    const Method* in_double = find_method(Kind::rotating, name);
    const Method* in_float = find_method(Kind::rotating, std::string(name) + "/float");
    ASSERT_NE(in_double, nullptr) << name;
    ASSERT_NE(in_float, nullptr) << name;
    EXPECT_EQ(in_double->scalar, "double");
    EXPECT_EQ(in_float->unit_roundoff, 0x1p-24);
    for (const Method* method : {in_double, in_float}) {
      EXPECT_EQ(method->is_certified(), name == std::string("certified"));
      EXPECT_NE(find_guarantee(guarantees(), *method), nullptr) << method->full_name();
    }
  }
  EXPECT_EQ(find_method(Kind::rotating, "gjk"), nullptr);
}

TEST(RotatingMethods, FindTheContactOfABarThatTurnsInTheirOwnPrecision) {
  const double toi = contact_of_turning_bar();
  for (const Method& method : methods(Kind::rotating)) {
    const Answer answer = method.ask(turning_bar(), {.request = Request::everything});
    ASSERT_EQ(answer.outcome, Outcome::hit) << method.full_name();
    // The published method stops within its slop, 0.005 of a scale of 6. The edge falls faster than 1 per
    // unit of t.
    const double slack = method.name == "bilateral_published" ? 0.04
                         : method.is_certified()              ? 1e-8 + 4 * method.unit_roundoff
                                                              : 1e4 * method.unit_roundoff;
    EXPECT_NEAR(answer.toi_lower, toi, slack) << method.full_name();
    EXPECT_EQ(answer.toi_lower,
              method.scalar == "float" ? static_cast<float>(answer.toi_lower) : answer.toi_lower);
    EXPECT_EQ(answer.plan.effects, Effects::rotating);
    EXPECT_NEAR(answer.normal.y(), -1, 1e-3) << method.full_name();
    EXPECT_EQ(answer.hidden_motion > 0, method.name == "steps" || method.name == "spheres");
  }
}

TEST(RotatingMethods, ThatProveWhatTheySkipSeeAContactBetweenTheEndsOfTheStep) {
  for (const Method& method : methods(Kind::rotating)) {
    const Answer dips = method.ask(dipping_bar(), {}), above = method.ask(turning_bar_above(), {});
    EXPECT_EQ(above.outcome, Outcome::miss) << method.full_name();
    if (method.name == "bilateral_published") continue;
    EXPECT_EQ(dips.outcome, Outcome::hit) << method.full_name();
    EXPECT_LT(dips.toi_lower, 0.5);
  }
}

TEST(RotatingMethods, StepsPassWhatIsSmallerThanTheMotionBetweenTwo) {
  const Method& steps = *find_method(Kind::rotating, "steps");
  const Answer coarse = steps.ask(dipping_bar(), {.time_steps = 1});
  EXPECT_EQ(coarse.outcome, Outcome::miss);
  EXPECT_GT(coarse.hidden_motion, 1.0);  // the ends of the bar go half around
}

TEST(RotatingMethods, SeeTheCaseRoundedToTheirScalarTheSpinToo) {
  corpus::Case problem = turning_bar();
  problem.spin_a.pivot = {0.1, 0, 0};
  for (const Method& method : methods(Kind::rotating)) {
    const corpus::Case seen = method.seen(problem);
    EXPECT_EQ(corpus::same_case(seen, problem), method.scalar == "double");
    if (method.scalar == "float") {
      EXPECT_EQ(seen.spin_a.rotation.z(), static_cast<double>(1.5707963267948966F));
      EXPECT_EQ(seen.spin_a.pivot.x(), static_cast<double>(0.1F));
    }
  }
}

TEST(RotatingMethods, ThePlanLeavesOutASpinThatCannotBeSeenUntilTheEconomyIsSwitchedOff) {
  const Method& plan = *find_method(Kind::rotating, "plan");
  const Answer spared = plan.ask(spinning_ball(), {});
  EXPECT_EQ(spared.plan.effects, Effects::linear);
  EXPECT_TRUE(spared.plan.has(PlanReason::unseen_spin_b));
  EXPECT_EQ(spared.counters.poses, 0);
  const Answer full = plan.ask(spinning_ball(), {.economies = Economies::none()});
  EXPECT_EQ(full.plan.effects, Effects::rotating);
  EXPECT_GT(full.counters.poses, 0);
  for (const Answer* answer : {&spared, &full}) {
    EXPECT_EQ(answer->outcome, Outcome::hit);
    EXPECT_NEAR(answer->toi_lower, 0.1, 1e-12);
  }
  EXPECT_EQ(plan.plan(spinning_ball(), {}).effects, Effects::linear);
}

TEST(RotatingMethods, GiveAProofAndATimeOnlyToThoseWhoAsk) {
  for (const Method& method : methods(Kind::rotating)) {
    EXPECT_FALSE(method.ask(turning_bar(), {}).rotating_proof.has_value()) << method.full_name();
  }
  const Answer asked =
      find_method(Kind::rotating, "certified")->ask(turning_bar(), {.request = Request::everything});
  ASSERT_TRUE(asked.rotating_proof.has_value());
  EXPECT_GE(asked.rotating_proof->toi_lower, asked.toi_lower);
  EXPECT_GT(find_method(Kind::rotating, "bilateral")->time_ns(turning_bar(), {}, 1), 0);
}

TEST(RotatingMethods, NeverAnswerAnotherQuestionSilently) {
  corpus::Case overlap = turning_bar(), ray = turning_bar();
  overlap.query = corpus::Query::overlap;
  ray.t_max = kInfinity<double>;
  EXPECT_FALSE(unsupported(Kind::rotating, overlap).empty());
  EXPECT_TRUE(unsupported(Kind::rotating, ray).empty());
  for (const Method& method : methods(Kind::rotating)) {
    EXPECT_EQ(method.ask(overlap, {}).outcome, Outcome::invalid_input);
    const Answer answer = method.ask(ray, {});
    EXPECT_EQ(answer.outcome, Outcome::invalid_input) << method.full_name();
    EXPECT_EQ(answer.invalid, Invalid::not_linear) << method.full_name();
  }
  // A linear engine refuses what turns, and says why.
  EXPECT_EQ(unsupported(Kind::linear, turning_bar()), "a rotating motion");
}

TEST(GuaranteeRows, OfRotatingCastsSayWhatMayGoUnseen) {
  const Guarantee* steps = find_guarantee(guarantees(), *find_method(Kind::rotating, "steps"));
  const Guarantee* ca = find_guarantee(guarantees(), *find_method(Kind::rotating, "ca"));
  const Guarantee* published =
      find_guarantee(guarantees(), *find_method(Kind::rotating, "bilateral_published"));
  const Guarantee* certified = find_guarantee(guarantees(), *find_method(Kind::rotating, "certified"));
  EXPECT_EQ(steps->may_miss, Unseen::hidden_motion);
  EXPECT_EQ(ca->may_miss, Unseen::nothing);
  EXPECT_EQ(ca->may_be_late, Unseen::nothing);
  EXPECT_EQ(published->may_miss, Unseen::anything);
  EXPECT_FALSE(published->mechanism.empty());
  EXPECT_EQ(certified->width, 1e-9);
  EXPECT_EQ(certified->kappa_polytope, 0);
  // The linear rows of the same names are others.
  EXPECT_NE(find_guarantee(guarantees(), *find_method(Kind::linear, "ca")), ca);
}

TEST(GuaranteeRows, ThatLetSomethingGoUnseenNameTheMechanismAndAreAboutRotatingCasts) {
  const auto row = [](const std::string& fields) {
    return R"({"schema": "graze.guarantees/1", "rows": [{"method": "steps", "scalar": "double", "tier": "standard",
      "kappa_polytope": 1, "kappa_rounded": 1, "stall_cap": 0, )" +
           fields + "}]}";
  };
  EXPECT_NO_THROW((void)parse_guarantees(
      row(R"("query": "rotating", "may_miss": "hidden_motion", "mechanism": "between steps")")));
  EXPECT_THROW(
      (void)parse_guarantees(row(R"("query": "rotating", "may_miss": "hidden_motion", "mechanism": "")")),
      std::runtime_error);
  EXPECT_THROW(
      (void)parse_guarantees(row(R"("query": "rotating", "may_be_late": "a bit", "mechanism": "x")")),
      std::runtime_error);
  EXPECT_THROW((void)parse_guarantees(row(R"("may_miss": "anything", "mechanism": "x")")),
               std::runtime_error);
}

}  // namespace
}  // namespace graze::engine
