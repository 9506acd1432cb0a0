// The families of bodies at rest, of equal distances and of much work: each is what it says, to the bit where
// it says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "corpus/families.hpp"
#include "corpus/families/standing.hpp"
#include "corpus/support_value.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "oracles/truth/linear_truth.hpp"

namespace graze::corpus {
namespace {

constexpr std::uint64_t kSeeds = 48;

template <class F>
void for_each_case(const char* name, F f) {
  const Family& family = *find_family(name);
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) f(level, family.generate(level, seed));
  }
}

// The gap between the bounding boxes of A and B along the axis where they overlap least. Below 0: the depth
// of their overlap.
double gap_of_boxes(const Case& problem) {
  const Bounds a = bounds(problem.a.shape, problem.a.orientation),
               b = bounds(problem.b.shape, problem.b.orientation);
  double gap = -kInfinity<double>;
  for (int i = 0; i < 3; ++i) {
    // B's own coordinate is small: it is added last.
    const double apart = problem.b.position[i] - problem.a.position[i];
    gap = std::max({gap, (b.low[i] - a.high[i]) + apart, (a.low[i] - b.high[i]) - apart});
  }
  return gap;
}

// The gap along the axis where the two are nearest to touching.
double least_gap_of_boxes(const Case& problem) {
  const Bounds a = bounds(problem.a.shape, problem.a.orientation),
               b = bounds(problem.b.shape, problem.b.orientation);
  double gap = kInfinity<double>;
  for (int i = 0; i < 3; ++i) {
    const double apart = problem.b.position[i] - problem.a.position[i];
    for (const double one : {(b.low[i] - a.high[i]) + apart, (a.low[i] - b.high[i]) - apart})
      if (std::abs(one) < std::abs(gap)) gap = one;
  }
  return gap;
}

// Every manner of motion makes contact if the bodies just touch, and a start in contact is one of distance 0. Lengths with
// all bits set round where the scene is turned: then the contact may be lost by as much, seldom.
TEST(AtRest, TouchesExactlyAtHardnessZero) {
  const Family& family = *find_family("at_rest");
  std::size_t starts = 0, later = 0, turned = 0, rounded = 0;
  for (std::uint64_t seed = 0; seed < 16 * kSeeds; ++seed) {
    Case problem = family.generate(0, seed);
    if (!oracle::is_exact_body(problem.a.shape) || !oracle::is_exact_body(problem.b.shape)) continue;
    problem.start_policy = StartPolicy::report;
    const oracle::LinearTruth truth(problem);
    EXPECT_EQ(truth.depth_before(0).high, 0) << problem.id;
    if (truth.outcome() == Outcome::miss) {
      EXPECT_LE(truth.clearance().high, 0x1p-46 * truth.scale().high) << problem.id;
      ++rounded;
    }
    starts += truth.outcome() == Outcome::initially_overlapping;
    later += truth.outcome() == Outcome::hit;
    const Quaternion<double>& q = problem.a.orientation;
    const double n = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    turned += n != 1 && n != 2 && n != 4;
  }
  EXPECT_GE(starts, kSeeds);
  EXPECT_GE(later, kSeeds);
  EXPECT_GE(turned, kSeeds);
  EXPECT_LE(rounded, kSeeds / 8);
}

TEST(AtRest, LosesTheContactByAUnitInTheLastPlace) {
  const Family& family = *find_family("at_rest");
  std::size_t contacts = 0, misses = 0;
  for (std::uint64_t seed = 0; seed < 8 * kSeeds; ++seed) {
    Case problem = family.generate(-1, seed);
    if (!oracle::is_exact_body(problem.a.shape) || !oracle::is_exact_body(problem.b.shape)) continue;
    problem.start_policy = StartPolicy::report;
    const oracle::LinearTruth truth(problem);
    // A few units in the last place of a float of the scene's size.
    EXPECT_LE(truth.clearance().high, 0x1p-19 * truth.scale().high) << problem.id;
    ++(truth.outcome() == Outcome::miss ? misses : contacts);
  }
  EXPECT_GE(misses, kSeeds / 4);
  EXPECT_GE(contacts, kSeeds);
}

