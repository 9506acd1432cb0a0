// The command graze never writes over its input, and reports every output that is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

constexpr const char* kHit = R"({"schema": "graze.case/1", "id": "test/hit", "family": "test",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 0.1]}},
 "b": {"shape": {"type": "sphere", "radius": 0.3}, "position": [0.1, 0.2, 1.4], "displacement": [0.1, 0, -10]}}
)";
// A table that no arithmetic can keep.
constexpr const char* kStrict =
    R"({"schema": "graze.guarantees/1", "rows": [{"method": "mpr", "scalar": "double",
 "tier": "standard", "kappa_polytope": 0, "kappa_rounded": 0, "stall_cap": 0, "mechanism": "a test"}]})";

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// Exactly one line, which names the program and `part`.
void expect_one_complaint(const CommandRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(lines_in(run.err), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
}

std::string with(std::string line, const std::string& what, const std::string& value) {
  for (std::size_t at = line.find(what); at != std::string::npos; at = line.find(what)) {
    line.replace(at, what.size(), value);
  }
  return line;
}

// Every option that names an output, beside a file that is read. Those of a campaign, which reads nothing but
// its own state, are not among them.
struct Output {
  std::string command, option, line;  // IN is the file that is read, OUT the output
};
const std::vector<Output> kOutputs = {
    {"cast", "--proof", "cast IN --proof OUT"},
    {"certify", "--save", "certify IN --save OUT"},
    {"certify", "--save", "certify --family random --count 1 --guarantees IN --save OUT"},
    {"stability", "--save", "stability --family random --count 1 --guarantees IN --save OUT"},
    {"laws", "--save", "laws IN --law swapping --save OUT"},
    {"certify", "--json", "certify IN --json OUT"},
    {"certify", "--junit", "certify IN --junit OUT"},
    {"draw", "--out", "draw IN --out OUT"},
    {"merge", "--json", "merge IN --json OUT"},
    {"merge", "--save", "merge IN --save OUT"},
    {"merge", "--save-undecided", "merge IN --save-undecided OUT"},
    {"corpus add", "--into", "corpus add IN --into OUT"},
};

TEST(Outputs, TheListOfOptionsIsWhole) {
  const Folder folder;
  std::set<std::string> known, found;
  for (const Output& output : kOutputs) known.insert(output.command + " " + output.option);
  for (const std::string command :
       {"cast", "check", "certify", "merge", "generate", "draw", "laws", "stability", "corpus add",
        "corpus fill", "corpus format", "corpus validate", "corpus verify"}) {
    std::istringstream help(folder.graze(command + " --help").out);
    for (std::string line; std::getline(help, line);) {
      std::istringstream words(line);
      std::string option, type;
      words >> option >> type;
      if (!option.starts_with("--")) continue;
      if (type.starts_with("OUT") || option == "--into") {
        found.insert(command + " " + option.substr(0, option.find(',')));
      }
    }
  }
  EXPECT_EQ(found, known);
}

TEST(Outputs, WhatAFileHeldIsThereAfterARefusedRun) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("report/index.html", "of yesterday");
  folder.write("out", "of yesterday");
  for (const std::string line :
       {"certify --family nobody --report report", "certify --family nobody --json out",
        "certify --family nobody --junit out", "certify --family nobody --save out"}) {
    SCOPED_TRACE(line);
    EXPECT_EQ(folder.graze(line).exit_code, 2);
    EXPECT_EQ(folder.read("report/index.html"), "of yesterday");
    EXPECT_EQ(folder.read("out"), "of yesterday");
  }
  EXPECT_EQ(folder.graze("cast x.json --proof out").exit_code, 0);
  EXPECT_EQ(folder.read("out").find("of yesterday"), std::string::npos);
}

// Nothing was read, or nothing of it was answered: that is no reason to lose what there was.
TEST(Outputs, WhatAFileHeldIsThereAfterARunThatWritesNothing) {
  const Folder folder;
  folder.write("invalid.json", with(kHit, "1.4]", "1e200]"));
  folder.write("no.json", "{");
  folder.write("out", "of yesterday");
  for (const std::string line :
       {"cast missing.json --proof out", "cast invalid.json --proof out", "cast no.json --proof out",
        "scene missing.json --proof out", "scene invalid.json --proof out", "scene no.json --proof out",
        "stability --family aligned_boxes --count 0 --save out"}) {
    SCOPED_TRACE(line);
    EXPECT_EQ(folder.graze(line).exit_code, 2);
    EXPECT_EQ(folder.read("out"), "of yesterday");
  }
  // A run that has nothing to write says so: the file is empty.
  folder.write("scene.json", R"({"schema": "graze.scene/1", "id": "one", "bodies": [
    {"name": "a", "shape": {"type": "sphere", "radius": 1}}]})");
  EXPECT_EQ(folder.graze("scene scene.json --proof out").exit_code, 0);
  EXPECT_EQ(folder.read("out"), "");
}

