// The families about shapes and scenes: the exact quantity that each one's hardness is tied to moves with it.
// Medians over the seeds of a level. The oracles answer in exact arithmetic. Quantities read from the numbers
// of a case are exact, or within the rounding that is stated beside them.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "corpus/families.hpp"
#include "corpus/families/draw.hpp"
#include "corpus/support_value.hpp"
#include "oracles/polytope/integer_scene.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "tests/corpus/depth_of.hpp"

namespace graze::corpus {
namespace {

constexpr std::uint64_t kSeeds = 24;

const Family& family_of(const char* name) {
  const Family* family = find_family(name);
  if (family == nullptr) throw std::invalid_argument(name);
  return *family;
}

// The median of a quantity over the seeds of a level. A case without a value does not count. At least a
// quarter of the cases must have a value.
using Quantity = std::function<std::optional<double>(const Case&)>;
double median_of(const Family& family, double level, const Quantity& quantity) {
  std::vector<double> values;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    if (const std::optional<double> value = quantity(family.generate(level, seed))) values.push_back(*value);
  }
  EXPECT_GE(values.size(), kSeeds / 4) << family.name << " at " << level;
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Each level's median lies between wanted(level) / slack and wanted(level) slack, and they move one way.
void expect_medians(const Family& family, const Quantity& quantity,
                    const std::function<double(double)>& wanted, double slack) {
  std::vector<double> medians;
  for (const double level : family.levels) {
    const double median = median_of(family, level, quantity), middle = wanted(level);
    EXPECT_GE(median, middle / slack) << family.name << " at " << level;
    EXPECT_LE(median, middle * slack) << family.name << " at " << level;
    medians.push_back(median);
  }
  const bool rises = medians.back() > medians.front();
  for (std::size_t i = 1; i < medians.size(); ++i) {
    EXPECT_EQ(medians[i] > medians[i - 1], rises) << family.name << " at " << family.levels[i];
    EXPECT_NE(medians[i], medians[i - 1]) << family.name << " at " << family.levels[i];
  }
}

double tenth(double k) { return std::pow(10, -k); }

Vec3<double> extents(const Shape<double>& shape) {
  const Bounds box = bounds(shape);
  return box.high - box.low;
}

double diagonal(const Case& problem) {
  return std::max(extents(problem.a.shape).norm(), extents(problem.b.shape).norm());
}

// The least extent over the largest, for a body that is more than a point.
double aspect(const Shape<double>& shape) {
  const Vec3<double> extent = extents(shape);
  const double most = extent.maxCoeff();
  return most > 0 ? extent.minCoeff() / most : 1;
}

TEST(FlatShapes, AreAsFlatAsTheHardnessSays) {
  const auto flattest = [](const Case& problem) {
    return std::optional(std::min(aspect(problem.a.shape), aspect(problem.b.shape)));
  };
  // Above 16 they are exactly flat. Extents of 2 to 8 over a thickness for one of 5.
  expect_medians(
      family_of("flat_shapes"), flattest, [](double k) { return k > 16 ? 0 : tenth(k); }, 2.6);
}

TEST(FlatShapes, MakeFlatDifferencesAtTheLastLevelAlone) {
  const Family& family = family_of("flat_shapes");
  std::size_t flat = 0, linear = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const int dimension = oracle::LinearTruth(family.generate(17, seed)).dimension();
    flat += dimension == 2;
    linear += dimension <= 1;
    // Two segments, and a point beside anything flat, have no volume either.
    const Case thick = family.generate(16, seed);
    if (std::holds_alternative<Box<double>>(thick.a.shape)) {
      EXPECT_EQ(oracle::LinearTruth(thick).dimension(), 3) << thick.id;
    }
  }
  EXPECT_GE(flat, kSeeds / 6);
  EXPECT_GE(linear, kSeeds / 12);
}

// How many of a shape's vertices are extreme points, and how many there are.
struct Corners {
  std::size_t extreme = 0, all = 0;
};
Corners corners_of(const Hull<double>& hull) {
  Case alone;
  alone.a.shape = hull;
  const oracle::IntegerScene scene(alone);  // B is a point at the origin: C is A
  return {scene.cso->hull().vertices.size(), hull.size()};
}

TEST(RedundantVertices, ListAsManyMoreAsTheHardnessSays) {
  const auto redundancy = [](const Case& problem) {
    double most = 0;
    for (const Body<double>* body : {&problem.a, &problem.b}) {
      const auto* hull = std::get_if<Hull<double>>(&body->shape);
      if (hull == nullptr) continue;
      const Corners corners = corners_of(*hull);
      most = std::max(
          most, static_cast<double>(corners.all - corners.extreme) / static_cast<double>(corners.extreme));
    }
    return std::optional(most);
  };
  // A midpoint in a flat face may count as a corner of the oracle's hull.
  expect_medians(
      family_of("redundant_vertices"), redundancy, [](double k) { return std::exp2(k); }, 1.5);
}

std::vector<Vec3<double>> world_vertices(const Body<double>& body) {
  std::vector<Vec3<double>> list;
  if (const auto* box = std::get_if<Box<double>>(&body.shape)) {
    for (int k = 0; k < 8; ++k) {
      Vec3<double> x = box->half_extents;
      for (int i = 0; i < 3; ++i) x[i] = (k >> i & 1) != 0 ? x[i] : -x[i];
      list.push_back(x);
    }
  } else if (const auto* segment = std::get_if<Segment<double>>(&body.shape)) {
    list = {segment->a, segment->b};
  } else if (const auto* triangle = std::get_if<Triangle<double>>(&body.shape)) {
    list = {triangle->a, triangle->b, triangle->c};
  } else if (const auto* hull = std::get_if<Hull<double>>(&body.shape)) {
    list.assign(hull->vertices().begin(), hull->vertices().end());
  } else {
    list = {Vec3<double>::Zero()};
  }
  for (Vec3<double>& x : list) x = rotate(body.orientation, x) + body.position;
  return list;
}

// Exact: integers, and rotations of the cube.
double tied_directions(const Case& problem) {
  const std::vector<Vec3<double>> a = world_vertices(problem.a), b = world_vertices(problem.b);
  int tied = 0;
  for (int code = 0; code < 27; ++code) {
    if (code == 13) continue;
    const Vec3<double> n(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    std::optional<Vec3<double>> first;
    double most = -kInfinity<double>;
    bool tie = false;
    for (const Vec3<double>& p : a) {
      for (const Vec3<double>& q : b) {
        const Vec3<double> c = p - q;
        const double height = n.dot(c);
        if (height > most) {
          most = height;
          first = c;
          tie = false;
        } else if (height == most && c != *first) {
          tie = true;
        }
      }
    }
    tied += tie;
  }
  return tied / 26.0;
}

TEST(Lattice, TiesMoreSupportsAsItGetsCoarser) {
  const Family& family = family_of("lattice");
  double last = 0;
  for (const double level : family.levels) {
    const double median =
        median_of(family, level, [](const Case& problem) { return std::optional(tied_directions(problem)); });
    EXPECT_GE(median, last) << level;
    last = median;
  }
  const double first = median_of(family, family.levels.front(),
                                 [](const Case& problem) { return std::optional(tied_directions(problem)); });
  EXPECT_GE(last, first + 0.3);
}

TEST(Lattice, HoldsIntegersOfItsReachAlone) {
  const Family& family = family_of("lattice");
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      for (const Body<double>* body : {&problem.a, &problem.b}) {
        for (const Vec3<double>& x : world_vertices(*body)) {
          EXPECT_EQ(x, Vec3<double>(x.array().round())) << problem.id;
        }
        const Bounds box = bounds(body->shape);
        EXPECT_LE(box.high.cwiseMax(-box.low).maxCoeff(), std::exp2(6 - level)) << problem.id;
      }
    }
  }
}

