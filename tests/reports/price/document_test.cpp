// A price list is read as it was written, and a wrong one is refused in one line that names the field.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reports/price/planted.hpp"

namespace graze::price {
namespace {

TEST(PriceDocument, IsReadAsItWasWritten) {
  Document document = planted_document();
  document.sentences.push_back({.topic = "digit", .text = "One more."});
  document.tables[0].rows[1].time.reset();
  document.tables[0].rows[1].ratio.reset();
  document.tables[0].shown[0].written = R"({"schema":"graze.case/1"})";
  document.advice.push_back(
      {.user = "a robot", .label = "certified/double", .call = "graze::cast(a, b)", .asked = 9});
  document.advice.push_back({.user = "a game", .because = "none will do"});
  const std::string text = write_document(document);
  const Document read = read_document(text, "price.json");
  EXPECT_EQ(write_document(read), text);
  ASSERT_EQ(read.advice.size(), 2U);
  EXPECT_EQ(read.advice[0].label, "certified/double");
  EXPECT_EQ(read.advice[1].label, "");
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_FALSE(read.tables[0].rows[1].time);
  EXPECT_EQ(read.tables[0].rows[3].denied, 1e-4);
}

std::string refusal_of(const std::string& text) {
  try {
    (void)read_document(text, "price.json");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(PriceDocument, WhatIsWrongIsNamed) {
  const std::string text = write_document(planted_document());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    const std::size_t at = other.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return other.replace(at, from.size(), to);
  };
  EXPECT_TRUE(refusal_of("{").starts_with("price.json: is no JSON: parse error at line 1, column 2"));
  EXPECT_EQ(refusal_of(changed("graze.price/1", "graze.case/1")),
            "price.json: schema: is graze.case/1, and not graze.price/1");
  EXPECT_EQ(refusal_of(changed(R"("asked":10)", R"("asked":-10)")),
            "price.json: tables[0].rows[0].asked: is no whole number of 0 or more");
  EXPECT_EQ(refusal_of(changed(R"("supports")", R"("suports")")),
            "price.json: tables[0].rows[0].supports: missing");
}

// As version 0.2.0 wrote it.
TEST(PriceDocument, OneWithoutAdviceIsRead) {
  std::string text = write_document(planted_document());
  const std::string field = R"("advice":[],)";
  const std::size_t at = text.find(field);
  ASSERT_NE(at, std::string::npos);
  text.erase(at, field.size());
  EXPECT_EQ(read_document(text, "price.json").tables.size(), 1U);
}

TEST(PriceDocument, TheCsvHasALineARowAndAsManyCellsInEach) {
  Document document = planted_document();
  document.tables[0].name = "round, and flat";
  const std::string csv = csv_of(document);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  std::size_t start = 0;
  std::vector<std::ptrdiff_t> commas;
  for (std::size_t end = csv.find('\n'); end != std::string::npos; end = csv.find('\n', start)) {
    const std::string line = csv.substr(start, end - start);
    commas.push_back(std::count(line.begin(), line.end(), ','));
    start = end + 1;
  }
  // In each row one comma is in quotes.
  for (std::size_t i = 1; i < commas.size(); ++i) EXPECT_EQ(commas[i], commas[0] + 1);
  EXPECT_NE(csv.find("\"round, and flat\""), std::string::npos);
  EXPECT_EQ(csv.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace graze::price