// Standard output is one thing's: a document that goes there is read by another program.
TEST(Outputs, ADocumentOnStandardOutputIsThereAlone) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("strict.json", kStrict);
  folder.write("answers.jsonl", R"({"schema": "graze.answer/1", "id": "test/hit", "outcome": "hit"})");
  folder.write("scene.json", R"({"schema": "graze.scene/1", "id": "two", "bodies": [
    {"name": "a", "shape": {"type": "sphere", "radius": 1}},
    {"name": "b", "shape": {"type": "sphere", "radius": 1}, "position": [4, 0, 0], "displacement": [-4, 0, 0]}]})");
  struct Line {
    std::string line, begin, text;  // how the document begins, and what is said on stderr
  };
  for (const Line& one :
       {Line{"certify x.json --json -", "{", "Every method keeps its guarantee"},
        Line{"certify x.json --junit -", "<?xml", "Every method keeps its guarantee"},
        Line{"certify x.json --guarantees strict.json --save -", "", "method"},
        Line{"judge answers.jsonl --cases x.json --json -", "{", "answers at fault"},
        Line{"cast x.json --proof -", "{", "outcome   hit"},
        Line{"cast x.json --json --proof -", "{\"schema\": \"graze.proof/1\"", "iterations"},
        Line{"scene scene.json --proof -", "{", "two: standard, 1 event"}}) {
    SCOPED_TRACE(one.line);
    const CommandRun run = folder.graze(one.line);
    EXPECT_EQ(run.out.find(one.begin), 0U) << run.out;
    EXPECT_EQ(run.out.find(one.text), std::string::npos) << run.out;
    EXPECT_NE(run.err.find(one.text), std::string::npos) << run.err;
  }
}

TEST(Outputs, NothingThatIsReadIsWrittenOverHoweverItIsNamed) {
  for (const Output& output : kOutputs) {
    const bool is_table = output.line.find("--guarantees IN") != std::string::npos;
    const std::string given = is_table ? kStrict : kHit;
    const Folder folder;
    folder.write("x.json", given);
    folder.write("sub/y", "");
    std::filesystem::create_symlink("x.json", folder.path() / "soft.json");
    std::filesystem::create_hard_link(folder.path() / "x.json", folder.path() / "hard.json");
    for (const std::string& name :
         {std::string("x.json"), std::string("./x.json"), std::string("sub/../x.json"),
          std::string("soft.json"), std::string("hard.json"), (folder.path() / "x.json").string()}) {
      const std::string line = with(with(output.line, "IN", "x.json"), "OUT", name);
      SCOPED_TRACE(line);
      expect_one_complaint(folder.graze(line), name);
      EXPECT_EQ(folder.read("x.json"), given);
    }
    const std::string line = with(with(output.line, "IN", "soft.json"), "OUT", "x.json");
    SCOPED_TRACE(line);
    expect_one_complaint(folder.graze(line), "x.json");
    EXPECT_EQ(folder.read("x.json"), given);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "soft.json"));
  }
}

TEST(Outputs, StandardInputAndStandardOutputAreFilesLikeOthers) {
  const Folder folder;
  expect_one_complaint(folder.graze("cast - --proof stdin", kHit), "stdin");
  EXPECT_EQ(folder.read("stdin"), kHit);
  folder.write("x.json", kHit);
  expect_one_complaint(folder.shell("graze cast x.json >> x.json"), "x.json");
  EXPECT_EQ(folder.read("x.json"), kHit);
}

TEST(Outputs, AFileOfAFolderThatIsWrittenOrReadIsNoException) {
  const Folder folder;
  // The picture of this case would have the name of its file.
  folder.write("pictures/test-hit.svg", kHit);
  expect_one_complaint(folder.graze("draw pictures/test-hit.svg --out pictures"), "test-hit.svg");
  EXPECT_EQ(folder.read("pictures/test-hit.svg"), kHit);
  // A folder of cases is read whole, what is written into it first as well.
  folder.write("cases/x.json", kHit);
  for (const std::string name : {"cases/x.json", "cases/new.jsonl"}) {
    expect_one_complaint(folder.graze("certify --corpus cases --count 0 --rotating 0 --save " + name), name);
  }
  EXPECT_EQ(folder.read("cases/x.json"), kHit);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "cases/new.jsonl"));
}

