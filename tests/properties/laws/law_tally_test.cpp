// The tally reports the gaps of a run: a law that never applied, an outcome or a family that was never
// reached, more unconverged answers than the guarantee allows, and a declaration that is not true any more.
#include "properties/laws/law_tally.hpp"

#include <gtest/gtest.h>

#include <set>

#include "engines/guarantees.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/reach.hpp"

namespace graze::law {
namespace {

Law named(const std::string& name, Kind kind = Kind::linear) {
  return {.name = name, .sentence = "A sentence.", .needs = Needs::metamorphic, .check = {}, .kind = kind};
}

const std::vector<std::string_view> kOutcomes = {"hit", "miss", "initially_overlapping"};

TEST(LawTally, ALawThatNeverAppliesIsReported) {
  LawTally tally(named("idle"));
  EXPECT_EQ(tally.shortfall_of_outcomes(), "idle never applied");
  for (int i = 0; i < 10; ++i) tally.add(0, "touching", not_applicable("not of its kind"));
  EXPECT_EQ(tally.shortfall_of_outcomes(), "idle never applied");
  EXPECT_EQ(tally.not_applicable(), 10U);
  EXPECT_NE(tally.shortfall_of_families().find("touching"), std::string::npos);
}

TEST(LawTally, AnOutcomeThatWasNeverSeenIsNamed) {
  LawTally tally(named("narrow"));
  tally.add(0, "", holds({"hit"}));
  tally.add(1, "", holds({"miss"}));
  EXPECT_EQ(tally.shortfall_of_outcomes(), "narrow saw no initially_overlapping");
  tally.add(1, "", holds({"initially_overlapping", "and more"}));
  EXPECT_EQ(tally.shortfall_of_outcomes(), "");
  EXPECT_EQ(tally.text(), "narrow:  and more 1  hit 1  initially_overlapping 1  miss 1");
}

TEST(LawTally, AQueryMayKnowContactByEitherName) {
  LawTally tally(named("apart_or_not", Kind::query));
  tally.add(0, "", holds({"miss"}));
  EXPECT_EQ(tally.shortfall_of_outcomes(), "apart_or_not saw no contact");
  tally.add(0, "", holds({"initially_overlapping"}));
  EXPECT_EQ(tally.shortfall_of_outcomes(), "");
  // A law that did not apply saw nothing, but an oracle called in vain is counted.
  LawResult open = not_applicable("the oracle is open");
  open.labels = {"undecided"};
  tally.add(0, "", open);
  EXPECT_EQ(tally.not_applicable(), 1U);
  EXPECT_EQ(tally.left_open(), 1U);
}

TEST(LawTally, AFamilyThatWasNeverReachedIsNamed) {
  LawTally tally(named("choosy"));
  for (const corpus::Family& family : corpus::families()) {
    if (family.name == "needles" || family.name == "plates") {
      tally.add(0, family.name, not_applicable("too long or too flat"));
    } else {
      tally.add(0, family.name, holds(kOutcomes));
    }
  }
  EXPECT_NE(tally.shortfall_of_families().find("choosy never applied to a case of needles, plates;"),
            std::string::npos)
      << tally.shortfall_of_families();
  LawTally rest(named("choosy"));
  for (const char* family : {"needles", "plates"}) rest.add(0, family, holds(kOutcomes));
  tally.add(rest);
  EXPECT_EQ(tally.shortfall_of_families(), "");
}

TEST(LawTally, StallsAreHeldToTheRow) {
  std::size_t mpr = 0;
  while (engine::methods(engine::Kind::linear)[mpr].full_name() != "mpr/double") ++mpr;
  const engine::Guarantee* row =
      engine::find_guarantee(engine::guarantees(), engine::methods(engine::Kind::linear)[mpr]);
  ASSERT_NE(row, nullptr);
  LawTally tally(named("patient"));
  for (int i = 0; i < 1000; ++i) tally.add(mpr, "", holds({"hit"}));
  EXPECT_EQ(tally.excess_of_stalls(), "");
  const auto allowed = static_cast<int>(row->stall_cap > 0 ? std::max(1.0, row->stall_cap * 1000) : 0);
  for (int i = 0; i <= allowed; ++i) tally.add(mpr, "", holds({"hit", "not_converged"}));
  EXPECT_NE(tally.excess_of_stalls().find("mpr/double did not converge"), std::string::npos);
}

TEST(LawTally, TwoHalvesAreTheWhole) {
  LawTally whole(named("split")), one(named("split")), two(named("split"));
  for (int i = 0; i < 20; ++i) {
    const LawResult result = i % 5 == 4 ? broken("no") : holds({kOutcomes[static_cast<std::size_t>(i) % 3]});
    whole.add(0, "random", result);
    (i % 2 == 0 ? one : two).add(0, "random", result);
  }
  one.add(two);
  EXPECT_EQ(one.text(), whole.text());
  EXPECT_EQ(one.applied(), 20U);
  EXPECT_EQ(one.broken(), 4U);
  EXPECT_TRUE(one.reached("random"));
}

// Every declaration names a law, and existing families and outcomes. Every name belongs to one law.
TEST(LawReach, DeclaresNothingThatIsNotThere) {
  std::set<std::string> names;
  for (const Law& law : laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name << " is the name of two laws";
    EXPECT_FALSE(law.sentence.empty()) << law.name;
    EXPECT_FALSE(law.methods().empty()) << law.name;
  }
  for (const OutOfReach& one : out_of_reach()) {
    EXPECT_TRUE(names.contains(std::string(one.law))) << one.law << " is no law";
    EXPECT_FALSE(one.why.empty()) << one.law;
    EXPECT_FALSE(one.outcomes.empty() && one.families.empty()) << one.law;
    for (std::string_view words : {one.families, one.outcomes}) {
      while (!words.empty()) {
        const std::string_view word = words.substr(0, words.find(' '));
        words.remove_prefix(std::min(word.size() + 1, words.size()));
        const bool is_outcome =
            word == kContact || std::find(kOutcomes.begin(), kOutcomes.end(), word) != kOutcomes.end();
        EXPECT_TRUE(is_outcome || corpus::find_family(word) != nullptr) << one.law << ": " << word;
      }
    }
  }
}

}  // namespace
}  // namespace graze::law
