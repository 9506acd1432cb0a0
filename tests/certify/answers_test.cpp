// Another build of the same methods is certified by what it answers differently: which answers those are, and
// that the rows that break are those of a run that judges everything.
#include "certify/answers.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace graze::tool {
namespace {

using corpus::Case;
using engine::Answer;
using engine::Ask;
using engine::Method;

// Cubes of side 2, `number` of them at different heights before another: each pair 1 apart along x.
Suite cubes(std::size_t number) {
  Suite suite{.kind = engine::Kind::query, .family = "cubes"};
  for (std::size_t i = 0; i < number; ++i) {
    Case problem;
    problem.id = "test/cubes-" + std::to_string(i);
    problem.a.shape = problem.b.shape = Box<double>{{1, 1, 1}};
    problem.b.position = {3, static_cast<double>(i) / 16, 0};
    problem.query = corpus::Query::distance;
    suite.cases.push_back(problem);
  }
  return suite;
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
bool is_pair(const Case& problem, int i) { return problem.b.position[1] == i / 16.0; }

// Different for the pairs 2 and 3: twice not converged, or once wrong and once not converged.
Answer twice_stalled(const Case& problem, const Ask& ask) {
  Answer answer = right_answer(problem, ask);
  if (!is_pair(problem, 2) && !is_pair(problem, 3)) return answer;
  answer.separation = {0.5, 1.5};
  answer.stalled = true;
  return answer;
}
Answer once_wrong(const Case& problem, const Ask& ask) {
  Answer answer = twice_stalled(problem, ask);
  if (is_pair(problem, 2)) answer.separation = {1.25, 1.25}, answer.stalled = false;
  return answer;
}
Answer slower(const Case& problem, const Ask& ask) {
  Answer answer = right_answer(problem, ask);
  answer.counters.iterations = 7;
  return answer;
}

class KeptAnswersTest : public testing::Test {
 protected:
  // A method of which at most this share of all cases may not converge.
  Method method_by(Answer (*ask)(const Case&, const Ask&), double stall_cap) {
    row_ = {.query = "distance",
            .method = "made_up",
            .scalar = "double",
            .tier = "standard",
            .kappa_polytope = 64,
            .kappa_rounded = 64,
            .stall_cap = stall_cap,
            .mechanism = "a test"};
    return {.kind = engine::Kind::query,
            .query = corpus::Query::distance,
            .name = "made_up",
            .scalar = "double",
            .tier = "standard",
            .unit_roundoff = kUnitRoundoff<double>,
            .ask = ask,
            .seen = [](const Case& problem) { return problem; },
            .guarantee = &row_};
  }

  // The answers without the change, kept.
  KeptAnswers kept(Answer (*ask)(const Case&, const Ask&)) {
    const Method method = method_by(ask, 1);
    KeptAnswers answers(suites_, {&method}, 1);
    EXPECT_TRUE(judge_all(suites_, {.methods = {&method}}, answers).empty());
    return answers;
  }

  // The guarantees that break, judged on the differing answers alone. Sets differing_ to their number.
  std::vector<std::string> broken(Answer (*ask)(const Case&, const Ask&), double stall_cap,
                                  const KeptAnswers& before) {
    const Method method = method_by(ask, stall_cap);
    const std::vector<std::vector<bool>> differing = KeptAnswers(suites_, {&method}, 1).differ_from(before);
    differing_ = static_cast<std::size_t>(std::count(differing[0].begin(), differing[0].end(), true));
    return judge_differing(suites_, {.methods = {&method}}, before, differing);
  }

  engine::Guarantee row_;
  std::vector<Suite> suites_ = {cubes(10)};
  std::size_t differing_ = 0;
};

TEST_F(KeptAnswersTest, TheSameAnswersDifferNowhereWhateverTheyCost) {
  const KeptAnswers before = kept(&right_answer);
  for (const auto ask : {&right_answer, &slower}) {
    EXPECT_TRUE(broken(ask, 0, before).empty());
    EXPECT_EQ(differing_, 0U);
  }
}

TEST_F(KeptAnswersTest, AWrongAnswerAmongThoseThatDifferBreaksItsRow) {
  const std::vector<std::string> rows = broken(&once_wrong, 1, kept(&right_answer));
  EXPECT_EQ(differing_, 2U);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NE(rows[0].find("made_up/double standard, cubes: 1 "), std::string::npos) << rows[0];
  EXPECT_NE(rows[0].find("test/cubes-2"), std::string::npos) << rows[0];
}

// Two of ten did not converge. These two are the only answers that differ.
TEST_F(KeptAnswersTest, StallsCountAgainstAllCasesOfTheSuite) {
  const KeptAnswers before = kept(&right_answer);
  EXPECT_TRUE(broken(&twice_stalled, 0.2, before).empty());
  const std::vector<std::string> rows = broken(&twice_stalled, 0.15, before);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NE(rows[0].find("2 not converged, above the cap of 0.15, of 10"), std::string::npos) << rows[0];
}

// One unconverged answer is kept and the answer to another case differs: the share of one in ten needs no judgement.
TEST_F(KeptAnswersTest, AStallThatIsKeptCountsAndOneThatIsGoneDoesNot) {
  const KeptAnswers before = kept(&twice_stalled);
  EXPECT_TRUE(broken(&twice_stalled, 0.2, before).empty());
  EXPECT_EQ(differing_, 0U);
  EXPECT_EQ(broken(&twice_stalled, 0.15, before).size(), 1U);
  EXPECT_TRUE(broken(&right_answer, 0, before).empty());
  EXPECT_EQ(differing_, 2U);
}

TEST_F(KeptAnswersTest, AreReadAsTheyWereWrittenAndOnlyForTheSameSuites) {
  const KeptAnswers before = kept(&twice_stalled);
  std::stringstream file;
  before.write(file);
  const std::string text = file.str();
  const KeptAnswers read = KeptAnswers::read(file);
  const Method method = method_by(&right_answer, 1);
  EXPECT_EQ(read.of(0, method), before.of(0, method));
  EXPECT_EQ(read.of(0, method)[3].state, KeptAnswer::State::stalled);

  std::stringstream cut(text.substr(0, text.size() - 5)), none;
  EXPECT_THROW(KeptAnswers::read(cut), std::runtime_error);
  EXPECT_THROW(KeptAnswers::read(none), std::runtime_error);
  suites_ = {cubes(9)};
  EXPECT_THROW(broken(&right_answer, 1, read), std::runtime_error);
}

// A change of any one field gives another digest. The counters are not judged and do not change it.
TEST(AnswerDigest, SeesEveryFieldThatIsJudged) {
  Answer answer;
  answer.proof = Proof{};
  answer.rotating_proof.emplace().chain.emplace_back();
  answer.t_in = engine::Interval{1, 2};
  const std::uint64_t digest = digest_of(answer);
  const auto differs = [&](auto&& change) {
    Answer changed = answer;
    change(changed);
    return digest_of(changed) != digest;
  };
  EXPECT_FALSE(differs([](Answer& a) { a.counters.supports = 3; }));
  EXPECT_FALSE(differs([](Answer&) {}));
  EXPECT_TRUE(differs([](Answer& a) { a.toi_lower = 5e-324; }));
  EXPECT_TRUE(differs([](Answer& a) { a.point_b[2] = 1; }));
  EXPECT_TRUE(differs([](Answer& a) { a.passed_over = true; }));
  EXPECT_TRUE(differs([](Answer& a) { a.proof.reset(); }));
  EXPECT_TRUE(differs([](Answer& a) { a.proof->portal[3].b.curved[1][0] = 1; }));
  EXPECT_TRUE(differs([](Answer& a) { a.proof->factor[1].to.a.vertex = 1; }));
  EXPECT_TRUE(differs([](Answer& a) { a.rotating_proof->chain.emplace_back(); }));
  EXPECT_TRUE(differs([](Answer& a) { a.rotating_proof->chain[0].frame = AxisFrame::b; }));
  EXPECT_TRUE(differs([](Answer& a) { a.rotating_proof->weight[3] = 1; }));
  EXPECT_TRUE(differs([](Answer& a) { std::swap(a.t_in, a.t_out); }));
  EXPECT_TRUE(differs([](Answer& a) { a.plan.reasons = 1; }));
  EXPECT_TRUE(differs([](Answer& a) { a.stalled = true; }));
}

}  // namespace
}  // namespace graze::tool
