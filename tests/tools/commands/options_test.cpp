// Options of the command graze that say nothing, too much, or another kind of file than they want.
#include <gtest/gtest.h>

#include <algorithm>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

constexpr const char* kHit = R"({"schema": "graze.case/1", "id": "test/hit", "family": "test",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 0.1]}},
 "b": {"shape": {"type": "sphere", "radius": 0.3}, "position": [0.1, 0.2, 1.4], "displacement": [0.1, 0, -10]}}
)";

// One line that is not long and names `part`; nothing is judged or written before.
void expect_one_complaint(const CommandRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
  EXPECT_LT(run.err.size(), 200U) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(Options, an_empty_value_is_none_and_is_not_passed_over) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string option : {"--proof", "--method", "--tier", "--scalar", "--tolerance"}) {
    expect_one_complaint(folder.graze("cast x.json " + option + " ''"), option);
  }
  for (const std::string option : {"--save", "--plot", "--guarantees", "--corpus", "--family", "--method"}) {
    expect_one_complaint(folder.graze("certify x.json " + option + " ''"), option);
  }
  expect_one_complaint(folder.graze("price --only nothing"), "--only: nothing is no table");
  expect_one_complaint(folder.graze("price --continue"), "--continue: needs --json");
  expect_one_complaint(folder.graze("price --quick --thorough"), "a run is one of the two");
  expect_one_complaint(folder.graze("draw x.json --out ''"), "--out");
  expect_one_complaint(folder.graze("draw --families ''"), "--families");
  expect_one_complaint(folder.graze("cast ''"), "files");
}

TEST(Options, a_number_that_is_no_count_is_refused_in_a_short_line) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string count : {"-1", "1.5", "nan", "inf", "1e3", "x", "99999999999999999999",
                                  "18446744073709551615", "1000000001", "+1", "0x10"}) {
    for (const std::string option : {"--count", "--queries", "--rotating", "--oracle-every", "--threads"}) {
      SCOPED_TRACE(option + "=" + count);
      expect_one_complaint(folder.graze("certify --family random " + option + "=" + count), option);
    }
    expect_one_complaint(folder.graze("generate random --count=" + count), "--count");
  }
  expect_one_complaint(folder.graze("certify x.json --threads 100000"), "--threads");
  expect_one_complaint(folder.graze("certify x.json --oracle-every 0"), "--oracle-every");
  expect_one_complaint(folder.graze("generate random --seed 18446744073709551616"), "--seed");
  EXPECT_EQ(folder.graze("generate random --count 1 --seed 18446744073709551615").exit_code, 0);
}

TEST(Options, a_folder_is_no_file_and_a_file_no_folder) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("folder/y.json", kHit);
  expect_one_complaint(folder.graze("certify x.json --guarantees folder"), "folder: a directory");
  expect_one_complaint(folder.graze("merge folder"), "folder: a directory");
  expect_one_complaint(folder.graze("compare folder folder"), "folder: a directory");
  expect_one_complaint(folder.graze("compare x.json x.json"), "x.json: schema: is graze.case/1");
  expect_one_complaint(folder.graze("cast folder"), "folder: a directory");
  expect_one_complaint(folder.shell("graze cast - <folder"), "standard input: cannot be read");
  // At once, and not after everything else was judged.
  for (const std::string corpus : {"x.json", "missing"}) {
    expect_one_complaint(folder.graze("certify --corpus " + corpus), corpus + ": is no folder");
    expect_one_complaint(folder.graze("certify --laws --corpus " + corpus), corpus + ": is no folder");
  }
  expect_one_complaint(folder.graze("certify --stability --family random --plot x.json"),
                       "x.json: is no folder");
  // What it drew once, graze price measures.
  expect_one_complaint(folder.graze("certify x.json --plot p"), "graze price");
  expect_one_complaint(folder.graze("certify --stability --family random --plot x.json/p"), "x.json/p");
}

TEST(Options, a_name_that_may_be_repeated_takes_no_file_for_another) {
  const Folder folder;
  folder.write("x.json", kHit);
  for (const std::string option : {"--method gjk/double", "--family random --count 1"}) {
    const CommandRun run = folder.graze("certify --queries 0 --full " + option + " x.json");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("x.json"), std::string::npos) << run.out;
  }
  const CommandRun laws = folder.graze("certify --laws --law swapping x.json");
  EXPECT_EQ(laws.exit_code, 0) << laws.err;
}

}  // namespace
}  // namespace graze