// The offset of starts with one centre within the other body. Cases that start apart have the same offset
// later.
TEST(Contained, AreAsNearlyConcentricAsTheHardnessSays) {
  const auto offset = [](const Case& problem) -> std::optional<double> {
    const double apart = (problem.b.position - problem.a.position).norm();
    return apart < 8 ? std::optional(apart) : std::nullopt;
  };
  // Along one axis to three, so sqrt(3) at the most.
  expect_medians(
      family_of("contained"), offset, [](double k) { return k > 16 ? 0 : 4 * tenth(k); }, 1.8);
}

// The line of motion passes C's centre at that distance, whether at t = 0 or later. Rounded positions are off
// by 8 u of the 64 that a path is long.
TEST(Contained, MeetAsNearlyConcentricAsTheHardnessSays) {
  const Family& family = family_of("contained");
  for (const double level : family.levels) {
    const double size = level > 16 ? 0 : 4 * tenth(level);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      const Vec3<double> x = problem.b.position - problem.a.position,
                         v = problem.b.displacement - problem.a.displacement;
      const double beside = v.isZero(0) ? x.norm() : x.cross(v).norm() / v.norm();
      // For a float, 32 units of 2^-24.
      EXPECT_LE(beside, std::sqrt(3.0) * size * (1 + 0x1p-20) + 8 * 64 * 0x1p-24) << problem.id;
    }
  }
}

