// graze stability, as a user runs it.
#include <gtest/gtest.h>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

constexpr const char* kSmall = "stability --family aligned_boxes --count 2 --method gjk ";

TEST(StabilityCommand, PrintsTheCurvesAndWritesWhatDrawsThem) {
  const Folder folder;
  const CommandRun run = folder.graze(std::string(kSmall) + "--family touching --plot curves");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* part :
       {"aligned_boxes: 8 cases", "aligned_boxes, by hardness (the number of axes",
        "Each method on each family", "Summary", "gjk/float", "Every method is as stable"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  }
  EXPECT_NE(folder.read("curves/stability_aligned_boxes.dat").find("# gjk/float"), std::string::npos);
  EXPECT_NE(folder.read("curves/stability_aligned_boxes.gp").find("plot"), std::string::npos);
  EXPECT_NE(folder.read("curves/stability_overview.dat").find("0 aligned_boxes"), std::string::npos);
}

TEST(StabilityCommand, TheThreadsAndASecondRunChangeNothing) {
  const Folder folder;
  const std::string arguments = std::string(kSmall) + "--seed 7 --threads ";
  EXPECT_EQ(folder.graze(arguments + "1").out, folder.graze(arguments + "3").out);
}

TEST(StabilityCommand, ExitsWith1WhereAMethodIsLessStableThanItsRow) {
  const Folder folder;
  folder.write(
      "strict.json",
      R"({"schema": "graze.guarantees/1", "rows": [{"method": "gjk", "scalar": "double", "tier": "standard",
  "kappa_polytope": 0.001, "kappa_rounded": 0.001, "stall_cap": 0, "mechanism": ""}]})");
  const CommandRun run = folder.graze(
      "stability --family random --count 2 --method gjk --guarantees strict.json --save bad.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find("broken: gjk/double standard in random"), std::string::npos) << run.out;
  EXPECT_NE(folder.read("bad.jsonl").find("random/h"), std::string::npos);
}

TEST(StabilityCommand, ASignalStopsItAndShowsWhatWasMeasured) {
  const Folder folder;
  const CommandRun run = folder.shell("timeout --preserve-status -s INT 2 '" GRAZE_COMMAND
                                      "' stability --family aligned_boxes "
                                      "--family needles --count 5000 --method gjk --save bad.jsonl");
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_NE(run.out.find("Each method on each family"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("needles\nStopped: every method is as stable as its guarantee says so far.\n"),
            std::string::npos)
      << run.out;
}

TEST(StabilityCommand, RefusesFilesAndEmptyRunsInOneLine) {
  const Folder folder;
  const CommandRun file = folder.graze("stability some.jsonl");
  EXPECT_EQ(file.exit_code, 2);
  EXPECT_EQ(file.err,
            "graze: The following argument was not expected: some.jsonl; see graze stability --help\n");
  const CommandRun none = folder.graze("stability --family aligned_boxes --count 0");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.err,
            "graze: there is nothing to measure; give a count above 0, and a method for the family\n");
}

}  // namespace
}  // namespace graze
