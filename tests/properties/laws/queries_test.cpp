// Every law of the queries beside the cast, for every method, over cases drawn by RapidCheck, the families,
// and the curated corpus.
//
// The seed is fixed, and printed with a failure. RC_PARAMS="seed=... max_success=..." in the environment
// draws others.
#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/large_hull.hpp"
#include "properties/laws/reach.hpp"
#include "tests/properties/generate/drawn_run.hpp"

namespace graze::law {
namespace {

const bool kGiven = takes_given_parameters("seed=20260117");

// The law of bad input replaces every number of a case by four bad ones. The oracle takes milliseconds.
bool is_slow(const Law& law) {
  return law.needs == Needs::oracle || law.name == "query_bad_input_is_refused";
}

// Each law sees a share of the families' levels and of the curated cases. The share depends on this index of
// the law.
std::size_t turn_of(const Law& law) {
  const auto named = [&](const Law& one) { return one.name == law.name; };
  return static_cast<std::size_t>(
      std::find_if(laws(engine::Kind::query).begin(), laws(engine::Kind::query).end(), named) -
      laws(engine::Kind::query).begin());
}

class QueryLaws : public testing::TestWithParam<Law> {};

TEST_P(QueryLaws, HoldForDrawnCases) {
  const Law& law = GetParam();
  LawRun run(law, "drawn");
  const std::string fault =
      fault_of_drawn(run, cases(), kGiven ? std::nullopt : std::optional<int>(is_slow(law) ? 60 : 240));
  ASSERT_TRUE(fault.empty()) << fault;
  EXPECT_EQ(run.shortfall(), "");
}

TEST_P(QueryLaws, HoldForTheFamilies) {
  const Law& law = GetParam();
  LawRun run(law, "families");
  for (const corpus::Family& family : families_of(Kind::query)) {
    // Every second level, and every fourth for slow laws, but at least one.
    const std::size_t levels = family.levels.size(), stride = is_slow(law) ? 4 : 2;
    for (std::size_t i = 0; i < levels; i += stride) {
      const std::size_t level = (i + turn_of(law)) % levels;
      const double hardness = family.levels[level];
      const auto seed = static_cast<std::uint64_t>(level);
      if (run.holds_for(family.generate(hardness, seed), family.name)) continue;
      run.minimise();
      FAIL() << run.report(seed_of(family.name, hardness, seed));
    }
    // If the law applied to none of these cases, more cases are drawn.
    for (std::uint64_t seed = 0; seed < 32 && !run.tally().reached(std::string(family.name)); ++seed) {
      const double hardness = family.levels[seed % levels];
      EXPECT_TRUE(run.holds_for(family.generate(hardness, seed), family.name))
          << run.report(seed_of(family.name, hardness, seed));
    }
  }
  run.print();
  EXPECT_EQ(run.shortfall_over_families(), "");
}

TEST_P(QueryLaws, HoldForLargeHulls) {
  LawRun run(GetParam(), "large hulls");
  corpus::Random random(20261127);
  for (int i = 0; i < (is_slow(GetParam()) ? 2 : 10); ++i) {
    if (run.holds_for(draw_large_hull(random))) continue;
    run.minimise();
    FAIL() << run.report("large hulls " + std::to_string(i));
  }
  run.print();
}

TEST_P(QueryLaws, HoldForTheCuratedCorpus) {
  const corpus::ReadResult curated = corpus::read_directory(GRAZE_SOURCE_DIR "/corpus/cases");
  ASSERT_TRUE(curated.ok()) << curated.errors.front().text();
  LawRun run(GetParam(), "curated");
  const std::size_t share = is_slow(GetParam()) ? 12 : 3, turn = turn_of(GetParam());
  for (const corpus::Case& problem : curated.cases) {
    if ((hash_of(problem) + turn) % share != 0) continue;
    EXPECT_TRUE(run.holds_for(problem)) << run.report(problem.id + " of the corpus");
  }
  run.print();
  EXPECT_EQ(run.shortfall(), "");
}

INSTANTIATE_TEST_SUITE_P(All, QueryLaws,
                         testing::ValuesIn(laws(engine::Kind::query).begin(),
                                           laws(engine::Kind::query).end()),
                         [](const testing::TestParamInfo<Law>& law) { return std::string(law.param.name); });

}  // namespace

// GoogleTest prints a parameter by its name.
void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

}  // namespace graze::law
