// graze laws, as a user runs it, and the page of the laws.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

std::string page() {
  std::ifstream file(GRAZE_SOURCE_DIR "/docs/reference/laws.md");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expect_complaint(const CommandRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

constexpr const char* kCases =
    R"({"schema": "graze.case/1", "id": "test/hit", "a": {"shape": {"type": "box", "half_extents": [1, 1, 1]}}, )"
    R"("b": {"shape": {"type": "point"}, "position": [0.25, 0, 4], "displacement": [0, 0, -5]}})"
    "\n"
    R"({"schema": "graze.case/1", "id": "test/turns", "a": {"shape": {"type": "box", "half_extents": [2, 1, 1]}, )"
    R"("rotation": [0, 0, 1]}, "b": {"shape": {"type": "sphere", "radius": 1}, "position": [0, 2.5, 0]}})"
    "\n";

TEST(LawCommand, TriesEveryLawOnAFile) {
  const Folder folder;
  folder.write("two.jsonl", kCases);
  const CommandRun run = folder.graze("laws two.jsonl --save broken.jsonl");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  for (const char* part : {"laws over 2 cases", "never_late", "turning_is_never_late", "Every law holds."}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  }
  EXPECT_EQ(folder.read("broken.jsonl"), "");
}

TEST(LawCommand, DrawsFamiliesAndTakesLawsAndMethodsByName) {
  const Folder folder;
  const std::string arguments =
      "laws --family aligned_boxes --count 8 --law swapping --law never_late --method mpr ";
  const CommandRun run = folder.graze(arguments + "--threads 1");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("2 laws over 8 cases"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("swapping"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("translating"), std::string::npos) << run.out;
  EXPECT_EQ(run.out, folder.graze(arguments + "--threads 3").out);
  // A law that applies to no case.
  const CommandRun idle =
      folder.graze("laws --family aligned_boxes --count 2 --law certified_decides --method mpr");
  EXPECT_EQ(idle.exit_code, 0);
  EXPECT_NE(idle.out.find("No case was one for: certified_decides\n"), std::string::npos) << idle.out;
}

TEST(LawCommand, ASignalStopsItAndShowsWhatWasJudged) {
  const Folder folder;
  const CommandRun run = folder.shell("timeout --preserve-status -s INT 1 '" GRAZE_COMMAND
                                      "' laws --family random --family needles "
                                      "--count 100000");
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_NE(run.out.find(" laws over "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Not finished: random, needles\nStopped: no law is broken so far.\n"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.err.find("graze: stopping;"), std::string::npos) << run.err;
}

TEST(LawCommand, SaysInOneLineWhatIsWrong) {
  const Folder folder;
  expect_complaint(folder.graze("laws --law swaping"), "--law: swaping is no law");
  expect_complaint(folder.graze("laws --family touchy"), "--family: touchy is no family");
  expect_complaint(folder.graze("laws --method mprr"), "--method: no law asks a method mprr");
  expect_complaint(folder.graze("laws none.jsonl"), "none.jsonl");
  expect_complaint(folder.graze("laws --family touching --count 0"), "there is no case to judge");
  expect_complaint(folder.graze("laws --list --law swapping"), "--law: has no meaning beside --list");
  expect_complaint(folder.graze("laws --page x.json"), "files: has no meaning beside --page");
  expect_complaint(folder.graze("laws --page --defects nowhere"), "nowhere: is no folder of planted defects");
  folder.write("empty/note", "");
  expect_complaint(folder.graze("laws --page --defects empty"), "empty: holds no .patch");
  folder.write("bad/one.patch", "Defect: something\n--- a\n");
  expect_complaint(folder.graze("laws --page --defects bad"), "one.patch: has no line \"Law: ");
  folder.write("bad/one.patch", "Defect: something\nLaw: swaping\n--- a\n");
  expect_complaint(folder.graze("laws --page --defects bad"), "one.patch: swaping is no law");
}

TEST(LawCommand, ListsTheLaws) {
  const Folder folder;
  const CommandRun run = folder.graze("laws --list");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* part : {"Oracle", "Proof", "Metamorphic", "  never_late ", "  unseen_turn_is_none "}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  }
}

TEST(PageOfLaws, IsThatOfTheLawsAndThePlantedDefectsAsTheyAre) {
  const Folder folder;
  const CommandRun run = folder.graze("laws --page");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, page()) << "make it again: graze laws --page > docs/reference/laws.md";
}

}  // namespace
}  // namespace graze
