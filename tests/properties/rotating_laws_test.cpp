// Every law of rotating casts, for every rotating method, over drawn cases, the families, and the corpus.
//
// The oracle's answer to a case costs more than all laws about it, so a case goes through every law before
// the next is drawn. The seed is fixed, and printed with a failure; RC_PARAMS="seed=... max_success=..." in
// the environment draws others.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>

#include "corpus/families.hpp"
#include "properties/case_edit.hpp"
#include "properties/generators.hpp"
#include "properties/judge.hpp"
#include "properties/judge_rotating.hpp"
#include "properties/laws_rotating.hpp"

namespace graze::law {
namespace {

constexpr const char* kDefaultParameters = "seed=20261121";
// Before RapidCheck reads its configuration.
const bool kGiven = [] {
  const bool given = std::getenv("RC_PARAMS") != nullptr;
  setenv("RC_PARAMS", kDefaultParameters, 0);
  return given;
}();
constexpr int kDrawnCases = 120;
// The easier half of the levels, where a case takes every law together a tenth of a second; the hardest take
// the oracle and conservative advancement many seconds, and are for campaigns.
constexpr int kFamilySeeds = 1;

// All laws over many cases: what was drawn is counted, what broke is kept.
class RotatingRun {
 public:
  // True if every law holds or does not apply, for every method.
  bool holds_for(const corpus::Case& problem) {
    for (const RotatingLaw& law : rotating_laws()) {
      for (const engine::RotatingEngineMethod& method : engine::rotating_methods()) {
        if (!holds_for(problem, law, method)) return false;
      }
    }
    return true;
  }

  // The broken case made small by the law and the method that it broke; then maybe for another reason.
  void minimise() {
    const RotatingLaw& law = *broken_law_;
    const engine::RotatingEngineMethod& method = *broken_method_;
    const corpus::Case least = minimised(
        failing_, [&](const corpus::Case& c) { return law.check(c, method).holding == Holding::broken; },
        2000);
    (void)holds_for(least, law, method);
  }

  [[nodiscard]] std::string report() const {
    std::ostringstream out;
    out << "law " << broken_law_->name << " is broken: " << broken_law_->sentence << "\n"
        << broken_method_->full_name() << ": " << reason_ << "\n"
        << corpus::write_case(failing_) << "\n";
    return out.str();
  }

  // Empty, or which law never applied, or which outcome it never saw.
  [[nodiscard]] std::string shortfall() const {
    for (const RotatingLaw& law : rotating_laws()) {
      const auto found = counts_.find(law.name);
      if (found == counts_.end()) return std::string(law.name) + " never applied";
      for (const char* outcome : {"hit", "miss", "initially_overlapping"}) {
        // Where bodies stand still to each other, or begin with a step apart, there is no such outcome.
        if (law.name == "as_one_stands_still" && outcome == std::string_view("hit")) continue;
        if (law.name == "turning_splitting" && outcome == std::string_view("initially_overlapping")) continue;
        if (!found->second.contains(outcome)) return std::string(law.name) + " saw no " + outcome;
      }
    }
    return "";
  }

  void print(const char* source) const {
    for (const auto& [law, labels] : counts_) {
      std::cout << law << " over " << source << ":";
      for (const auto& [label, count] : labels) std::cout << "  " << label << " " << count;
      std::cout << "\n";
    }
  }

 private:
  bool holds_for(const corpus::Case& problem, const RotatingLaw& law,
                 const engine::RotatingEngineMethod& method) {
    LawResult result = law.check(problem, method);
    if (result.holding == Holding::broken) {
      reason_ = std::move(result.reason);
      failing_ = problem;
      broken_law_ = &law;
      broken_method_ = &method;
      return false;
    }
    std::map<std::string, int>* labels = nullptr;
    if (result.holding == Holding::holds) labels = &counts_[law.name];
    if (labels != nullptr) {
      for (const std::string_view label : result.labels) ++(*labels)[std::string(label)];
    }
    return true;
  }