TEST(Coaxial, HasAxesAsFarApartAsTheHardnessSays) {
  std::size_t along = 0;
  for_each_case("coaxial", [&](double level, const Case& problem) {
    // A's axis, and B's centre from A's. The rotation of the scene may round them.
    const bool is_on_axis = level >= 17;
    Vec3<double> axis = rotate(problem.a.orientation, Vec3<double>(0, 0, 1));
    const Vec3<double> v = problem.b.displacement - problem.a.displacement;
    if ((v - v.dot(axis) * axis).norm() > 1e-9 * v.norm()) return;  // across the axis
    const Vec3<double> d = problem.b.position - problem.a.position;
    const double off = (d - d.dot(axis) * axis).norm();
    if (off > 10) return;  // passes by
    ++along;
    EXPECT_LE(off, (is_on_axis ? 0 : 6 * std::pow(10, -level)) + 1e-5) << problem.id;
    if (level < 5 && off > 1e-5) {
      EXPECT_GE(off, 3 * std::pow(10, -level)) << problem.id;
    }
  });
  EXPECT_GE(along, 4 * kSeeds);
}

TEST(EqualDistances, HasAboutAsManyCornersAsTheHardnessSays) {
  for_each_case("equal_distances", [&](double level, const Case& problem) {
    const auto corners = [](const Body<double>& body) {
      const auto* hull = std::get_if<Hull<double>>(&body.shape);
      return hull == nullptr ? std::size_t{0} : hull->size();
    };
    const auto most = static_cast<double>(std::max(corners(problem.a), corners(problem.b)));
    EXPECT_GE(most, 0.75 * std::pow(2, level)) << problem.id;
    EXPECT_LE(most, 2.5 * std::pow(2, level) + 2) << problem.id;
  });
}

TEST(EqualDistances, ArePointsOfOneSphereAndPolygonsAreRegular) {
  for (const Vec3<double>& x : sphere_points(256)) EXPECT_NEAR(x.norm(), 1, 4e-16);
  for (const int first : {3, 4, 5}) {
    for (const int doublings : {0, 1, 6}) {
      const std::vector<Point2> corners = regular_polygon(first, doublings);
      const auto count = static_cast<std::size_t>(first << doublings);
      ASSERT_EQ(corners.size(), count);
      const double side = 2 * std::sin(std::acos(-1.0) / static_cast<double>(count));
      for (std::size_t i = 0; i < count; ++i) {
        const Point2 &x = corners[i], &next = corners[(i + 1) % count];
        EXPECT_NEAR(std::hypot(x[0], x[1]), 1, 4e-15);
        EXPECT_NEAR(std::hypot(next[0] - x[0], next[1] - x[1]), side, 4e-15);
      }
    }
  }
}

TEST(ParallelCaps, HaveAsManyVerticesAsTheHardnessSaysAtTwoHeightsButForUnits) {
  for_each_case("parallel_caps", [&](double level, const Case& problem) {
    std::size_t most = 0;
    for (const Body<double>* body : {&problem.a, &problem.b}) {
      const auto& hull = std::get<Hull<double>>(body->shape);
      most = std::max(most, hull.size());
      // Each of the caps is level to a few units in the last place of a float.
      const Bounds box = bounds(body->shape);
      const double middle = (box.low[2] + box.high[2]) / 2;
      const double unit = 0x1p-20 * std::max(std::abs(box.low[2]), std::abs(box.high[2]));
      for (const Vec3<double>& x : hull.vertices()) {
        EXPECT_NEAR(x[2], x[2] > middle ? box.high[2] : box.low[2], unit) << problem.id;
      }
    }
    EXPECT_LE(most, std::size_t{1} << static_cast<int>(level)) << problem.id;
    EXPECT_GE(most, std::size_t{1} << (static_cast<int>(level) - 1)) << problem.id;
  });
}

