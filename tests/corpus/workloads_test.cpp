// The workloads: the same bits everywhere, steps of one run in a row, and questions of every outcome.
#include "corpus/workloads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <graze/rotating_cast.hpp>
#include <map>
#include <set>

#include "corpus/families/draw.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/random.hpp"
#include "engines/convert.hpp"

namespace graze::corpus {
namespace {

// Made by g++ 12 on x86-64. Any other compiler, flag or machine must give the same.
TEST(Workloads, AreTheSameBitsEverywhere) {
  const std::map<std::string_view, std::uint64_t> golden = {
      {"falling", 0x467c995d6b0e1fd8u},   {"sliding_on_tiles", 0x81d0e7c906c15d75u},
      {"rolling", 0xeac680fec1961bffu},   {"stacking", 0x38847919cf555a37u},
      {"hinges", 0x3e850047ed13beabu},    {"spinning_plates", 0x77fb41f62535c137u},
      {"robot_arm", 0x8fa35c918e3ab51cu}, {"gears", 0xd021211f83622edfu},
  };
  EXPECT_EQ(golden.size(), workloads().size());
  for (const Family& workload : workloads()) {
    std::string text;
    for (const double place : workload.levels) {
      for (std::uint64_t seed = 0; seed < 24; ++seed)
        text += write_case(workload.generate(place, seed)) + "\n";
    }
    ASSERT_TRUE(golden.contains(workload.name)) << workload.name;
    EXPECT_EQ(fnv1a(text), golden.at(workload.name)) << workload.name;
  }
}

TEST(Workloads, AreFoundByNameAndReadBackAsTheyAre) {
  for (const Family& workload : workloads()) {
    EXPECT_EQ(find_family(workload.name), &workload);
    EXPECT_TRUE(workload.rotating);
    std::set<std::string> bodies;
    for (std::uint64_t seed = 0; seed < 64; ++seed) {
      const Case problem = workload.generate(0, 5 * seed);
      const std::string text = write_case(problem);
      const ReadResult read = read_text(text, problem.id, false);
      ASSERT_TRUE(read.ok()) << read.errors[0].text();
      EXPECT_TRUE(same_case(read.cases[0], problem)) << problem.id;
      bodies.insert(text.substr(text.find("\"a\"")));
    }
    EXPECT_GE(bodies.size(), 60u) << workload.name;
  }
}

// A body is asked about at every step in which it is near another one: later questions start where earlier ones ended.
TEST(Workloads, HaveStepsOfOneRunInARow) {
  std::size_t followed = 0;
  const Family& falling = *find_family("falling");
  for (std::uint64_t seed = 0; seed < 4 * kQuestionsOfRun; ++seed) {
    const Case before = falling.generate(0, seed);
    const double seconds = before.t_max == 1 ? 1 : before.t_max;
    const Vec3<double> there = before.b.position + seconds * before.b.displacement;
    const std::uint64_t end = (seed / kQuestionsOfRun + 1) * kQuestionsOfRun;
    for (std::uint64_t next = seed + 1; next < std::min(end, seed + 16); ++next) {
      // The floor lifts it.
      const Vec3<double> off = falling.generate(0, next).b.position - there;
      if (std::abs(off[0]) >= 1e-6 || std::abs(off[1]) >= 1e-6) continue;
      ++followed;
      break;
    }
  }
  EXPECT_GE(followed, kQuestionsOfRun);
}

TEST(Workloads, AreAtBothPlacesInFloatsAndDoubles) {
  for (const Family& workload : workloads()) {
    for (const double place : workload.levels) {
      std::size_t floats = 0;
      constexpr std::uint64_t kRuns = 24;
      for (std::uint64_t run = 0; run < kRuns; ++run) {
        const Case problem = workload.generate(place, run * kQuestionsOfRun + 3);
        for (const Body<double>* body : {&problem.a, &problem.b}) {
          EXPECT_NEAR(body->position.norm(), place > 0 ? 1000 : 0, 20) << problem.id;
        }
        bool is_float = true;
        const auto look = [&](const Vec3<double>& x) {
          for (int i = 0; i < 3; ++i) is_float = is_float && round_to_float(x[i]) == x[i];
        };
        for (const Body<double>* body : {&problem.a, &problem.b}) {
          look(body->position);
          look(body->displacement);
        }
        look(problem.spin_a.rotation);
        look(problem.spin_b.rotation);
        floats += is_float;
      }
      EXPECT_GE(floats, kRuns / 6) << workload.name;
      EXPECT_LE(floats, kRuns * 5 / 6) << workload.name;
    }
  }
}

// The mix is what is tested here, not the answers: bodies that meet, that pass and that touch.
TEST(Workloads, MixOutcomes) {
  for (const Family& workload : workloads()) {
    std::map<Outcome, std::size_t> outcomes;
    constexpr std::uint64_t kCases = 400;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const Case problem = workload.generate(0, 37 * i);
      const auto a = engine::round_to<double>(problem.a, problem.spin_a);
      const auto b = engine::round_to<double>(problem.b, problem.spin_b);
      ++outcomes[cast(a, b, RotatingOptions<double>{.t_max = problem.t_max}).outcome];
    }
    EXPECT_GE(outcomes[Outcome::hit], kCases / 200) << workload.name;
    EXPECT_GE(outcomes[Outcome::miss], kCases / 16) << workload.name;
    EXPECT_LE(outcomes[Outcome::initially_overlapping], kCases * 3 / 4) << workload.name;
    EXPECT_EQ(outcomes[Outcome::invalid_input], 0u) << workload.name;
  }
}

}  // namespace
}  // namespace graze::corpus
