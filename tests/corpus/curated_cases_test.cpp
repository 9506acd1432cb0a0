// The curated cases: all read, all answered, flags and notes in both directions, and the answers derived
// again.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "corpus/case_io.hpp"
#include "corpus/flags.hpp"
#include "corpus/location.hpp"
#include "oracles/derive.hpp"

namespace graze::corpus {
namespace {

const ReadResult& curated() {
  static const ReadResult result = read_directory(corpus_directory() / "cases");
  return result;
}

TEST(CuratedCases, AllRead) {
  for (const ReadError& error : curated().errors) ADD_FAILURE() << error.text();
  EXPECT_GE(curated().cases.size(), 370u);
}

TEST(CuratedCases, IdsAreUniqueAndBeginWithTheirFamily) {
  std::set<std::string> ids;
  for (const Case& problem : curated().cases) {
    EXPECT_TRUE(ids.insert(problem.id).second) << problem.id;
    EXPECT_EQ(problem.id.substr(0, problem.id.find('/')), problem.family);
  }
}

TEST(CuratedCases, SayWhyTheyAreHard) {
  for (const Case& problem : curated().cases) {
    EXPECT_GE(problem.comment.size(), 20u) << problem.id;
    EXPECT_FALSE(problem.flags.empty()) << problem.id;
    if (problem.family == "reported") {
      EXPECT_EQ(problem.source.substr(0, 8), "https://") << problem.id;
    }
  }
}

TEST(CuratedCases, CiteEveryReportOfTheseShapesWithFullNumbers) {
  // Casts, ray casts, rotating casts, distances, overlaps and penetrations in the trackers surveyed.
  const char* const reports[] = {"jolt-383",
                                 "jolt-511",
                                 "jolt-886",
                                 "jolt-1787",
                                 "jolt-217",
                                 "jolt-2103",
                                 "jolt-1008",
                                 "jolt-940",
                                 "jolt-293",
                                 "jolt-417",
                                 "jolt-1379a",
                                 "jolt-longcapsule",
                                 "parry-180",
                                 "parry-19",
                                 "parry-70",
                                 "parry-205",
                                 "parry-raycastfuzz",
                                 "bevy_rapier-119",
                                 "ncollide-123",
                                 "ncollide-214",
                                 "ncollide-157",
                                 "collision-rs-111",
                                 "cute-256",
                                 "cute-lundmark",
                                 "cute-133",
                                 "box2d-625",
                                 "box2d-shortedge",
                                 "libccd-25",
                                 "fcl-293",
                                 "fcl-508",
                                 "fcl-275",
                                 "fcl-408",
                                 "fcl-319",
                                 "fcl-390",
                                 "fcl-388",
                                 "fcl-395",
                                 "fcl-415",
                                 "fcl-398",
                                 "fcl-493",
                                 "fcl-391",
                                 "drake-21673-convex1",
                                 "drake-21673-convex2",
                                 "drake-21673-convex4",
                                 "drake-21673-convex5",
                                 "drake-21234-convex8",
                                 "drake-21234-cyl",
                                 "openGJK-52",
                                 "distance3d-27",
                                 "mujoco-3383",
                                 "mujoco-thin-gap",
                                 "mujoco-boxdepth2",
                                 "mujoco-boxdepth3",
                                 "mujoco_warp-1527",
                                 "mujoco_warp-1430",
                                 "mujoco_warp-max",
                                 "physx-600",
                                 "physx-610",
                                 "bepu-101",
                                 "parry-317",
                                 "box2d-115",
                                 "box2d-preset-toi",
                                 "ncollide-369",
                                 "fcl-505"};
  for (const std::string report : reports) {
    const std::string id = "reported/" + report;
    const bool found = std::any_of(curated().cases.begin(), curated().cases.end(), [&](const Case& problem) {
      return problem.id == id || problem.id.substr(0, id.size() + 1) == id + "-";
    });
    EXPECT_TRUE(found) << report;
  }
}

TEST(CuratedCases, EveryFlagHasANoteAndEveryNoteIsUsed) {
  const FlagNotes flags = read_flag_notes_file(corpus_directory() / "flags.json");
  ASSERT_EQ(flags.error, "");
  for (const std::string& line : flag_mismatches(curated().cases, flags)) ADD_FAILURE() << line;
}

TEST(CuratedCases, AMissingNoteAnUnusedNoteAndAWrongCaseAreNoticed) {
  FlagNotes flags = read_flag_notes_file(corpus_directory() / "flags.json");
  flags.notes.erase("Ray");
  flags.notes["Unused"] = {"x", "y", {}};
  flags.notes["Graze"].cases = {"no/such-case", "touching/resting-cubes"};
  const std::vector<std::string> lines = flag_mismatches(curated().cases, flags);
  const auto says = [&](const std::string& part) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(says("the flag Ray has no note"));
  EXPECT_TRUE(says("the note on Unused is used by no case"));
  EXPECT_TRUE(says("names no/such-case, which does not exist"));
  EXPECT_TRUE(says("names touching/resting-cubes, which lacks the flag"));
}

TEST(CuratedCases, ReadBackAsTheyWereWritten) {
  for (const Case& problem : curated().cases) {
    const ReadResult again = read_text(write_case(problem), problem.id, false);
    ASSERT_TRUE(again.ok()) << again.errors[0].text();
    EXPECT_TRUE(same_case(again.cases[0], problem)) << problem.id;
  }
}

TEST(CuratedCases, TheOracleGivesTheStoredAnswersAgain) {
  std::size_t hits = 0, misses = 0, starts = 0, unanswered = 0;
  for (const Case& problem : curated().cases) {
    if (!problem.expect) {
      // No answer is stored where no oracle gives one, and nowhere else.
      EXPECT_THROW((void)oracle::derive_expectation(problem), std::invalid_argument) << problem.id;
      ++unanswered;
      continue;
    }
    const Expect derived = oracle::derive_expectation(problem);
    EXPECT_EQ(problem.expect->outcome, derived.outcome) << problem.id;
    EXPECT_EQ(problem.expect->by, derived.by) << problem.id;
    EXPECT_EQ(problem.expect->distance, derived.distance) << problem.id;
    EXPECT_EQ(problem.expect->depth, derived.depth) << problem.id;
    EXPECT_EQ(problem.expect->normal, derived.normal) << problem.id;
    EXPECT_EQ(problem.expect->t_in, derived.t_in) << problem.id;
    EXPECT_EQ(problem.expect->t_out, derived.t_out) << problem.id;
    hits += derived.outcome == Outcome::hit;
    misses += derived.outcome == Outcome::miss;
    starts += derived.outcome == Outcome::initially_overlapping;
    if (derived.outcome == Outcome::miss) continue;
    EXPECT_EQ(problem.expect->toi_lower, derived.toi_lower) << problem.id;
    EXPECT_EQ(problem.expect->toi_upper, derived.toi_upper) << problem.id;
    EXPECT_EQ(problem.expect->toi_exact, derived.toi_exact) << problem.id;
  }
  EXPECT_GT(hits, 40u);
  EXPECT_GT(misses, 20u);
  EXPECT_GT(starts, 20u);
  EXPECT_LT(unanswered, curated().cases.size() / 4);
}

}  // namespace
}  // namespace graze::corpus
