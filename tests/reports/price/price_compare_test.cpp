// A planted slowdown and a planted loss of accuracy are found, and noise is not reported.
#include "reports/price/price_compare.hpp"

#include <gtest/gtest.h>

#include "tests/reports/price/planted.hpp"

namespace graze::price {
namespace {

Row& row_of(Document& document, const std::string& label) {
  for (Row& row : document.tables[0].rows) {
    if (row.label == label) return row;
  }
  throw std::runtime_error(label + ": no such row");
}

void scale(Spread& spread, double factor) {
  spread.median *= factor;
  spread.low *= factor;
  spread.high *= factor;
}

// The one line that is said to be worse.
std::string only_worse(const Document& before, const Document& after) {
  const Comparison found = compare(before, after);
  if (found.worse.size() == 1) return found.worse[0];
  std::string all = "not one line but " + std::to_string(found.worse.size());
  for (const std::string& line : found.worse) all += "\n" + line;
  return all;
}

TEST(PriceCompare, ARunIsNoWorseThanItself) {
  const Document document = planted_document();
  const Comparison found = compare(document, document);
  EXPECT_TRUE(found.worse.empty());
  EXPECT_TRUE(found.better.empty());
  EXPECT_TRUE(found.not_compared.empty());
  EXPECT_EQ(found.rows, 6U);
}

TEST(PriceCompare, APlantedSlowdownIsFoundAndItsReverseIsBetter) {
  const Document before = planted_document();
  Document after = before;
  scale(*row_of(after, "mpr/double").ratio, 1.25);
  EXPECT_EQ(only_worse(before, after),
            "round, mpr/double: time over the baseline's 0.25 (0.24 to 0.26) -> 0.31 (0.31 to 0.32)");
  const Comparison reverse = compare(after, before);
  EXPECT_TRUE(reverse.worse.empty());
  EXPECT_EQ(reverse.better.size(), 1U);
}

TEST(PriceCompare, AMachineTwiceAsSlowIsNoSlowdown) {
  const Document before = planted_document();
  Document after = before;
  for (Row& row : after.tables[0].rows) {
    row.time->median *= 2;
    row.time->worst *= 5;
  }
  after.machine.processor = "another";
  EXPECT_TRUE(compare(before, after).worse.empty());
}

TEST(PriceCompare, WhereSpreadsOverlapNothingIsSaid) {
  const Document before = planted_document();
  Document after = before;
  Row& row = row_of(after, "mpr/double");
  scale(*row.ratio, 1.25);
  row.ratio->low = 0.25;  // one round as quick as before
  EXPECT_TRUE(compare(before, after).worse.empty());
}

TEST(PriceCompare, WhatIsBelowTheThresholdIsNotSaid) {
  const Document before = planted_document();
  Document after = before;
  scale(*row_of(after, "mpr/double").ratio, 1.09);
  EXPECT_TRUE(compare(before, after).worse.empty());
  EXPECT_EQ(compare(before, after, {.threshold = 0.05}).worse.size(), 1U);
}

// Its own ratio is 1 whatever happens to it.
TEST(PriceCompare, ABaselineThatBecameSlowerIsFoundByAllOthers) {
  const Document before = planted_document();
  Document after = before;
  for (Row& row : after.tables[0].rows) {
    if (row.label != "gjk/double") scale(*row.ratio, 1 / 1.4);
  }
  const std::string line = only_worse(before, after);
  EXPECT_NE(line.find("the baseline gjk/double is slower"), std::string::npos) << line;
  EXPECT_NE(line.find("0.71"), std::string::npos) << line;
}

TEST(PriceCompare, MoreSupportsAreFoundWhateverTheClockSays) {
  const Document before = planted_document();
  Document after = before;
  row_of(after, "gjk/double").supports.mean = 9;
  EXPECT_EQ(only_worse(before, after), "round, gjk/double: supports a call 8.00 -> 9.00");
}

TEST(PriceCompare, APlantedLossOfAccuracyIsFound) {
  const Document before = planted_document();
  Document after = before;
  row_of(after, "gjk/double").backward.worst = 1e-9;
  EXPECT_EQ(only_worse(before, after), "round, gjk/double: worst backward error 2.0e-15 -> 1.0e-09 of scale");
}

TEST(PriceCompare, OtherLastBitsAreNoLoss) {
  const Document before = planted_document();
  Document after = before;
  for (Row& row : after.tables[0].rows) {
    if (row.tier != "standard" || row.backward.worst > 1e-14) continue;
    row.backward.worst *= 1.5;
    row.backward.median *= 4;  // still rounding
    row.late = 3;
    row.late_by = 2e-16;
  }
  EXPECT_TRUE(compare(before, after).worse.empty());
}

TEST(PriceCompare, AWrongVerdictAndALostProofAreFound) {
  const Document before = planted_document();
  Document after = before;
  row_of(after, "gjk/double").wrong = 1;
  row_of(after, "gjk/double").denied = 1e-3;
  const Comparison found = compare(before, after);
  ASSERT_EQ(found.worse.size(), 2U);
  EXPECT_EQ(found.worse[0],
            "round, gjk/double: greatest length denied by a wrong verdict 0.0e+00 -> 1.0e-03 of scale");
  EXPECT_EQ(found.worse[1], "round, gjk/double: wrong verdicts 0 -> 1");
  Document proved = before;
  row_of(proved, "certified/double").proved = 10;
  EXPECT_EQ(only_worse(proved, before), "round, certified/double: proofs 10 -> 0");
}

// A tier that promises never to be late is not excused by rounding.
TEST(PriceCompare, ACertifiedAnswerThatIsLateByABitIsFound) {
  const Document before = planted_document();
  Document after = before;
  row_of(after, "certified/double").late = 1;
  row_of(after, "certified/double").late_by = 1e-17;
  EXPECT_EQ(only_worse(before, after), "round, certified/double: late answers 0 -> 1");
}

TEST(PriceCompare, WhatIsNotThereIsSaidAndOtherCasesAreRefused) {
  const Document before = planted_document();
  Document after = before;
  after.tables[0].rows.pop_back();
  const Comparison found = compare(before, after);
  ASSERT_EQ(found.not_compared.size(), 1U);
  EXPECT_EQ(found.not_compared[0], "round, exact/double: the new run does not have it");
  after = before;
  after.seed = 2;
  EXPECT_THROW((void)compare(before, after), std::runtime_error);
  after = before;
  after.tables[0].name = "another";
  EXPECT_THROW((void)compare(before, after), std::runtime_error);
}

}  // namespace
}  // namespace graze::price
