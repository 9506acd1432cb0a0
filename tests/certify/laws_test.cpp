// Laws over suites: the counts, the findings of a broken law, and equal results for any number of threads.
#include "certify/laws.hpp"

#include <gtest/gtest.h>

#include "certify/suites.hpp"
#include "corpus/families.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using law::Law;
using law::LawResult;

// "Nothing is hit", broken by every hit of either method.
Law nothing_is_hit() {
  return {.name = "nothing_is_hit",
          .sentence = "Nothing is ever hit.",
          .needs = law::Needs::metamorphic,
          .check = [](const corpus::Case& problem, const engine::Method& method) -> LawResult {
            if (method.full_name() != "mpr/double" && method.full_name() != "gjk/double")
              return law::not_applicable("another method");
            if (!law::is_linear_question(problem)) return law::not_applicable("no linear cast");
            const Outcome outcome = method.ask(problem, {}).outcome;
            if (outcome == Outcome::hit) return law::broken("it is hit");
            return law::holds({law::label_of(outcome)});
          },
          .kind = Kind::linear};
}

Law counts_turning() {
  return {.name = "counts_turning",
          .sentence = "It holds.",
          .needs = law::Needs::metamorphic,
          .check = [](const corpus::Case&, const engine::Method& method) -> LawResult {
            return method.full_name() == "plan/double" ? law::holds({"miss"})
                                                       : law::not_applicable("another");
          },
          .kind = Kind::rotating};
}

std::vector<LawSuite> small_suites() {
  const corpus::Family &lattice = *corpus::find_family("lattice"), &spin = *corpus::find_family("pure_spin");
  return {{.suite = drawn_suite(lattice, lattice.levels, 30, 1),
           .seed = [](std::size_t i) { return "number " + std::to_string(i); }},
          {.suite = drawn_suite(spin, spin.levels, 5, 1)}};
}

TEST(LawCertification, CountsAndFindsTheFirstCaseThatBreaksMadeSmall) {
  const std::vector<LawSuite> suites = small_suites();
  const LawSettings settings{.laws = {nothing_is_hit(), counts_turning()}};
  const LawCertification result = certify_laws(suites, settings);
  EXPECT_EQ(result.cases, 35U);
  EXPECT_EQ(result.tallies[0].applied(), 60U);
  EXPECT_EQ(result.tallies[1].count("miss"), 5U);
  ASSERT_EQ(result.breaches.size(), 2U);
  const LawBreach& breach = result.breaches[0];
  EXPECT_EQ(breach.finding.method, "gjk/double");
  EXPECT_EQ(breach.times + result.breaches[1].times, result.tallies[0].broken());

  // The first: none before it breaks the law. The seed draws it.
  const Law law = nothing_is_hit();
  const engine::Method& first = law.methods()[breach.method];
  for (std::size_t i = 0; i < breach.index; ++i) {
    EXPECT_NE(law.check(suites[0].suite.at(i), first).holding, law::Holding::broken);
  }
  EXPECT_EQ(breach.first, suites[0].suite.at(breach.index).id);
  EXPECT_EQ(breach.finding.seed, "number " + std::to_string(breach.index));
  EXPECT_EQ(law.check(breach.finding.problem, first).holding, law::Holding::broken);
  EXPECT_TRUE(std::holds_alternative<Point<double>>(breach.finding.problem.a.shape));
  EXPECT_TRUE(std::holds_alternative<Point<double>>(breach.finding.problem.b.shape));
  for (const double x : law::scalars(breach.finding.problem)) EXPECT_LE(std::abs(x), 2);

  const std::string table = law_table(result, settings);
  EXPECT_NE(table.find("nothing_is_hit"), std::string::npos) << table;
  EXPECT_NE(table.find("rotating"), std::string::npos) << table;
}

TEST(LawCertification, TheThreadsChangeNothing) {
  const std::vector<LawSuite> suites = small_suites();
  LawSettings settings{.laws = {nothing_is_hit(), counts_turning()}};
  const LawCertification one = certify_laws(suites, settings);
  settings.threads = 4;
  const LawCertification four = certify_laws(suites, settings);
  EXPECT_EQ(law_table(one, settings), law_table(four, settings));
  ASSERT_EQ(one.breaches.size(), four.breaches.size());
  for (std::size_t i = 0; i < one.breaches.size(); ++i) {
    EXPECT_EQ(one.breaches[i].first, four.breaches[i].first);
    EXPECT_EQ(one.breaches[i].times, four.breaches[i].times);
    EXPECT_TRUE(law::same_input(one.breaches[i].finding.problem, four.breaches[i].finding.problem));
  }
}

TEST(LawCertification, AsksTheMethodsThatAreWanted) {
  LawSettings settings{.laws = {nothing_is_hit()}};
  settings.is_asked = [](const engine::Method& method) { return method.full_name() == "gjk/double"; };
  const LawCertification result = certify_laws(small_suites(), settings);
  EXPECT_EQ(result.tallies[0].applied(), 30U);
  ASSERT_EQ(result.breaches.size(), 1U);
  EXPECT_EQ(result.breaches[0].finding.method, "gjk/double");
}

TEST(Suites, DealTheCasesToTheLevels) {
  const corpus::Family& family = *corpus::find_family("touching");
  const std::size_t levels = family.levels.size();
  const Suite suite = drawn_suite(family, family.levels, 2 * levels + 1, 7);
  std::vector<std::size_t> by_level(levels);
  for (std::size_t i = 0; i < suite.size(); ++i) {
    for (std::size_t l = 0; l < levels; ++l) by_level[l] += suite.at(i).hardness == family.levels[l];
  }
  EXPECT_EQ(by_level[0], 3U);
  for (std::size_t l = 1; l < levels; ++l) EXPECT_EQ(by_level[l], 2U) << l;
  EXPECT_EQ(suite.at(0).id, family.generate(family.levels[0], 7).id);
  EXPECT_THROW((void)wanted_families({"touchy"}, false), std::runtime_error);
  EXPECT_TRUE(wanted_families({}, true).empty());
}

}  // namespace
}  // namespace graze::tool
