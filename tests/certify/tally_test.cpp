// A row of the certification table breaks its guarantee when, and only when, it should.
#include "certify/tally.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace graze::tool {
namespace {

using law::Judgement;

const engine::Guarantee kRow{.method = "gjk",
                             .scalar = "double",
                             .tier = "standard",
                             .kappa_polytope = 1024,
                             .kappa_rounded = 1024,
                             .stall_cap = 0.01,
                             .mechanism = "a test"};

const engine::Method kMethod{.name = "gjk", .scalar = "double", .tier = "standard", .guarantee = &kRow};

Tally tally_of(std::size_t good, const std::vector<Judgement>& bad, const engine::Method& method = kMethod) {
  Tally tally{.method = &method, .family = "made-up"};
  const auto add = [&](const std::string& id, const Judgement& judgement) {
    corpus::Case problem;
    problem.id = id;
    tally.add(problem, judgement);
  };
  for (std::size_t i = 0; i < good; ++i) add("good/" + std::to_string(i), {});
  for (std::size_t i = 0; i < bad.size(); ++i) add("bad/" + std::to_string(i), bad[i]);
  return tally;
}

// However many of its parts are.
TEST(Tally, CountsAnAnswerAtFaultOnce) {
  Judgement bad;
  bad.late = bad.off = "by a metre";
  Tally tally = tally_of(3, {bad});
  EXPECT_EQ(tally.at_fault, 1U);
  tally.add(tally_of(1, {bad, bad}));
  EXPECT_EQ(tally.at_fault, 3U);
}

TEST(Breaches, NoneWhereNothingIsAtFault) { EXPECT_TRUE(breaches(tally_of(10, {})).empty()); }

TEST(Breaches, EveryKindOfFaultIsNamedWithItsRowAndFirstCase) {
  for (const law::FaultKind& kind : law::kFaultKinds) {
    Judgement faulty;
    faulty.*kind.why = "the reason";
    const std::vector<std::string> lines = breaches(tally_of(3, {faulty, faulty}));
    ASSERT_EQ(lines.size(), 1U) << kind.name;
    EXPECT_EQ(lines[0], std::string("gjk/double standard, made-up: 2 ") + kind.sentence +
                            " of 5; the first is bad/0: the reason");
  }
}

TEST(Breaches, AnAnswerHasOneFaultTheWorstAndTheOthersInBrackets) {
  Judgement faulty;
  faulty.late = "by a metre";
  faulty.off = faulty.bad_contact = faulty.work = "as well";
  const Tally tally = tally_of(3, {faulty});
  EXPECT_EQ(tally.at_fault, 1U);
  const std::vector<std::string> lines = breaches(tally);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("1 late of 4; the first is bad/0: by a metre (also off, contact off, work)"),
            std::string::npos)
      << lines[0];
}

TEST(Tally, KeepsTheCaseThatTookTheMostSupports) {
  Judgement cheap, dear;
  cheap.supports = 7;
  dear.supports = 300;
  Tally tally = tally_of(1, {cheap, dear, cheap});
  EXPECT_EQ(tally.most_supports.value, 300);
  EXPECT_EQ(tally.most_supports.id, "bad/1");
}

TEST(Tally, CountsOpenAnswersThatTheGuaranteeGrantsToo) {
  Judgement tie, stall;
  tie.outcome = stall.outcome = Outcome::not_converged;
  tie.within_tolerance = stall.stalled = true;
  const Tally tally = tally_of(98, {tie, stall});
  EXPECT_EQ(tally.left_open, 2U);
  EXPECT_EQ(tally.stalled, 1U);
}

TEST(Tally, SaysThatTooManyQuestionsAreDeclined) {
  Judgement declined;
  declined.skipped = declined.declined = true;
  EXPECT_EQ(declines(tally_of(9, {declined})), "");
  const Tally tally = tally_of(8, {declined});
  EXPECT_EQ(tally.cases, 8U);
  EXPECT_EQ(tally.skipped, 0U);
  EXPECT_EQ(declines(tally), "gjk/double declines 1 of 9 questions (11 %)");
}

TEST(Breaches, StallsBreakARowOnlyAboveTheirCap) {
  Judgement stall;
  stall.stalled = true;
  EXPECT_TRUE(breaches(tally_of(99, {stall})).empty());
  const std::vector<std::string> lines = breaches(tally_of(98, {stall, stall}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("bad/0"), std::string::npos);
}

TEST(Breaches, VerdictsWithinToleranceBreakNothingAndAreCounted) {
  Judgement close;
  close.within_tolerance = true;
  const Tally tally = tally_of(0, {close});
  EXPECT_EQ(tally.within_tolerance, 1U);
  EXPECT_TRUE(breaches(tally).empty());
}

TEST(Breaches, AMethodWithoutARowPromisesNothing) {
  Judgement wrong;
  wrong.wrong = "reason";
  engine::Method without_row = kMethod;
  without_row.guarantee = nullptr;
  EXPECT_TRUE(breaches(tally_of(0, {wrong}, without_row)).empty());
}

}  // namespace
}  // namespace graze::tool