// The least |n.v| / |v| of the coordinate axes that support C at the contact, by the exact oracle.
std::optional<double> tilt(const Case& problem) {
  Case reported = problem;
  reported.start_policy = StartPolicy::report;
  const oracle::LinearTruth truth(reported);
  EXPECT_EQ(truth.outcome(), Outcome::initially_overlapping) << problem.id;
  const Vec3<double> v = problem.b.displacement - problem.a.displacement;
  std::optional<double> least;
  for (int i = 0; i < 3; ++i) {
    for (const double side : {-1.0, 1.0}) {
      Vec3<double> n = Vec3<double>::Zero();
      n[i] = side;
      if (truth.normal_error(n).high != 0) continue;
      const double here = std::abs(v[i]) / v.cwiseAbs().maxCoeff();
      least = least ? std::min(*least, here) : here;
    }
  }
  return least;
}

TEST(Sliding, IsTiltedAsTheHardnessSays) {
  // As a float has it: 2^-24 off. A corner on an edge has a second plane of contact now and then.
  expect_medians(
      family_of("sliding"), tilt, [](double k) { return k > 16 ? 0 : tenth(k); }, 1 + 0x1p-23);
}

TEST(Sliding, LeavesAndApproachesUnderBothPolicies) {
  const Family& family = family_of("sliding");
  std::size_t leaving = 0, approaching = 0, passed = 0, total = 0;
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed, ++total) {
      const Case problem = family.generate(level, seed);
      const oracle::LinearTruth truth(problem);
      (truth.leaves_or_slides() ? leaving : approaching) += 1;
      passed += truth.outcome() == Outcome::miss;
    }
  }
  EXPECT_GE(leaving, total / 3);
  EXPECT_GE(approaching, total / 6);
  EXPECT_GE(passed, total / 6);
}

TEST(Speeds, AreAsSlowOrAsFastAsTheHardnessSays) {
  const Family& family = family_of("speeds");
  double last = -1;
  for (const double level : family.levels) {
    const double median = median_of(family, level, [](const Case& problem) -> std::optional<double> {
      const Vec3<double> v = problem.b.displacement - problem.a.displacement;
      // In sizes of 4. Paths are 2 to 10 of them, and one in four is 2^8 faster or slower at the most.
      const double most = v.cwiseAbs().maxCoeff();
      return most > 0 ? std::optional(std::abs(std::log10(most / 16))) : std::nullopt;
    });
    EXPECT_NEAR(median, level, 0.5) << level;
    EXPECT_GT(median, last) << level;
    last = median;
  }
}

TEST(TargetMargin, IsTheDistanceThatTheHardnessSays) {
  const auto margin = [](const Case& problem) {
    return std::optional(problem.target_distance / diagonal(problem));
  };
  // Over a diagonal of about 4 to 14.
  expect_medians(
      family_of("target_margin"), margin, [](double k) { return 0.5 * std::pow(10, k); }, 2);
  const Family& family = family_of("target_margin");
  for (const double level : family.levels) {
    const double wanted = 4 * std::pow(10, level);
    EXPECT_NEAR(family.generate(level, 1).target_distance, wanted, wanted * 0x1p-23);
  }
}

TEST(ScaledScene, IsAsLargeOrAsSmallAsTheHardnessSays) {
  const auto scale = [](const Case& problem) {
    return std::optional(std::exp2(std::abs(std::log2(diagonal(problem) / 8))));
  };
  // A diagonal is 4 to 14.
  expect_medians(
      family_of("scaled_scene"), scale, [](double j) { return std::exp2(j); }, 2);
}

