// Every law of rotating casts, for every rotating method, over drawn cases, the families, and the corpus.
//
// The oracle's answer to a case costs more than all laws about it, so a case goes through every law before
// the next is drawn. The seed is fixed, and printed with a failure. RC_PARAMS="seed=... max_success=..." in
// the environment draws others.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "corpus/families.hpp"
#include "corpus/families/turning.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/turning.hpp"
#include "properties/generate/generators.hpp"
#include "properties/generate/large_hull.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/law.hpp"
#include "properties/laws/rotating/question.hpp"
#include "tests/properties/generate/drawn_run.hpp"

namespace graze::law {
namespace {

const bool kGiven = takes_given_parameters("seed=20261121");
constexpr int kDrawnCases = 120;
// For the easier half of the levels, all laws together take a tenth of a second a case. On the hardest levels
// the oracle and conservative advancement take many seconds, so these are left to campaigns.
constexpr int kFamilySeeds = 1;

// All laws over many cases: what was drawn is counted, what broke is kept.
class RotatingRun {
 public:
  explicit RotatingRun(const std::string& source) {
    for (const Law& law : laws(engine::Kind::rotating)) runs_.emplace_back(law, source);
  }

  // True if every law holds or does not apply, for every method.
  bool holds_for(const corpus::Case& problem, std::string_view family = {}) {
    for (LawRun& run : runs_) {
      if (run.holds_for(problem, family)) continue;
      broken_ = &run;
      return false;
    }
    return true;
  }

  // The saved case, made small by the law and the method that it broke, and instructions for it.
  [[nodiscard]] std::string report(const std::string& seed, bool make_small = true) {
    if (make_small) broken_->minimise(2000);
    return broken_->report(seed);
  }

  // Empty, or which law never applied, or which outcome it never saw.
  [[nodiscard]] std::string shortfall() const {
    for (const LawRun& run : runs_) {
      if (std::string lacking = run.shortfall(); !lacking.empty()) return lacking;
    }
    return "";
  }

  void print() const {
    for (const LawRun& run : runs_) run.print();
  }

