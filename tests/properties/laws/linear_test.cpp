// Every law of linear casts, for every method, over cases drawn by RapidCheck, the families, and the curated
// corpus.
//
// The seed is fixed, and printed with a failure. RC_PARAMS="seed=... max_success=..." in the environment
// draws other cases, and as large a share of the families. With a small share, a law may meet no case of a
// family that it applies to, and reports so.
#include <gtest/gtest.h>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/generate/large_hull.hpp"
#include "properties/generate/near_ball.hpp"
#include "properties/generate/round_tie.hpp"
#include "properties/laws/reach.hpp"
#include "tests/properties/generate/drawn_run.hpp"

namespace graze::law {
namespace {

const bool kGiven = takes_given_parameters("seed=20260117");

// Cases for each law. With an oracle a case costs milliseconds, without one microseconds.
int budget(Needs needs) { return needs == Needs::oracle ? 2000 : 4000; }
int family_seeds(Needs needs) {
  const int usual = needs == Needs::oracle ? 40 : 200;
  return kGiven ? usual * rc::detail::configuration().testParams.maxSuccess / budget(needs) : usual;
}

class Laws : public testing::TestWithParam<Law> {};

TEST_P(Laws, HoldForDrawnCases) {
  const Law& law = GetParam();
  LawRun run(law, "drawn");
  const std::string fault =
      fault_of_drawn(run, cases(), kGiven ? std::nullopt : std::optional<int>(budget(law.needs)));
  ASSERT_TRUE(fault.empty()) << fault;
  EXPECT_EQ(run.shortfall(), "");
}

TEST_P(Laws, HoldForTheFamilies) {
  const Law& law = GetParam();
  LawRun run(law, "families");
  for (const corpus::Family& family : families_of(Kind::linear)) {
    for (const double hardness : family.levels) {
      for (int i = 0; i < family_seeds(law.needs) / static_cast<int>(family.levels.size()) + 1; ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        if (run.holds_for(family.generate(hardness, seed), family.name)) continue;
        run.minimise();
        FAIL() << run.report(seed_of(family.name, hardness, seed));
      }
    }
  }
  run.print();
  EXPECT_EQ(run.shortfall_over_families(), "");
}

void expect_to_hold(const Law& law, const std::string& name, std::uint64_t seed,
                    corpus::Case (*draw)(corpus::Random&), int count) {
  LawRun run(law, name);
  corpus::Random random(seed);
  for (int i = 0; i < count; ++i) {
    if (run.holds_for(draw(random))) continue;
    run.minimise();
    FAIL() << run.report(name + " " + std::to_string(i));
  }
  run.print();
}

TEST_P(Laws, HoldForFlanksOfRoundBodies) {
  expect_to_hold(GetParam(), "flanks", 20260118, &draw_round_tie, family_seeds(GetParam().needs) / 4);
}

TEST_P(Laws, HoldForBallsOnNearTies) {
  expect_to_hold(GetParam(), "balls on near ties", 20261126, &draw_near_ball,
                 family_seeds(GetParam().needs) / 4);
}

// To make one takes longer than to ask an oracle about it.
TEST_P(Laws, HoldForLargeHulls) {
  expect_to_hold(GetParam(), "large hulls", 20261127, &draw_large_hull, family_seeds(Needs::oracle) / 4);
}

TEST_P(Laws, HoldForTheCuratedCorpus) {
  const corpus::ReadResult curated = corpus::read_directory(GRAZE_SOURCE_DIR "/corpus/cases");
  ASSERT_TRUE(curated.ok()) << curated.errors.front().text();
  LawRun run(GetParam(), "curated");
  for (const corpus::Case& problem : curated.cases) {
    EXPECT_TRUE(run.holds_for(problem)) << run.report(problem.id + " of the corpus");
  }
  run.print();
  EXPECT_EQ(run.shortfall(), "");
}

INSTANTIATE_TEST_SUITE_P(All, Laws, testing::ValuesIn(laws(Kind::linear).begin(), laws(Kind::linear).end()),
                         [](const testing::TestParamInfo<Law>& law) { return std::string(law.param.name); });

}  // namespace

// GoogleTest prints a parameter by its name.
void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

}  // namespace graze::law