  std::map<std::string_view, std::map<std::string, int>> counts_;
  std::string reason_;
  corpus::Case failing_;
  const RotatingLaw* broken_law_ = nullptr;
  const engine::RotatingEngineMethod* broken_method_ = nullptr;
};

TEST(RotatingLaws, hold_for_drawn_cases) {
  RotatingRun run;
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  if (!kGiven) parameters.maxSuccess = kDrawnCases;
  const rc::Gen<Drawn> generator = rotating_cases();
  const rc::detail::TestResult result = rc::detail::checkTestable(
      [&] {
        const Drawn drawn = *generator;
        RC_ASSERT(run.holds_for(drawn.problem));
      },
      rc::detail::TestMetadata{"rotating laws", "every law holds"}, parameters);
  run.print("drawn");
  if (!result.is<rc::detail::SuccessResult>()) {
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    FAIL() << run.report() << "\nRC_PARAMS=\"" << std::getenv("RC_PARAMS") << "\"\n" << text.str();
  }
  EXPECT_EQ(run.shortfall(), "");
}

TEST(RotatingLaws, hold_for_the_families) {
  RotatingRun run;
  for (const corpus::Family& family : corpus::rotating_families()) {
    for (const double hardness : family.levels.first((family.levels.size() + 1) / 2)) {
      for (int seed = 0; seed < kFamilySeeds; ++seed) {
        if (run.holds_for(family.generate(hardness, static_cast<std::uint64_t>(seed)))) continue;
        run.minimise();
        FAIL() << run.report();
      }
    }
  }
  run.print("families");
}

TEST(RotatingLaws, hold_for_the_curated_corpus) {
  const corpus::ReadResult curated = corpus::read_directory(GRAZE_SOURCE_DIR "/corpus/cases");
  ASSERT_TRUE(curated.ok()) << curated.errors.front().text();
  RotatingRun run;
  int turning = 0;
  for (const corpus::Case& problem : curated.cases) {
    if (!engine::turns(problem)) continue;
    ++turning;
    EXPECT_TRUE(run.holds_for(problem)) << run.report();
  }
  run.print("curated");
  EXPECT_GE(turning, 24);
}

TEST(DrawRotating, reaches_every_outcome_and_every_way_to_turn) {
  corpus::Random random(5);
  std::map<Outcome, int> outcomes;
  std::map<Effects, int> effects;
  int both = 0, pivots = 0, many_turns = 0, undecided = 0;
  constexpr int kCases = 200;
  const engine::RotatingEngineMethod& plan = *engine::find_rotating_method("plan/double");
  for (int i = 0; i < kCases; ++i) {
    const corpus::Case problem = draw_rotating(random, i % 100);
    ASSERT_TRUE(in_domain(problem)) << corpus::write_case(problem);
    const bool a = problem.spin_a.rotation != Vec3<double>::Zero(),
               b = problem.spin_b.rotation != Vec3<double>::Zero();
    both += a && b;
    pivots += problem.spin_a.pivot != Vec3<double>::Zero() && a;
    many_turns += problem.spin_a.rotation.norm() > 6.3 || problem.spin_b.rotation.norm() > 6.3;
    if (!is_rotating_question(problem)) continue;
    ++effects[plan.plan(problem, {}).effects];
    const engine::RotatingAnswer answer = plan.cast(problem, {});
    ++outcomes[answer.outcome];
    undecided += answer.outcome == Outcome::not_converged;
  }
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::initially_overlapping}) {
    EXPECT_GE(outcomes[outcome], kCases / 10) << label_of(outcome);
  }
  for (const Effects one : {Effects::nothing, Effects::at_rest, Effects::linear}) {
    EXPECT_GE(effects[one], kCases / 50) << to_text(one);
  }
  EXPECT_GE(effects[Effects::rotating], kCases / 3);
  EXPECT_GE(both, kCases / 5);
  EXPECT_GE(pivots, kCases / 5);
  EXPECT_GE(many_turns, kCases / 20);
  EXPECT_LE(undecided, kCases / 10);
}

TEST(DrawRotating, is_a_function_of_its_bits) {
  corpus::Random one(99), two(99);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(same_input(draw_rotating(one, i), draw_rotating(two, i)));
}

