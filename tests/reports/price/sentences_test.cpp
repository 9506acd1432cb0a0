// The sentences of the report on planted figures.
#include "reports/price/sentences.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reports/price/planted.hpp"

namespace graze::price {
namespace {

std::vector<std::string> said(const Document& document, const std::string& topic) {
  std::vector<std::string> texts;
  for (const Sentence& one : sentences_of(document)) {
    if (one.topic == topic) texts.push_back(one.text);
  }
  return texts;
}

TEST(PriceSentences, TheCheapestThatIsNeverLateIsFoundByBothMeasures) {
  const std::vector<std::string> texts = said(planted_document(), "never_late");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(
      texts[0],
      "The cheapest method that is never late, not by a bit, and misses no contact on 1 family of linear "
      "casts: certified/double, at 4.00 times the time of gjk/double, with a worst error of 2e-15 of scale.");
  // mpr is cheaper, and denies a contact.
  EXPECT_NE(texts[1].find(
                "by more than 1e-12 of scale, and misses no contact that deep, on 1 family of linear casts: "
                "gjk/double 1e-03, at 0.50"),
            std::string::npos)
      << texts[1];
}

TEST(PriceSentences, OneThatGivesAVerdictAwayIsNotTheOneThatIsNeverWrong) {
  const std::vector<std::string> texts = said(planted_document(), "never_wrong");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_NE(texts[0].find(": gjk/double 1e-03, at 0.50 times"), std::string::npos) << texts[0];
  EXPECT_EQ(texts[1],
            "On what tier exact answers, the cheapest that is neither wrong nor late: certified/double, at "
            "4.00 times the time of gjk/double.");
}

// Each family counts: who is late in one is never the one that is never late.
TEST(PriceSentences, AFamilyInWhichAMethodFailsCounts) {
  Document document = planted_document();
  document.tables.push_back(document.tables[0]);
  document.tables[1].name = "other";
  for (Row& row : document.tables[1].rows) {
    if (row.label == "certified/double") row.late = 1;
  }
  const std::vector<std::string> texts = said(document, "never_late");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_NE(texts[0].find("2 families of linear casts: exact/double"), std::string::npos) << texts[0];
}

TEST(PriceSentences, AnEngineOfOthersAndOneThatLeavesCasesOutAreNotChosen) {
  Document document = planted_document();
  for (Row& row : document.tables[0].rows) {
    if (row.label == "certified/double") row.ours = false;
    if (row.label == "exact/double") row.asked = 9;
  }
  const std::vector<std::string> texts = said(document, "never_late");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0],
            "No method is never late, not by a bit, and misses no contact on all 1 family of linear casts.");
}

TEST(PriceSentences, WhoIsRightToWithinSoMuchIsChosenByTheWorstAnswer) {
  const std::vector<std::string> texts = said(planted_document(), "choose");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(
      texts[0].find("1e-02: mpr/double (0.25 times); 1e-04: gjk/double 1e-03 (0.50 times); 1e-06: gjk/double "
                    "(1.00 times)"),
      std::string::npos)
      << texts[0];
}

TEST(PriceSentences, AVerdictThatIsLeftOpenIsNeitherWrongNorRight) {
  Document document = planted_document();
  for (Row& row : document.tables[0].rows) {
    if (row.label == "gjk/double 1e-03") row.failures.not_converged = 3;
  }
  const std::string wrong = said(document, "never_wrong")[0], chosen = said(document, "choose")[0];
  EXPECT_NE(wrong.find(": gjk/double, at 1.00 times"), std::string::npos) << wrong;
  EXPECT_NE(chosen.find("1e-04: gjk/double (1.00 times)"), std::string::npos) << chosen;
}

TEST(PriceSentences, ADigitHasThePriceThatWasPlanted) {
  const std::vector<std::string> texts = said(planted_document(), "digit");
  ASSERT_EQ(texts.size(), 1U);
  // Ten digits for twice the time.
  const double factor = std::pow(2.0, 0.1);
  EXPECT_NE(texts[0].find("gjk +7 % (10 digits for 2.00 times the time)"), std::string::npos)
      << texts[0] << factor;
}

TEST(PriceSentences, ALooseToleranceThatIsDearerThanTheLeastIsSaidToBe) {
  Document document = planted_document();
  for (Row& row : document.tables[0].rows) {
    if (row.label == "gjk/double 1e-03") row.ratio = Spread{.median = 2.5, .low = 2.4, .high = 2.6};
  }
  // Rows of a sweep go from loose to least.
  std::swap(document.tables[0].rows[0], document.tables[0].rows[1]);
  const std::vector<std::string> texts = said(document, "digit");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(
      texts[0].find("gjk nothing (its least tolerance, a median error of 1e-15, takes no longer than any "
                    "coarser one), though with a tolerance that leaves 1e-05 it takes 2.50 times"),
      std::string::npos)
      << texts[0];
}

TEST(PriceSentences, CertaintyAndExactnessAreRatiosOfTheSameRun) {
  const Document document = planted_document();
  const std::vector<std::string> certainty = said(document, "certainty"),
                                 exactness = said(document, "exactness");
  ASSERT_EQ(certainty.size(), 1U);
  // The quickest of tier standard at its least tolerance is mpr, at 0.25.
  EXPECT_NE(certainty[0].find("tier certified takes 16 times"), std::string::npos) << certainty[0];
  ASSERT_EQ(exactness.size(), 1U);
  EXPECT_NE(exactness[0].find("tier exact takes 20 times"), std::string::npos) << exactness[0];
  EXPECT_NE(exactness[0].find("1.25 times that of certified/double"), std::string::npos) << exactness[0];
}

TEST(PriceSentences, TheCheapestProofIsOfWhoProvesEveryAnswer) {
  Document document = planted_document();
  PriceTable& table = document.tables[0];
  table.part = Part::request;
  for (Row& row : table.rows) {
    row.label += " proof";
    row.request = "proof";
    row.proved = row.method == "certified" || row.method == "exact" ? 10 : 9;
  }
  const std::vector<std::string> texts = said(document, "proof");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0],
            "The cheapest proof on round: certified/double proof, at 4.00 times the time of gjk/double.");
}

TEST(PriceSentences, ADigitThatIsThereEarlyIsSaidToBe) {
  Document document = planted_document();
  std::vector<Row>& rows = document.tables[0].rows;
  rows = {planted_row("gjk", 1e-3, 0.5, 1e-3), planted_row("gjk", 1e-3, 0.9, 2e-15),
          planted_row("gjk", 0, 1, 1e-15)};
  const std::vector<std::string> early = said(document, "digit");
  ASSERT_EQ(early.size(), 1U);
  EXPECT_NE(early[0].find("all of them there from a tolerance of 1e-03 on"), std::string::npos) << early[0];
  // Not where a finer one is worse again.
  rows.insert(rows.begin() + 2, planted_row("gjk", 1e-3, 0.95, 1e-9));
  EXPECT_EQ(said(document, "digit")[0].find("all of them"), std::string::npos) << said(document, "digit")[0];
}

TEST(PriceSentences, OfWhatWasNotMeasuredNothingIsSaid) {
  EXPECT_TRUE(sentences_of(Document{}).empty());
  for (const char* topic : {"epa_mpr", "swept", "growth", "request", "scalar"})
    EXPECT_TRUE(said(planted_document(), topic).empty()) << topic;
}

}  // namespace
}  // namespace graze::price
