// The reader takes JSON, all of it, and nothing else.
#include <gtest/gtest.h>
#include <graze_adapter.hpp>

#include <string>
#include <vector>

namespace graze::adapter {
namespace {

TEST(Json, HostileLinesAreRefused) {
  const std::vector<std::string> lines{
      "",
      " ",
      "{",
      "}",
      "[1, 2",
      "[1,]",
      "[,1]",
      "{\"a\": 1,}",
      "{\"a\" 1}",
      "{a: 1}",
      "{'a': 1}",
      "{\"a\": 1, \"a\": 2}",
      "\"no end",
      "\"bad \\x escape\"",
      "\"half a pair \\ud800\"",
      "\"half a pair \\ud800\\u0041\"",
      "\"the other half \\udc00\"",
      "\"\\u12g4\"",
      "\"\\u12",
      "\"ends in a backslash\\",
      "\"a\ttab\"",
      std::string("\"a zero\0\"", 10),
      std::string("1\0", 2),
      "1 2",
      "{} {}",
      "tru",
      "truee",
      "nul",
      "NaN",
      "Infinity",
      "-",
      "+1",
      "01",
      "1.",
      ".5",
      "1e",
      "1e+",
      "0x1p3",
      "1e999",
      "-1e999",
      "1'000",
      "// comment\n1",
      "\xef\xbb\xbf{}",
  };
  for (const std::string& line : lines) EXPECT_THROW(json::read(line), BadLine) << line;
}

TEST(Json, NestingEndsBeforeTheStackDoes) {
  const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_NO_THROW(json::read(nested(json::kDeepest)));
  EXPECT_THROW(json::read(nested(json::kDeepest + 2)), BadLine);
  EXPECT_THROW(json::read(std::string(1000000, '[')), BadLine);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_THROW(json::read(objects), BadLine);
}

TEST(Json, EveryPrefixOfAQuestionIsRefused) {
  const std::string line =
      R"({"schema": "graze.question/1", "id": "q\u00e9\n", "n": [1, -2.5e-3, true, false, null, {"x": "\\"}]})";
  EXPECT_NO_THROW(json::read(line));
  for (std::size_t size = 0; size < line.size(); ++size) {
    EXPECT_THROW(json::read(line.substr(0, size)), BadLine) << size;
  }
}

TEST(Json, StringsComeBackAsTheyWere) {
  const json::Value read = json::read(R"("\"\\\/\b\f\n\r\t\u0041\u00e9\u20ac\ud83d\ude00 é")");
  EXPECT_EQ(read.string, "\"\\/\b\f\n\r\tA\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80 \xc3\xa9");
  std::string all;
  for (int c = 1; c < 128; ++c) all += static_cast<char>(c);
  std::string written;
  json::write_string(written, all);
  EXPECT_EQ(json::read(written).string, all);
}

TEST(Json, ValuesKeepTheirKindAndOrder) {
  const json::Value read = json::read(" {\"b\": [1, \"x\", null], \"a\": {\"t\": true}} ");
  ASSERT_EQ(read.names.size(), 2U);
  EXPECT_EQ(read.names[0], "b");
  EXPECT_EQ(read.find("b")->values[1].string, "x");
  EXPECT_EQ(read.find("b")->values[2].kind, json::Value::Kind::null);
  EXPECT_TRUE(read.find("a")->find("t")->boolean);
  EXPECT_EQ(read.find("c"), nullptr);
}

TEST(Json, TheColumnOfAnErrorIsSaid) {
  try {
    json::read("[1, 2 3]");
    FAIL() << "it was read";
  } catch (const BadLine& bad) {
    EXPECT_EQ(std::string(bad.what()), "column 7: a comma or ] is expected");
  }
}

}  // namespace
}  // namespace graze::adapter
