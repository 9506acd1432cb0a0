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
    tally.add(problem, judgement, {});
  };
  for (std::size_t i = 0; i < good; ++i) add("good/" + std::to_string(i), {});
  for (std::size_t i = 0; i < bad.size(); ++i) add("bad/" + std::to_string(i), bad[i]);
  return tally;
}

// However many of its parts are.
TEST(Tally, counts_an_answer_at_fault_once) {
  Judgement bad;
  bad.late = bad.off = "by a metre";
  Tally tally = tally_of(3, {bad});
  EXPECT_EQ(tally.at_fault, 1U);
  tally.add(tally_of(1, {bad, bad}));
  EXPECT_EQ(tally.at_fault, 3U);
}

TEST(Breaches, none_where_nothing_is_at_fault) { EXPECT_TRUE(breaches(tally_of(10, {})).empty()); }

TEST(Breaches, every_kind_of_fault_is_named_with_its_row_and_first_case) {
  Judgement faulty;
  faulty.wrong = "reason-wrong";
  faulty.late = "reason-late";
  faulty.off = "reason-off";
  faulty.bad_contact = "reason-contact";
  faulty.false_proof = "reason-proof";
  const Tally tally = tally_of(3, {faulty, faulty});
  const std::vector<std::string> lines = breaches(tally);
  ASSERT_EQ(lines.size(), 5U);
  for (const char* reason : {"reason-wrong", "reason-late", "reason-off", "reason-contact", "reason-proof"}) {
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with("gjk/double standard, made-up: 2 ") &&
             line.find("bad/0") != std::string::npos && line.find(reason) != std::string::npos;
    })) << reason;
  }
}

TEST(Breaches, stalls_break_a_row_only_above_their_cap) {
  Judgement stall;
  stall.stalled = true;
  EXPECT_TRUE(breaches(tally_of(99, {stall})).empty());
  const std::vector<std::string> lines = breaches(tally_of(98, {stall, stall}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("bad/0"), std::string::npos);
}

TEST(Breaches, excused_verdicts_break_nothing_and_are_counted) {
  Judgement excused;
  excused.excused = true;
  const Tally tally = tally_of(0, {excused});
  EXPECT_EQ(tally.excused, 1U);
  EXPECT_TRUE(breaches(tally).empty());
}

TEST(Breaches, a_method_without_a_row_promises_nothing) {
  Judgement wrong;
  wrong.wrong = "reason";
  engine::Method without_row = kMethod;
  without_row.guarantee = nullptr;
  EXPECT_TRUE(breaches(tally_of(0, {wrong}, without_row)).empty());
}

}  // namespace
}  // namespace graze::tool