TEST(RodsAndRound, AreAsLongAsTheHardnessSays) {
  for_each_case("rods_and_round", [&](double level, const Case& problem) {
    const double reach = std::max(bounding_radius(problem.a.shape), bounding_radius(problem.b.shape));
    EXPECT_GE(reach, 0.5 * std::pow(10, level) * (1 - 1e-6)) << problem.id;
    EXPECT_LE(reach, 4 * std::pow(10, level)) << problem.id;
  });
}

TEST(SmoothDepths, AreConcentricAndBesideEachOtherWithDiscsAmongThem) {
  std::size_t concentric = 0, discs = 0, total = 0;
  for_each_case("smooth_depths", [&](double level, const Case& problem) {
    const Vec3<double> v = problem.b.displacement - problem.a.displacement;
    const Vec3<double> d = problem.b.position - problem.a.position;
    // Their centres coincide at the start. Along the axes they are off as the hardness says. Rotations of the
    // scene round.
    if (v == Vec3<double>::Zero()) {
      ++total;
      concentric += d.norm() <= 8 * (level >= 17 ? 0 : std::pow(10, -level)) + 1e-5;
    }
    for (const Body<double>* body : {&problem.a, &problem.b}) {
      const Bounds box = bounds(body->shape);
      discs += (box.high - box.low).minCoeff() == 0;
    }
  });
  EXPECT_GE(concentric, total / 4);
  EXPECT_LE(concentric, total * 3 / 4);
  EXPECT_GE(discs, kSeeds / 2);
}

TEST(LevelTiles, AreLevelAsTheHardnessSays) {
  for_each_case("level_tiles", [&](double level, const Case& problem) {
    const double height = level >= 17 ? 0 : std::pow(10, -level);
    // Lying and tilted bodies have bounding boxes that are rounded.
    EXPECT_NEAR(std::abs(least_gap_of_boxes(problem)), height, 1e-14 + 1e-6 * height) << problem.id;
  });
}

TEST(Wheels, TurnAsFastAsTheHardnessSaysAtTheFloor) {
  std::size_t near = 0, total = 0;
  for_each_case("wheels", [&](double level, const Case& problem) {
    // The time may be stretched.
    const double fastest =
        std::max(problem.spin_a.rotation.norm(), problem.spin_b.rotation.norm()) * problem.t_max;
    EXPECT_GE(fastest, 0.25 * std::pow(2, level)) << problem.id;
    EXPECT_LE(fastest, 3 * std::pow(2, level)) << problem.id;
    ++total;
    near += std::abs(least_gap_of_boxes(problem)) < 2e-6;
  });
  EXPECT_GE(near, total * 2 / 5);
}

TEST(AboveAFloor, StartsApartByWhatTheHardnessSays) {
  for_each_case("above_a_floor", [&](double level, const Case& problem) {
    const double gap = gap_of_boxes(problem);
    EXPECT_GE(gap, 0.49 * std::pow(10, -level)) << problem.id;
    EXPECT_LE(gap, 2.01 * std::pow(10, -level)) << problem.id;
  });
}

TEST(FlatPlatesTurning, HasAPlateWithoutThickness) {
  for_each_case("flat_plates_turning", [&](double level, const Case& problem) {
    const auto thickness = [](const Body<double>& body) {
      const Bounds box = bounds(body.shape);
      return box.high[2] - box.low[2];
    };
    EXPECT_EQ(std::min(thickness(problem.a), thickness(problem.b)), 0) << problem.id;
    const double small = std::min(bounding_radius(problem.a.shape), bounding_radius(problem.b.shape));
    EXPECT_LE(small, level >= 17 ? 0 : 2 * std::pow(10, -level)) << problem.id;
  });
}

}  // namespace
}  // namespace graze::corpus
