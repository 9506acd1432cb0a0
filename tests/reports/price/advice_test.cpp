// Checks on planted figures which contender is advised for which user.
#include "reports/price/advice.hpp"

#include <gtest/gtest.h>

#include "tests/reports/price/planted.hpp"

namespace graze::price {
namespace {

const Advice* find(const std::vector<Advice>& all, const std::string& user, const std::string& bodies) {
  for (const Advice& one : all) {
    if (one.user == user && one.bodies == bodies) return &one;
  }
  return nullptr;
}
Advice advice(const Document& document, const std::string& user, const std::string& bodies) {
  const std::vector<Advice> all = advice_of(document);
  const Advice* found = find(all, user, bodies);
  return found == nullptr ? Advice{.because = "missing"} : *found;
}

// The planted table, with a float row, so that it is one a game would ask.
Document document_in_float() {
  Document document = planted_document();
  Row row = planted_row("mpr", 1e-3, 0.2, 1e-4);
  row.label = "mpr/float 1e-03";
  row.scalar = "float";
  row.wrong = 1;
  row.denied = 1e-7;
  document.tables[0].rows.push_back(row);
  return document;
}

TEST(PriceAdvice, AGameTakesTheCheapestThatIsRightToAThousandth) {
  const Advice one = advice(document_in_float(), "a game", "that do not rotate");
  EXPECT_EQ(one.label, "mpr/float 1e-03") << one.because;
  EXPECT_EQ(one.call,
            "// Body<float>\ngraze::cast(a, b, {.method = graze::Method::mpr_sweep, .tolerance = 1e-03f})");
  EXPECT_EQ(one.cost.median, 0.2);
  EXPECT_EQ(one.worst, 2e-4);
  EXPECT_EQ(one.wrong, 1U);
  EXPECT_EQ(one.denied, 1e-7);
  EXPECT_EQ(one.because, "no other is cheaper");
}

TEST(PriceAdvice, WhatIsOffByMoreOrLeavesAVerdictOpenIsNotForAGame) {
  Document document = document_in_float();
  Row& cheap = document.tables[0].rows.back();
  cheap.backward.worst = 2e-3;
  // The next cheaper one, mpr in double, is off by 2e-3 as well.
  EXPECT_EQ(advice(document, "a game", "that do not rotate").label, "gjk/double 1e-03");
  cheap.backward.worst = 1e-4;
  cheap.denied = 2e-3;  // a verdict that wrong is an error as large
  EXPECT_EQ(advice(document, "a game", "that do not rotate").because,
            "the next cheaper, mpr/double (0.25 times), is off by 2e-03 of scale");
  cheap.denied = 1e-7;
  cheap.failures.not_converged = 1;
  EXPECT_EQ(advice(document, "a game", "that do not rotate").label, "gjk/double 1e-03");
}

TEST(PriceAdvice, ARobotTakesNothingThatIsLateOrWrong) {
  const Advice one = advice(planted_document(), "a robot", "that do not rotate");
  EXPECT_EQ(one.label, "certified/double");
  EXPECT_EQ(one.call, "// Body<double>\ngraze::cast(a, b, {.tier = graze::Tier::certified})");
  EXPECT_EQ(one.because, "the next cheaper, ca/double (3.00 times), is late in 2 of 10, by 1e-16 of scale");
  // A contender that was right by chance has no guarantee.
  Document document = planted_document();
  for (Row& row : document.tables[0].rows) row.late = row.wrong = 0;
  EXPECT_EQ(advice(document, "a robot", "that do not rotate").label, "certified/double");
  EXPECT_EQ(advice(document, "a robot", "that do not rotate").because,
            "the next cheaper, ca/double (3.00 times), is as right here, but its tier does not promise it");
  for (Row& row : document.tables[0].rows) row.late = 1;
  EXPECT_EQ(advice(document, "a robot", "that do not rotate").label, "");
}

TEST(PriceAdvice, TierExactIsTakenWhereItCostsNoMore) {
  EXPECT_EQ(advice(planted_document(), "a CAD tool", "that tier exact answers").label, "exact/double")
      << "certified is off by 2e-15";
  Document document = planted_document();
  for (Row& row : document.tables[0].rows) {
    if (row.tier == "certified") row.backward.worst = 0;
  }
  // 5 times against 4, then 4.1.
  EXPECT_EQ(advice(document, "a CAD tool", "that tier exact answers").label, "certified/double");
  document.tables[0].rows.back().ratio = Spread{.median = 4.1, .low = 4, .high = 4.2};
  EXPECT_EQ(advice(document, "a CAD tool", "that tier exact answers").label, "exact/double");
}

TEST(PriceAdvice, ThePlanIsTakenWhereItCostsNoMore) {
  Document document = planted_document();
  PriceTable& table = document.tables[0];
  table.kind = "rotating";
  table.baseline = "bilateral/double";
  table.rows = {planted_row("bilateral", 1e-3, 0.50, 1e-6), planted_row("plan", 1e-3, 0.52, 1e-6)};
  for (Row& row : table.rows) row.question = "rotating cast";
  Advice one = advice(document, "a game", "that rotate");
  EXPECT_EQ(one.label, "plan/double 1e-03");
  EXPECT_EQ(one.call, "// RotatingBody<double>\ngraze::cast(a, b, {.tolerance = 1e-03})");
  table.rows[1].ratio = Spread{.median = 0.6, .low = 0.6, .high = 0.6};
  one = advice(document, "a game", "that rotate");
  EXPECT_EQ(one.label, "bilateral/double 1e-03");
  EXPECT_EQ(
      one.call,
      "// RotatingBody<double>\n"
      "graze::cast(a, b, {.method = graze::RotatingMethod::bilateral_advancement, .tolerance = 1e-03})");
}

TEST(PriceAdvice, OfBodiesThatNobodyWasAskedNothingIsSaid) {
  EXPECT_TRUE(advice_of(Document{}).empty());
  EXPECT_EQ(find(advice_of(planted_document()), "a robot", "that rotate"), nullptr);
}

}  // namespace
}  // namespace graze::price
