// The families of bodies far from their origin of measurement. Each level has its stated distance, and outcomes
// in fair shares. Near rounding only the bracket oracle can tell the outcomes apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "corpus/families.hpp"
#include "corpus/support_value.hpp"
#include "oracles/truth/rotating_truth.hpp"

namespace graze::corpus {
namespace {

constexpr std::uint64_t kSeeds = 16;

template <class F>
void for_each_case(const char* name, F f) {
  const Family& family = *find_family(name);
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) f(level, family.generate(level, seed));
  }
}

double largest(const Vec3<double>& x) { return x.cwiseAbs().maxCoeff(); }

// How far out the nearest point of the shape's box is, along the axis where it is farthest.
double how_far_out(const Shape<double>& shape) {
  const Bounds box = bounds(shape);
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max({most, box.low[i], -box.high[i]});
  return most;
}

double extent(const Body<double>& body) {
  const Bounds box = bounds(body.shape, body.orientation);
  return largest(box.high - box.low);
}

// Hits and misses at every level, starts in contact in every family, and next to none that a width of 1e-13
// of scale leaves open.
TEST(FarFamilies, HaveFairSharesOfHitsMissesAndStartsInContactAllDecided) {
  for (const char* name : {"far_own_frame_turning", "long_arms", "swung_balls"}) {
    const Family& family = *find_family(name);
    std::map<Outcome, std::size_t> all;
    for (const double level : family.levels) {
      std::map<Outcome, std::size_t> outcomes;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Outcome outcome = oracle::RotatingTruth(family.generate(level, seed)).outcome();
        ++outcomes[outcome];
        ++all[outcome];
      }
      EXPECT_GE(outcomes[Outcome::hit], 1u) << name << ' ' << level;
      EXPECT_GE(outcomes[Outcome::miss], 1u) << name << ' ' << level;
    }
    const std::size_t total = family.levels.size() * kSeeds;
    EXPECT_GE(all[Outcome::hit], total / 6) << name;
    EXPECT_GE(all[Outcome::miss], total / 4) << name;
    EXPECT_GE(all[Outcome::initially_overlapping], total / 40) << name;
    EXPECT_LE(all[Outcome::not_converged], total / 40) << name;
  }
}

TEST(FarOwnFrame, IsAsFarOutAsTheHardnessSaysAndNearTheOrigin) {
  const auto check = [](const Case& problem, double size) {
    const double a = how_far_out(problem.a.shape), b = how_far_out(problem.b.shape);
    EXPECT_GE(std::max(a, b), 0.5 * size - 16) << problem.id;
    EXPECT_LE(std::max(a, b), size + 16) << problem.id;
    // Rounded at the size of the frame, the shapes and places are what they were: at most 8 within a box of
    // 8, 40 before the end of the path.
    EXPECT_LE(extent(problem.a) + extent(problem.b), 64 + 0x1p-40 * size) << problem.id;
  };
  for_each_case("far_own_frame",
                [&](double level, const Case& problem) { check(problem, std::pow(10, level)); });
  for_each_case("far_own_frame_turning",
                [&](double level, const Case& problem) { check(problem, std::exp2(level)); });
}

TEST(LongArms, AreAsLongAsTheHardnessSaysAndTurnAlike) {
  for_each_case("long_arms", [](double level, const Case& problem) {
    const double arm = std::exp2(level);
    const double longest = std::max(problem.spin_a.pivot.norm(), problem.spin_b.pivot.norm());
    // Rounded down to integers, or to a quarter along the rotation vector. A body's own position is within
    // 16.
    EXPECT_GE(longest, arm / 16 - 16) << problem.id;
    EXPECT_LE(longest, 8 * arm + 32) << problem.id;
    const double difference = (problem.spin_b.rotation - problem.spin_a.rotation).norm() * problem.t_max;
    EXPECT_LE(difference, 2 * std::max(0x1p-47, 0x1p-1 / arm)) << problem.id;
    EXPECT_GE(problem.spin_a.rotation.norm() * problem.t_max, 0.2) << problem.id;
  });
}

TEST(SwungBalls, AreBallsAndAsFarFromTheirPivotsAsTheHardnessSays) {
  for_each_case("swung_balls", [](double level, const Case& problem) {
    const auto is_swung = [&](const Body<double>& body, const Spin& spin) {
      const Bounds box = bounds(body.shape);
      const Vec3<double> size = box.high - box.low;
      const double radius = size[0] / 2;
      if (radius == 0 || largest(size - Vec3<double>::Constant(size[0])) > 1e-12 * size[0]) return false;
      const double away = (spin.pivot - (box.high + box.low) / 2).norm();
      return away >= radius * std::exp2(level) && away <= 2 * radius * std::exp2(level) + 2;
    };
    EXPECT_TRUE(is_swung(problem.a, problem.spin_a) || is_swung(problem.b, problem.spin_b)) << problem.id;
  });
}

}  // namespace
}  // namespace graze::corpus