TEST(Simpler, a_turn_shrinks_away_or_to_small_integers) {
  corpus::Random random(13);
  // Everything fails: nothing turns in the end.
  for (int i = 0; i < 5; ++i) {
    const corpus::Case least =
        minimised(draw_rotating(random, 50), [](const corpus::Case& c) { return in_domain(c); });
    EXPECT_FALSE(has_spin(least)) << corpus::write_case(least);
  }
  // A turn about a far pivot is needed: it stays, and little else.
  const auto needed = [](const corpus::Case& c) {
    return in_domain(c) && c.spin_a.rotation.norm() > 0.5 && c.spin_a.pivot.norm() > 1.5;
  };
  int shrunk = 0;
  while (shrunk < 3) {
    const corpus::Case problem = draw_rotating(random, 50);
    if (!needed(problem)) continue;
    ++shrunk;
    const corpus::Case least = minimised(problem, needed);
    EXPECT_TRUE(needed(least));
    EXPECT_TRUE(least.spin_b.rotation.isZero(0) && least.spin_b.pivot.isZero(0));
    for (const double x : scalars(least)) EXPECT_LE(std::abs(x), 2) << corpus::write_case(least);
  }
}

// The edits that the laws rest on, by the oracle: the true answer is what the edit promises.
TEST(CaseEdit, true_rotating_answers_are_related_as_the_laws_say) {
  corpus::Random random(17);
  int turned = 0, longer = 0, unseen = 0, alike = 0, restarts = 0, decided = 0;
  for (int i = 0; decided < 60; ++i) {
    ASSERT_LT(i, 300);
    const corpus::Case problem = draw_rotating(random, i % 40);
    if (!is_rotating_question(problem)) continue;
    const oracle::RotatingTruth own(problem, oracle::RotatingTruth::kDefaultWidth, kTruthBudget);
    if (own.outcome() == Outcome::not_converged) continue;
    ++decided;
    const std::string shown = corpus::write_case(problem);
    const Times times{own.toi_lower(), own.toi_upper()};
    const auto meets = [&](const corpus::Case& other, double factor) {
      const oracle::RotatingTruth* its = rotating_truth_of(other);
      return its == nullptr || overlap(times, Times{its->toi_lower() * factor, its->toi_upper() * factor});
    };
    EXPECT_TRUE(meets(swapped(problem), 1)) << shown;
    EXPECT_TRUE(meets(mirrored(problem), 1)) << shown;
    if (const auto other = turned_about(problem, hash_of(problem))) {
      EXPECT_TRUE(meets(*other, 1)) << shown;
      ++turned;
    }
    if (const auto other = stretched(problem, 2)) {
      EXPECT_TRUE(meets(*other, 0.25)) << shown;
      ++longer;
    }
    if (const auto other = with_unseen_turn(problem, true, hash_of(problem))) {
      corpus::Case still = *other;
      still.spin_a = {};
      const oracle::RotatingTruth *one = rotating_truth_of(*other), *two = rotating_truth_of(still);
      if (one != nullptr && two != nullptr) {
        EXPECT_TRUE(overlap({one->toi_lower(), one->toi_upper()}, {two->toi_lower(), two->toi_upper()}))
            << shown;
        ++unseen;
      }
    }
    if (const auto other = moved_as_one(problem)) {
      const oracle::RotatingTruth* its = rotating_truth_of(*other);
      if (its != nullptr) {
        EXPECT_NE(its->outcome(), Outcome::hit) << shown;
        ++alike;
      }
    }
    if (const auto other = restarted(problem, 0.5); other && times.lower > other->at && times.lower < 1e9) {
      const oracle::RotatingTruth* its = rotating_truth_of(other->after);
      if (its != nullptr && its->outcome() == Outcome::hit) {
        // The time that it claims is contact, or nearly, of the whole motion.
        const double t = other->at + its->toi_upper();
        EXPECT_LE(own.distance_at(t).low, other->error + 0x1p-52 * t * top_speed_of(problem)) << shown;
        ++restarts;
      }
    }
  }
  EXPECT_GE(turned, 20);
  EXPECT_GE(longer, 30);
  EXPECT_GE(unseen, 5);
  EXPECT_GE(alike, 3);
  EXPECT_GE(restarts, 3);
}

}  // namespace
}  // namespace graze::law
