// graze show and graze report, as a user runs them.
#include <gtest/gtest.h>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

const std::string kCase =
    R"({"schema": "graze.case/1", "id": "test/one", "a": {"shape": {"type": "point"}}, )"
    R"("b": {"shape": {"type": "sphere", "radius": 1}, "position": [0, 0, 4], )"
    R"("displacement": [0, 0, -5]}})";
const std::string kLate = R"({"schema": "graze.answer/1", "id": "test/one", "outcome": "hit", "time": 0.75})";

std::string renamed(const std::string& id) {
  std::string text = kCase;
  return text.replace(text.find("test/one"), 8, id);
}

void expect_complaint(const CommandRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Show, WritesAPageThatHoldsTheCaseAndAsksForNothingElse) {
  const Folder folder;
  const CommandRun run = folder.graze("show - --method mpr --out page.html", kCase);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string page = folder.read("page.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_TRUE(holds(page, "test/one"));
  for (const char* foreign : {"<script src", "<link rel=\"stylesheet\"", "@import", "<img src=\"http"})
    EXPECT_FALSE(holds(page, foreign)) << foreign;
}

TEST(Show, CannotBeEndedByWhatACaseSays) {
  const Folder folder;
  std::string bad = kCase;
  bad.insert(bad.find("\"a\""), R"("comment": "</script><script>alert(1)</script><!--", )");
  EXPECT_EQ(folder.graze("show - --out page.html", bad).exit_code, 0);
  EXPECT_FALSE(holds(folder.read("page.html"), "alert(1)</script>"));
}

TEST(Show, DrawsAWrongAnswerBesideTheTrueOne) {
  const Folder folder;
  folder.write("one.json", kCase);
  folder.write("answers.jsonl", kLate + "\n");
  EXPECT_EQ(folder.graze("show one.json --answers answers.jsonl --svg --out one.svg").exit_code, 0);
  const std::string picture = folder.read("one.svg");
  for (const char* part :
       {"B as claimed", "answers.jsonl: hit at t = 0.75", "late", "seen from (", ">z<", "× 10"})
    EXPECT_TRUE(holds(picture, part)) << part;
  // A right one is said, and not drawn.
  EXPECT_EQ(folder.graze("show one.json --method gjk --svg --out right.svg").exit_code, 0);
  EXPECT_FALSE(holds(folder.read("right.svg"), "as claimed"));
  EXPECT_TRUE(holds(folder.read("right.svg"), "within its limit"));
}

TEST(Show, SaysInOneLineWhatIsWrong) {
  const Folder folder;
  folder.write("one.json", kCase);
  folder.write("two.jsonl", kCase + "\n" + renamed("test/two") + "\n");
  folder.write("other.jsonl", R"({"schema": "graze.answer/1", "id": "x", "outcome": "miss"})");
  folder.write("none.jsonl", "{}\n");
  expect_complaint(folder.graze("show nothing.json"), "nothing.json");
  expect_complaint(folder.graze("show one.json --id test/two"), "--id: test/two is the id of no case");
  expect_complaint(folder.graze("show one.json --method warp"), "warp");
  expect_complaint(folder.graze("show two.jsonl --svg"), "--svg: draws one case");
  expect_complaint(folder.graze("show one.json --answers other.jsonl"), "none of its ids");
  expect_complaint(folder.graze("show one.json --answers none.jsonl"), "none.jsonl:1: is no graze.answer/1");
  expect_complaint(folder.graze("show one.json --out one.json"), "one.json");
}

TEST(Report, SaysWhichFieldOfAPriceListIsWrong) {
  const Folder folder;
  folder.write("bad.json", "{");
  folder.write("other.json", R"({"schema": "graze.case/1"})");
  folder.write("short.json",
               R"({"schema": "graze.price/1", "version": "1", "seed": 1, "rounds": 1, "finished": true,
    "machine": {"processor": "", "cores": 1, "compiler": "", "build": "", "load": null}, "tables": [{}], "sentences": []})");
  expect_complaint(folder.graze("report bad.json --out page.html"), "bad.json: is no JSON");
  expect_complaint(folder.graze("report other.json --out page.html"),
                   "other.json: schema: is not graze.price/1");
  expect_complaint(folder.graze("report short.json --out page.html"), "short.json: tables[0]: has no part");
}

}  // namespace
}  // namespace graze