TEST(Outputs, TwoPicturesOrTwoOutputsOfOneNameAreNotOneLost) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("y.json", with(kHit, "test/hit", "test-hit"));
  const CommandRun drawn = folder.graze("draw x.json y.json --out pictures");
  expect_one_complaint(drawn, "test-hit.svg");
  expect_one_complaint(folder.graze("merge x.json --json z.json --save z.json"), "z.json");
}

// The lines that print much and little, to a device that is full.
TEST(Outputs, StandardOutputThatIsFullIsAnError) {
  const Folder folder;
  folder.write("x.json", kHit);
  ASSERT_EQ(folder.graze("cast x.json --proof p.jsonl").exit_code, 0);
  for (const std::string line :
       {"cast x.json", "cast x.json --json", "cast x.json --plan", "check p.jsonl",
        "generate random --count 1", "generate random --count 10000", "draw x.json", "laws --list", "--help",
        "--version", "cast --help", "corpus validate x.json",
        "certify x.json --method gjk/double --queries 0", "laws x.json --law swapping"}) {
    SCOPED_TRACE(line);
    expect_one_complaint(folder.shell("graze " + line + " >/dev/full"), "standard output");
  }
}

// The answers are on stderr then, and the complaint after them.
TEST(Outputs, ProofsForStandardOutputThatIsFullAreAnError) {
  const Folder folder;
  folder.write("x.json", kHit);
  const CommandRun run = folder.shell("graze cast x.json --proof - >/dev/full");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("\ngraze: standard output: could not be written"), std::string::npos) << run.err;
}

// As other tools end: by SIGPIPE, which a shell shows as 141, and without a word.
TEST(Outputs, AReaderThatClosesThePipeEndsARunSilently) {
  const Folder folder;
  folder.write("x.json", kHit);
  ASSERT_EQ(folder.graze("cast x.json --proof p.jsonl").exit_code, 0);
  for (const std::string line :
       {"generate random --count 20000", "certify --help", "--help", "cast x.json", "cast x.json --json",
        "check p.jsonl", "laws --list", "corpus validate x.json",
        "certify x.json --method gjk/double --queries 0", "certify x.json --queries 0 --json -", "serve"}) {
    SCOPED_TRACE(line);
    // The reader is gone before the first byte is written.
    const CommandRun run =
        folder.shell("{ sleep 0.2; graze " + line + " </dev/null; echo $? >code; } | true; cat code >&1");
    EXPECT_EQ(run.out, "141\n");
    EXPECT_EQ(run.err, "");
  }
}

TEST(Outputs, AClosedStandardOutputIsAnErrorAndNoOtherFileTakesItsPlace) {
  const Folder folder;
  folder.write("x.json", kHit);
  expect_one_complaint(folder.shell("graze cast x.json >&-"), "standard output");
  expect_one_complaint(folder.shell("graze cast x.json --proof p.jsonl >&-"), "standard output");
  EXPECT_EQ(folder.read("p.jsonl").find("outcome   "), std::string::npos) << folder.read("p.jsonl");
}

TEST(Outputs, AComplaintThatNobodyCanReadIsStillAnError) {
  const Folder folder;
  EXPECT_EQ(folder.shell("graze cast missing.json 2>/dev/full").exit_code, 2);
  EXPECT_EQ(folder.shell("graze cast missing.json 2>&-").exit_code, 2);
}

TEST(Outputs, AFileThatIsFullOrCannotBeMadeIsAnError) {
  const Folder folder;
  folder.write("x.json", kHit);
  folder.write("strict.json", kStrict);
  const std::vector<std::string> lines = {"cast x.json --proof OUT",
                                          "draw x.json --out OUT",
                                          "price --only 'face gap 2' --rounds 1 --json OUT",
                                          "price --only 'face gap 2' --rounds 1 --csv OUT",
                                          "certify --family random --count 40 --queries 0 --method "
                                          "mpr/double --guarantees strict.json --save OUT",
                                          "stability --family random --count 10 --method mpr/double "
                                          "--guarantees strict.json --save OUT"};
  for (const std::string& line : lines) {
    for (const std::string name : {"/dev/full", "no/such/folder/out", "."}) {
      const bool is_folder_of_pictures = line.starts_with("draw") && name == ".";
      if (is_folder_of_pictures) continue;
      SCOPED_TRACE(line + " " + name);
      expect_one_complaint(folder.graze(with(line, "OUT", name)), name);
    }
  }
  expect_one_complaint(folder.graze("stability --family random --plot x.json/folder"), "x.json/folder");
}

}  // namespace
}  // namespace graze