 private:
  std::vector<LawRun> runs_;
  LawRun* broken_ = nullptr;  // the last
};

TEST(RotatingLaws, HoldForDrawnCases) {
  RotatingRun run("drawn");
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  if (!kGiven) parameters.maxSuccess = kDrawnCases;
  const rc::Gen<Drawn> generator = rotating_cases();
  const rc::detail::TestResult result = rc::detail::checkTestable(
      [&] {
        const Drawn drawn = *generator;
        RC_ASSERT(run.holds_for(drawn.problem));
      },
      rc::detail::TestMetadata{"rotating laws", "every law holds"}, parameters);
  run.print();
  if (!result.is<rc::detail::SuccessResult>()) {
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    FAIL() << run.report(std::string("RC_PARAMS=\"") + std::getenv("RC_PARAMS") + "\"") << text.str();
  }
  EXPECT_EQ(run.shortfall(), "");
}

TEST(RotatingLaws, HoldForTheFamilies) {
  RotatingRun run("families");
  for (const corpus::Family& family : corpus::rotating_families()) {
    for (const double hardness : family.levels.first((family.levels.size() + 1) / 2)) {
      for (int seed = 0; seed < kFamilySeeds; ++seed) {
        const auto number = static_cast<std::uint64_t>(seed);
        if (run.holds_for(family.generate(hardness, number), family.name)) continue;
        FAIL() << run.report(seed_of(family.name, hardness, number));
      }
    }
  }
  run.print();
}

TEST(RotatingLaws, HoldForLargeHulls) {
  RotatingRun run("large hulls");
  corpus::Random random(20261128);
  for (int i = 0; i < 10; ++i) {
    if (run.holds_for(draw_turning_large_hull(random))) continue;
    FAIL() << run.report("large hulls " + std::to_string(i));
  }
  run.print();
}

TEST(RotatingLaws, HoldForTheCuratedCorpus) {
  const corpus::ReadResult curated = corpus::read_directory(GRAZE_SOURCE_DIR "/corpus/cases");
  ASSERT_TRUE(curated.ok()) << curated.errors.front().text();
  RotatingRun run("curated");
  int turning = 0;
  for (const corpus::Case& problem : curated.cases) {
    if (!engine::turns(problem)) continue;
    ++turning;
    EXPECT_TRUE(run.holds_for(problem)) << run.report(problem.id + " of the corpus", false);
  }
  run.print();
  EXPECT_GE(turning, 24);
}

TEST(DrawRotating, ReachesEveryOutcomeAndEveryWayToTurn) {
  corpus::Random random(5);
  std::map<Outcome, int> outcomes;
  std::map<Effects, int> effects;
  int both = 0, pivots = 0, many_turns = 0, undecided = 0;
  constexpr int kCases = 200;
  const engine::Method& plan = *engine::find_method(engine::Kind::rotating, "plan/double");
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
    const engine::Answer answer = plan.ask(problem, {});
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

// Else a bound of the motion that is too low would be hidden by how loose the bounds are.
TEST(DrawRotating, HasContactsAsFastAsAnyPointOfTheBody) {
  corpus::Random random(7);
  const engine::Method& plan = *engine::find_method(engine::Kind::rotating, "plan/double");
  int near = 0;
  for (int i = 0; i < 300; ++i) {
    const corpus::Case problem = draw_rotating(random, i % 100);
    if (!is_rotating_question(problem)) continue;
    const engine::Answer answer = plan.ask(problem, {.request = Request::everything});
    if (answer.outcome != Outcome::hit) continue;
    const auto is_near = [&](const Body<double>& body, const corpus::Spin& spin,
                             const Vec3<double>& witness) {
      const auto corners = exact_vertices(body.shape, 64);
      if (!corners || spin.rotation.isZero(0)) return false;
      const Vec3<double> pivot = corpus::rotate(body.orientation, spin.pivot);
      double most = 0;
      for (const Vec3<double>& corner : *corners) {
        most = std::max(most, spin.rotation.cross(corpus::rotate(body.orientation, corner) - pivot).norm());
      }
      const Vec3<double> center = body.position + answer.toi_lower * body.displacement + pivot;
      return std::abs(answer.normal.dot(spin.rotation.cross(witness - center))) > 0.99 * most;
    };
    near += is_near(problem.a, problem.spin_a, answer.point_a) ||
            is_near(problem.b, problem.spin_b, answer.point_b);
  }
  EXPECT_GE(near, 10);
}

TEST(DrawRotating, IsAFunctionOfItsBits) {
  corpus::Random one(99), two(99);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(same_input(draw_rotating(one, i), draw_rotating(two, i)));
}

TEST(Simpler, ATurnShrinksAwayOrToSmallIntegers) {
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
TEST(CaseEdit, TrueRotatingAnswersAreRelatedAsTheLawsSay) {
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

// The same for the edits of rotations alone. Every case goes through one edit in turn, for the oracle's time.
TEST(TurningEdit, TrueAnswersAreRelatedAsTheLawsSay) {
  corpus::Random random(19);
  std::map<std::string, int> seen;
  const auto truth_of = [](const corpus::Case& problem) { return rotating_truth_of(problem); };
  const auto meets = [](const oracle::RotatingTruth& one, const oracle::RotatingTruth& other) {
    return overlap({one.toi_lower(), one.toi_upper()}, {other.toi_lower(), other.toi_upper()});
  };
  for (int i = 0; i < 160; ++i) {
    const corpus::Case problem = draw_rotating(random, i % 40);
    if (!is_rotating_question(problem)) continue;
    const std::string shown = corpus::write_case(problem);
    const auto same = [&](const char* name, const corpus::Case& one, const corpus::Case& other) {
      const oracle::RotatingTruth* mine = truth_of(one);
      const oracle::RotatingTruth* its = mine == nullptr ? nullptr : truth_of(other);
      if (its == nullptr) return;
      EXPECT_TRUE(meets(*mine, *its)) << name << ": " << shown;
      ++seen[name];
    };
    switch (i % 4) {
      case 0:
        if (const auto slid = with_slid_pivot(problem, true, hash_of(problem)))
          same("slid", slid->before, slid->after);
        break;
      case 1:
        if (const auto idle = with_idle_pivots(problem, hash_of(problem))) same("idle", problem, *idle);
        if (const auto drift = drifting(problem, hash_of(problem))) same("drift", problem, drift->problem);
        break;
      case 2:
        if (const auto turn = whole_turns(problem, true)) same("whole turn", turn->once, turn->often);
        break;
      default: {
        const std::optional<WayBack> way = way_back(problem);
        const oracle::RotatingTruth* there = way ? truth_of(problem) : nullptr;
        const oracle::RotatingTruth* back = there == nullptr ? nullptr : truth_of(way->problem);
        if (back == nullptr || back->outcome() == Outcome::not_converged) break;
        if (there->outcome() == Outcome::miss && there->clearance().low > way->error) {
          EXPECT_EQ(back->outcome(), Outcome::miss) << shown;
          ++seen["missed both ways"];
        } else if (there->contact_proved() && there->depth().low > way->error) {
          EXPECT_NE(back->outcome(), Outcome::miss) << shown;
          // The way there is in contact at the time of the way back's first contact.
          const double t = problem.t_max - back->toi_upper();
          EXPECT_LE(there->distance_at(t).low, way->error + 0x1p-50 * problem.t_max * top_speed_of(problem))
              << shown;
          ++seen["met both ways"];
        }
        break;
      }
    }
  }
  for (const char* name : {"slid", "idle", "drift", "whole turn", "missed both ways", "met both ways"})
    EXPECT_GE(seen[name], 5) << name;
}

}  // namespace
}  // namespace graze::law
