// Certification: tallies by method and family, rows that are kept and broken, and a stop in between.
#include "certify/certification.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "certify/report.hpp"
#include "tests/shared/rotating_cases.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using test::dipping_bar;
using test::turning_bar;
using test::turning_bar_above;

const engine::Method& rotating(const char* name) { return *engine::find_method(Kind::rotating, name); }

Suite bars() {
  return {
      .kind = Kind::rotating, .family = "bars", .cases = {turning_bar(), turning_bar_above(), dipping_bar()}};
}

TEST(Certification, TalliesByMethodAndFamilyAndNamesTheFirstBreach) {
  engine::Guarantee strict = *rotating("bilateral").guarantee;
  strict.kappa_polytope = 0;
  engine::Method held = rotating("bilateral");
  held.guarantee = &strict;
  for (const unsigned threads : {1U, 3U}) {
    const Settings settings{.methods = {&rotating("bilateral"), &rotating("certified")}, .threads = threads};
    const Certification kept = certify({bars()}, settings);
    ASSERT_EQ(kept.tallies.size(), 2U);
    EXPECT_EQ(kept.tallies[0].cases, 3U);
    EXPECT_EQ(kept.tallies[1].accepted, 3U);
    EXPECT_EQ(kept.questions, 3U);
    EXPECT_EQ(kept.answers, 12U);  // with and without the proof
    EXPECT_TRUE(kept.breaches.empty()) << kept.breaches.front();
    EXPECT_TRUE(kept.has_kept(rotating("bilateral")));
    EXPECT_GT(kept.tallies[0].width.value, 0);
    EXPECT_LT(kept.tallies[0].over_limit.value, 1);
    EXPECT_NE(tally_table(Kind::rotating, kept).find("bars"), std::string::npos);
    EXPECT_EQ(verdict_line(kept, 0.2).find(
                  "Every method keeps its guarantee: 12 answers to 3 cases of 1 suite judged "
                  "in less than a second, 0 faults, "),
              0U)
        << verdict_line(kept, 0.2);
    engine::Guarantee nothing = *held.guarantee;
    nothing.is_open = true;
    engine::Method unheld = held;
    unheld.guarantee = &nothing;
    const Certification unpromised = certify({bars()}, {.methods = {&unheld}, .threads = threads});
    EXPECT_EQ(verdict_line(unpromised, 1).find("Nothing is promised, and no answer fails"), 0U);

    const Settings strictly{.methods = {&held, &rotating("certified")}, .threads = threads};
    const Certification broken = certify({bars()}, strictly);
    ASSERT_FALSE(broken.breaches.empty());
    EXPECT_TRUE(broken.breaches[0].starts_with("rotating bilateral/double standard, bars: "))
        << broken.breaches[0];
    EXPECT_FALSE(broken.has_kept(held));
    EXPECT_TRUE(broken.has_kept(rotating("certified")));
    EXPECT_EQ(broken.convicted.size(), 2U);  // the hits
    EXPECT_NE(guarantee_table(Kind::rotating, broken, strictly).find("NO"), std::string::npos);
    EXPECT_EQ(verdict_line(broken, 1).find("A method breaks its guarantee"), 0U);
  }
}

// The judgements before a stop are kept, and the cases that were not judged are named.
TEST(Certification, AStopKeepsWhatIsFinished) {
  Suite later = bars();
  later.family = "later";
  std::atomic<int> judged = 0;
  engine::Method counted = rotating("bilateral");
  const Settings settings{.methods = {&counted}, .stop = [&] { return ++judged > 8; }};
  const Certification stopped = certify({bars(), later}, settings);
  EXPECT_EQ(stopped.tallies.at(0).cases, 3U);
  EXPECT_EQ(stopped.unfinished, std::vector<std::string>{"later"});
  EXPECT_LT(stopped.tallies.at(1).cases, 3U);
  EXPECT_EQ(verdict_line(stopped, 1).find("Stopped"), 0U);
}

// The first fault ends a run that is to fail fast: the suite after it is not judged.
TEST(Certification, FailsFastIfAskedTo) {
  engine::Guarantee strict = *rotating("bilateral").guarantee;
  strict.kappa_polytope = 0;
  engine::Method held = rotating("bilateral");
  held.guarantee = &strict;
  Suite later = bars();
  later.family = "later";
  for (const bool fail_fast : {false, true}) {
    const Settings settings{.methods = {&held}, .fail_fast = fail_fast};
    const Certification broken = certify({bars(), later}, settings);
    EXPECT_FALSE(broken.breaches.empty());
    EXPECT_EQ(broken.tallies.at(1).cases, fail_fast ? 0U : 3U);
    EXPECT_EQ(broken.unfinished.empty(), !fail_fast);
  }
}

// A screen: 40 lines of 110 columns at most, whatever is judged.
TEST(Report, FitsOnAScreen) {
  std::vector<const engine::Method*> all;
  for (const engine::Method& method : engine::methods()) all.push_back(&method);
  const Settings settings{.methods = all};
  const corpus::Family* family = corpus::find_family("random");
  ASSERT_NE(family, nullptr);
  std::vector<Suite> suites = {drawn_suite(*family, family->levels, 16, 1)};
  suites.push_back(queried_suite(suites[0], 2));
  suites.push_back(bars());
  const Certification certification = certify(suites, settings);
  EXPECT_TRUE(certification.breaches.empty()) << certification.breaches.front();
  const std::string screen = summary_table(certification, settings);
  EXPECT_LE(std::count(screen.begin(), screen.end(), '\n'), 36);
  for (std::size_t at = 0, end; at < screen.size(); at = end + 1) {
    end = screen.find('\n', at);
    EXPECT_LE(end - at, 110U) << screen.substr(at, end - at);
  }
  const std::string line = verdict_line(certification, 61);
  EXPECT_LE(line.size(), 111U) << line;
  // Every method has its line, both scalars in one.
  for (const engine::Method* method : all)
    EXPECT_NE(screen.find(method->name), std::string::npos) << method->name;
  EXPECT_NE(full_tables(certification, settings).find("Rotating casts"), std::string::npos);
}

}  // namespace
}  // namespace graze::tool
