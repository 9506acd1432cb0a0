// graze draw, as a user runs it.
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

std::string renamed(const std::string& id) {
  std::string text = kCase;
  return text.replace(text.find("test/one"), 8, id);
}

void expect_complaint(const CommandRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

TEST(Draw, WritesOneCaseToStandardOutputOrToAFileAndSeveralIntoAFolder) {
  const Folder folder;
  const CommandRun one = folder.graze("draw -", kCase);
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_TRUE(one.out.starts_with("<svg ")) << one.out;
  EXPECT_TRUE(one.out.ends_with("</svg>\n"));
  EXPECT_EQ(folder.graze("draw - --out one.svg --view 1,0,2.5 --width 500", kCase).exit_code, 0);
  EXPECT_TRUE(folder.read("one.svg").starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"500\""));
  EXPECT_EQ(folder.graze("draw - --out pictures", kCase + "\n" + renamed("test/two")).exit_code, 0);
  EXPECT_EQ(folder.read("pictures/test-one.svg"), one.out);
  EXPECT_NE(folder.read("pictures/test-two.svg").find("<title>test/two</title>"), std::string::npos);
}

TEST(Draw, SaysInOneLineWhatIsWrong) {
  const Folder folder;
  folder.write("two.jsonl", kCase + "\n" + renamed("test/two") + "\n");
  folder.write("one.json", kCase);
  expect_complaint(folder.graze("draw"), "no case is given");
  expect_complaint(folder.graze("draw two.jsonl"), "--out: 2 cases need a folder");
  expect_complaint(folder.graze("draw two.jsonl --out one.json"), "one.json");
  for (const std::string view : {"w", "1,2", "0,0,0", "1,2,nan", "1,2,3,4", ""}) {
    expect_complaint(folder.graze("draw one.json --view '" + view + "'"), "--view: ");
  }
  expect_complaint(folder.graze("draw one.json --width 3"), "--width: 3");
  expect_complaint(folder.graze("draw one.json --families out"), "--families: ");
  std::string refused = kCase;
  refused.replace(refused.find("\"radius\": 1"), 11, "\"radius\": 1e70");
  expect_complaint(folder.graze("draw -", refused), "case test/one: cannot be drawn");
}

}  // namespace
}  // namespace graze