TEST(ScaledScene, MissesByTolerancesInCommonUse) {
  const Family& family = family_of("scaled_scene");
  std::size_t misses = 0;
  for (const double level : {0.0, 10.0, 20.0}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      const oracle::LinearTruth truth(problem);
      if (truth.outcome() != Outcome::miss) continue;
      const double clearance = truth.clearance().high;
      for (const double tolerance : {1e-4, 0x1p-23, 1e-12}) {
        for (const double factor : {0.1, 1.0, 10.0}) {
          // Full doubles are turned and rounded, floats are 2^-24 off.
          misses += std::abs(clearance / (factor * tolerance) - 1) < 1e-3;
        }
      }
    }
  }
  EXPECT_GE(misses, kSeeds / 2);
}

TEST(ManyVertices, AreCornersAllOfThem) {
  const Family& family = family_of("many_vertices");
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const Case problem = family.generate(level, seed);
      const auto *a = std::get_if<Hull<double>>(&problem.a.shape),
                 *b = std::get_if<Hull<double>>(&problem.b.shape);
      const Hull<double>& dense = a == nullptr || (b != nullptr && b->size() > a->size()) ? *b : *a;
      const Corners corners = corners_of(dense);
      EXPECT_EQ(corners.extreme, corners.all) << problem.id;
      EXPECT_EQ(corners.all, std::size_t{1} << static_cast<int>(level)) << problem.id;
    }
  }
}

TEST(PureSpin, IsClearOrDeepByExactlyItsHardnessAndMovesByTurningAlone) {
  const Family& family = family_of("pure_spin");
  for (const double level : {4.0, 12.0, 20.0}) {
    const double wanted = std::exp2(-level);
    std::size_t misses = 0, hits = 0, arms = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      EXPECT_TRUE(problem.a.displacement.isZero(0) && problem.b.displacement.isZero(0)) << problem.id;
      arms += std::max(problem.spin_a.pivot.norm() - bounding_radius(problem.a.shape),
                       problem.spin_b.pivot.norm() - bounding_radius(problem.b.shape)) > 0;
      const oracle::RotatingTruth truth(problem);
      if (truth.outcome() == Outcome::miss) {
        ++misses;
        // Enclosed to 1/16. Full doubles are rotated and rounded, with coordinates up to 256.
        const oracle::Enclosure clearance = truth.clearance();
        EXPECT_LE(clearance.low, wanted + 0x1p-42) << problem.id;
        EXPECT_GE(clearance.high, wanted - 0x1p-42) << problem.id;
      } else if (truth.outcome() == Outcome::hit) {
        ++hits;
        EXPECT_LE(truth.depth().low, wanted + 0x1p-42) << problem.id;
      }
    }
    EXPECT_GE(misses, kSeeds / 4) << level;
    EXPECT_GE(hits, kSeeds / 8) << level;
    EXPECT_GE(arms, kSeeds / 4) << level;
  }
}

// Families that are older than this page, and had no such test.

TEST(Random, HasHullsOfAsManyVerticesAsTheHardnessSays) {
  const auto vertices = [](const Case& problem) -> std::optional<double> {
    const auto* hull = std::get_if<Hull<double>>(&problem.a.shape);
    if (hull == nullptr) hull = std::get_if<Hull<double>>(&problem.b.shape);
    return hull == nullptr ? std::nullopt : std::optional(static_cast<double>(hull->size()));
  };
  expect_medians(
      family_of("random"), vertices, [](double n) { return n; }, 1);
}

// The gap in units in the last place of 1, where it is not closed: of a double or of a float. A vertex beside
// a vertex may be farther, sideways.
TEST(Touching, IsApartByAsManyUnitsAsTheHardnessSays) {
  const Family& family = family_of("touching");
  for (const double level : family.levels) {
    if (level == 0) continue;  // in touch, all of them: families_test.cpp
    const double median = median_of(family, level, [](const Case& problem) -> std::optional<double> {
      const oracle::Enclosure distance = oracle::LinearTruth(problem).distance();
      if (distance.low == 0) return std::nullopt;
      return distance.low / (distance.low < 0x1p-36 ? 0x1p-52 : 0x1p-23);
    });
    EXPECT_EQ(median, -level);
  }
}

TEST(RandomRotating, IsNestedAsDeepAsTheHardnessSays) {
  const Family& family = family_of("random_rotating");
  for (const double level : family.levels) {
    // A hull of two poses its second part: one more, at most.
    const double median = median_of(family, level, [](const Case& problem) {
      return std::optional<double>(std::max(depth_of(problem.a.shape), depth_of(problem.b.shape)));
    });
    EXPECT_GE(median, level);
    EXPECT_LE(median, level + 1);
  }
}

}  // namespace
}  // namespace graze::corpus
