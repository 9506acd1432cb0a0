// Made-up answers to one case, and a run of a few cases.
#include "reports/price/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "corpus/format/case_io.hpp"
#include "reports/price/price_run.hpp"

namespace graze::price {
namespace {

using corpus::Case;
using engine::Answer;
using engine::Kind;

// A ball of radius 1/2 falls from 3 onto a ball of radius 1/2 at 0: they touch at t = 1/2. Scale 3.
Case falling_ball() {
  Case problem;
  problem.id = "balls";
  problem.a.shape = Sphere<double>{0.5};
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = {0, 0, 3};
  problem.b.displacement = {0, 0, -4};
  return problem;
}

Measured measured(const Case& problem, const Answer& answer) {
  const engine::Method& method = *engine::find_method(Kind::linear, "gjk/double");
  Judge judge(problem, Kind::linear);
  Measured one = begun(problem, method, answer, Request::verdict);
  judge.judge(one, method, answer);
  return one;
}

Answer hit(double lower, double upper) {
  return {.outcome = Outcome::hit, .toi_lower = lower, .toi_upper = upper};
}

TEST(PriceMeasure, AnEarlyTimeErrsByItsWayAndIsNotLate) {
  const Measured one = measured(falling_ball(), hit(0.4375, 0.5));
  EXPECT_FALSE(one.wrong);
  EXPECT_FALSE(one.late);
  EXPECT_DOUBLE_EQ(one.forward, 0.25 / 3);
  EXPECT_DOUBLE_EQ(one.backward, 0.25 / 3);
  EXPECT_EQ(one.width, one.backward);
}

TEST(PriceMeasure, ALateTimeIsLateByTheDepthThatItReaches) {
  const Measured one = measured(falling_ball(), hit(0.5625, 0.5625));
  EXPECT_TRUE(one.late);
  EXPECT_DOUBLE_EQ(one.late_by, 0.25 / 3);
  // By one place, too.
  EXPECT_TRUE(measured(falling_ball(), hit(std::nextafter(0.5, 1), 0.5625)).late);
  EXPECT_FALSE(measured(falling_ball(), hit(0.5, 0.5625)).late);
}

TEST(PriceMeasure, ADeniedHitAndAClaimedMissAreWrongByWhatTheyDeny) {
  const Measured denied =
      measured(falling_ball(),
               {.outcome = Outcome::miss, .toi_lower = kInfinity<double>, .toi_upper = kInfinity<double>});
  EXPECT_TRUE(denied.wrong);
  EXPECT_GT(denied.denied, 0.1);
  EXPECT_TRUE(std::isnan(denied.backward));
  Case miss = falling_ball();
  miss.b.position = {1.25, 0, 3};
  const Measured claimed = measured(miss, hit(0.5, 0.5));
  EXPECT_TRUE(claimed.wrong);
  EXPECT_DOUBLE_EQ(claimed.denied, 0.25 / std::sqrt(9 + 1.25 * 1.25));
}

// A time that is no number is counted, and is no infinite error in a mean.
TEST(PriceMeasure, ATimeThatIsNoNumberIsAFailureOfItsOwn) {
  for (const double time : {std::nan(""), kInfinity<double>}) {
    const Measured one = measured(falling_ball(), hit(time, kInfinity<double>));
    EXPECT_TRUE(one.no_time);
    EXPECT_TRUE(std::isnan(one.backward));
    EXPECT_TRUE(std::isnan(one.forward));
    EXPECT_FALSE(one.late);
  }
  const Measured stalled = measured(
      falling_ball(), {.outcome = Outcome::not_converged, .toi_lower = 0.25, .toi_upper = kInfinity<double>});
  EXPECT_TRUE(stalled.not_converged);
  EXPECT_DOUBLE_EQ(stalled.forward, 1.0 / 3);
  EXPECT_EQ(stalled.width, stalled.backward);
  EXPECT_TRUE(measured(falling_ball(), {.outcome = Outcome::invalid_input}).refused);
}

TEST(PriceMeasure, ProofsAreCheckedAndAFalseOneDoesNotCount) {
  const Case problem = falling_ball();
  const engine::Method& method = *engine::find_method(Kind::linear, "certified/double");
  Answer answer = method.ask(problem, {.request = Request::everything});
  ASSERT_TRUE(answer.proof);
  EXPECT_TRUE(begun(problem, method, answer, Request::everything).proved);
  EXPECT_FALSE(begun(problem, method, answer, Request::verdict).proved);
  answer.proof->toi_lower = 0.75;
  EXPECT_FALSE(begun(problem, method, answer, Request::everything).proved);
}

// Its cases are floats: float and double are asked one question.
TEST(PriceTopics, CasesAreFloatsAndTheSameForOneSeed) {
  std::set<std::string> names;
  for (const Topic& topic : topics(false)) {
    EXPECT_TRUE(names.insert(topic.head.name).second) << topic.head.name;
    if (topic.head.x > 64) continue;  // large hulls: of the same draws
    const std::vector<Case> once = cases_of(topic, 3), again = cases_of(topic, 3), other = cases_of(topic, 4);
    ASSERT_EQ(once.size(), topic.cases);
    const engine::Method& in_float = *engine::find_method(Kind::linear, "gjk/float");
    for (std::size_t i = 0; i < once.size(); i += 5) {
      Case seen = in_float.seen(once[i]);
      seen.expect = once[i].expect;
      EXPECT_TRUE(corpus::same_case(seen, once[i])) << once[i].id;
      EXPECT_TRUE(corpus::same_case(once[i], again[i])) << once[i].id;
    }
    EXPECT_FALSE(corpus::same_case(once[0], other[0])) << once[0].id;
  }
}

Topic few_balls() {
  Topic topic;
  topic.head.name = "balls";
  topic.head.baseline = "gjk/double";
  topic.cases = 3;
  topic.methods = {"gjk", "mpr", "exact"};
  topic.draw = [](corpus::Random&, std::size_t place) {
    Case problem = falling_ball();
    problem.b.position[0] = 0.25 * static_cast<double>(place);
    return problem;
  };
  return topic;
}

TEST(PriceRun, ATableHasEveryContenderThatTakesACase) {
  const Topic topic = few_balls();
  const RunSettings settings{.rounds = 2};
  const PriceTable table = measure_table(topic, contenders_of(topic, {}, false), settings);
  EXPECT_EQ(table.truth.exact, 3U);
  EXPECT_NE(table.find("exact/double"), nullptr);
  const Row* gjk = table.find("gjk/double");
  const Row* loose = table.find("gjk/double 1e-01");
  ASSERT_NE(gjk, nullptr);
  ASSERT_NE(loose, nullptr);
  EXPECT_NE(table.find("mpr/float 1e-06"), nullptr);
  ASSERT_TRUE(gjk->ratio);
  EXPECT_EQ(gjk->ratio->low, 1);
  EXPECT_EQ(gjk->ratio->high, 1);
  ASSERT_TRUE(gjk->time);
  EXPECT_GT(gjk->time->median, 10);
  EXPECT_GT(gjk->supports.mean, 0);
  EXPECT_LT(gjk->backward.worst, 1e-14);
  EXPECT_LT(loose->backward.worst, 1e-13) << "balls meet in closed form, whatever the tolerance";
  EXPECT_EQ(gjk->wrong, 0U);
  EXPECT_FALSE(table.shown.empty());
  std::size_t on_front = 0;
  for (const Row& row : table.rows) on_front += row.on_front ? 1 : 0;
  EXPECT_GT(on_front, 0U);
}

// If a search has to close in, a loose tolerance is visible in the error, and is kept.
TEST(PriceRun, ALooseToleranceIsSeenWhereTheSearchClosesIn) {
  Topic topic = few_balls();
  topic.draw = [](corpus::Random&, std::size_t place) {
    Case problem = falling_ball();
    problem.b.shape = Ellipsoid<double>{{1, 0.5, 0.75}};
    problem.b.position[0] = 0.25 * static_cast<double>(place + 1);
    return problem;
  };
  const PriceTable table = measure_table(topic, contenders_of(topic, {}, false), {.rounds = 1});
  const Row* gjk = table.find("gjk/double");
  const Row* loose = table.find("gjk/double 1e-01");
  ASSERT_NE(gjk, nullptr);
  ASSERT_NE(loose, nullptr);
  EXPECT_EQ(table.find("exact/double"), nullptr) << "the exact tier takes no ellipsoid";
  EXPECT_LT(gjk->backward.worst, 1e-13);
  EXPECT_GT(loose->backward.worst, 1e-9);
  EXPECT_LT(loose->backward.worst, 0.1);
}

TEST(PriceRun, ARunThatIsStoppedKeepsWholeTablesAndGoesOnFromThere) {
  RunSettings settings{.rounds = 1, .only = {"requests smooth", "requests polytopes"}};
  bool stops = false;
  settings.stop = [&] { return stops; };
  settings.keep = [&](const Document&) { stops = true; };
  const Document half = run(settings);
  EXPECT_FALSE(half.finished);
  ASSERT_EQ(half.tables.size(), 1U);
  stops = false;
  settings.keep = [](const Document&) {};
  const Document whole = run(settings, half);
  EXPECT_TRUE(whole.finished);
  ASSERT_EQ(whole.tables.size(), 2U);
  // The earlier measurements are not repeated.
  EXPECT_EQ(whole.tables[0].rows[0].time->median, half.tables[0].rows[0].time->median);
}

}  // namespace
}  // namespace graze::price
