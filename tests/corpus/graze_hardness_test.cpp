// The hardness of the families that graze, and of those that are thin, nearly parallel or nearly equal: the
// exact quantity that it is tied to, measured on the cases themselves.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "corpus/families.hpp"
#include "corpus/families/draw.hpp"
#include "corpus/families/placing.hpp"
#include "corpus/support_value.hpp"
#include "oracles/truth/case_truth.hpp"

namespace graze::corpus {
namespace {

constexpr std::uint64_t kSeeds = 32;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// The median of the measured quantity falls from level to level by about `factor`: between a quarter of it
// and four times as much, from 32 cases. Over all levels it falls by factor^levels to within `overall`, a
// factor.
void expect_falls(const char* name, double factor, double overall,
                  const std::function<double(const Case&)>& measure) {
  const Family& family = *find_family(name);
  double first = 0, last = 0;
  for (const double level : family.levels) {
    std::vector<double> values;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
      values.push_back(measure(family.generate(level, seed)));
    const double now = median(values);
    if (level == family.levels.front()) {
      first = now;
    } else {
      EXPECT_LT(now, last) << name << " " << level;
      EXPECT_GE(last / now, factor / 4) << name << " " << level;
      EXPECT_LE(last / now, factor * 4) << name << " " << level;
    }
    last = now;
  }
  const double expected = std::pow(factor, family.levels.back() - family.levels.front());
  EXPECT_GE(first / last, expected / overall) << name;
  EXPECT_LE(first / last, expected * overall) << name;
}

class GrazeFamily : public testing::TestWithParam<const char*> {};

// Full doubles may be turned and rounded: 16 u times coordinates of up to 64. Floats are 2^-24 off 10^-k.
// Below a top there may be nothing, where C is flat or thin: that is a miss by less than the hardness.
TEST_P(GrazeFamily, MissesByTheHardnessAndIsMetNoDeeperAndBothAtEveryLevel) {
  const Family& family = *find_family(GetParam());
  std::size_t thin = 0;
  for (const double level : family.levels) {
    const double wanted = std::pow(10, -level), rounding = wanted * 0x1p-23 + 16 * 64 * 0x1p-53;
    std::size_t hits = 0, misses = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      const oracle::CaseTruth truth(problem);
      if (truth.outcome() == Outcome::hit) {
        ++hits;
        EXPECT_LE(truth.depth().low, wanted + rounding) << problem.id;
      } else {
        // Every bit is decided, so no verdict may be undecided.
        ASSERT_EQ(truth.outcome(), Outcome::miss) << problem.id;
        const double clearance = truth.clearance().high;
        EXPECT_LE(clearance, wanted + rounding) << problem.id;
        misses += clearance >= wanted - rounding;
        thin += clearance < wanted - rounding;
      }
    }
    EXPECT_GE(hits, kSeeds / 6) << level;
    EXPECT_GE(misses, kSeeds / 6) << level;
  }
  EXPECT_LE(thin, family.levels.size() * kSeeds / 25);
}

TEST_P(GrazeFamily, ClearanceAndDepthOverScaleFallTenfold) {
  expect_falls(GetParam(), 10, 4, [](const Case& problem) {
    const oracle::CaseTruth truth(problem);
    const double margin = truth.outcome() == Outcome::miss ? truth.clearance().high : truth.depth().high;
    return margin / truth.scale().high;
  });
}

INSTANTIATE_TEST_SUITE_P(All, GrazeFamily,
                         testing::Values("grazing_vertex", "grazing_edge", "grazing_face", "smooth_graze"));

// A face of C is passed at a height that no motion sideways undercuts: the depth is exact as well.
TEST(GrazingFace, IsMetToExactlyItsDepth) {
  const Family& family = *find_family("grazing_face");
  std::size_t exact = 0, hits = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Case problem = family.generate(10, seed);
    const oracle::CaseTruth truth(problem);
    if (truth.outcome() != Outcome::hit) continue;
    ++hits;
    exact += truth.depth().low >= 1e-10 * (1 - 0x1p-22) - 16 * 64 * 0x1p-53;
  }
  EXPECT_GE(exact, hits * 9 / 10);
}

// The least extent of the three, the middle one and the largest, of a shape in its own frame.
Vec3<double> extents(const Shape<double>& shape) {
  const Bounds box = bounds(shape);
  Vec3<double> size = box.high - box.low;
  std::sort(size.data(), size.data() + 3);
  return size;
}

TEST(Needles, AreAsThinAsTheHardnessSays) {
  expect_falls("needles", 10, 3, [](const Case& problem) {
    const Vec3<double> a = extents(problem.a.shape), b = extents(problem.b.shape);
    return std::max(a[1] / a[2], b[1] / b[2]);
  });
}

TEST(Plates, AreAsThinAsTheHardnessSays) {
  expect_falls("plates", 10, 3, [](const Case& problem) {
    const Vec3<double> a = extents(problem.a.shape), b = extents(problem.b.shape);
    return std::max(a[0] / a[1], b[0] / b[1]);
  });
}

double angle_to_axis(const Vec3<double>& n, int axis) {
  const double across = std::hypot(n[(axis + 1) % 3], n[(axis + 2) % 3]);
  return std::atan2(across, std::abs(n[axis]));
}

// Both in one orientation: the tilt of the hull's face to the box's, by the hull's triples of corners.
double tilt_of_hull(const Box<double>& plate, const Shape<double>& hull) {
  int axis = 0;
  plate.half_extents.minCoeff(&axis);
  const std::vector<Vec3<double>> list = corners(hull);
  double least = kInfinity<double>;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i + 1; j < list.size(); ++j) {
      for (std::size_t k = j + 1; k < list.size(); ++k) {
        const Vec3<double> n = (list[j] - list[i]).cross(list[k] - list[i]);
        if (n.norm() != 0) least = std::min(least, angle_to_axis(n, axis));
      }
    }
  }
  return least;
}

TEST(ParallelFaces, AreAsNearlyParallelAsTheHardnessSays) {
  expect_falls("parallel_faces", 10, 2, [](const Case& problem) {
    const auto* a = std::get_if<Box<double>>(&problem.a.shape);
    const auto* b = std::get_if<Box<double>>(&problem.b.shape);
    if (a == nullptr) return tilt_of_hull(*b, problem.a.shape);
    if (b == nullptr) return tilt_of_hull(*a, problem.b.shape);
    // Two boxes, turned one against the other. One orientation is a half turn about an axis, or none.
    const Quaternion<double>& p = problem.a.orientation;
    const Quaternion<double> q = multiply({p.w, -p.x, -p.y, -p.z}, problem.b.orientation);
    return 2 * std::atan2(std::hypot(q.x, q.y), std::hypot(q.w, q.z));
  });
}

// Directions of the edges that are centred at the body's origin, as those that meet are.
std::vector<Vec3<double>> central_edges(const Shape<double>& shape) {
  const std::vector<Vec3<double>> list = corners(shape);
  std::vector<Vec3<double>> edges;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i + 1; j < list.size(); ++j) {
      if (list[i] == -list[j]) edges.push_back(list[i]);
    }
  }
  return edges;
}

TEST(ParallelEdges, AreAsNearlyParallelAsTheHardnessSays) {
  expect_falls("parallel_edges", 10, 2, [](const Case& problem) {
    double least = kInfinity<double>;
    for (const Vec3<double>& p : central_edges(problem.a.shape)) {
      for (const Vec3<double>& q : central_edges(problem.b.shape)) {
        const double sine = p.cross(q).norm() / (p.norm() * q.norm());
        if (sine != 0) least = std::min(least, sine);
      }
    }
    return least;
  });
}

TEST(Perpendicular, TheMotionIsAsNearlyInTheFaceAsTheHardnessSays) {
  std::size_t in_plane = 0;
  expect_falls("perpendicular", 10, 2, [&](const Case& problem) {
    const Vec3<double> v = problem.b.displacement - problem.a.displacement;
    double least = kInfinity<double>;
    for (const Body<double>* body : {&problem.a, &problem.b}) {
      if (!std::holds_alternative<Box<double>>(body->shape)) continue;
      const Quaternion<double>& q = body->orientation;
      const Vec3<double> own = rotate({q.w, -q.x, -q.y, -q.z}, v);
      for (int i = 0; i < 3; ++i) {
        if (own[i] != 0) least = std::min(least, std::abs(own[i]) / v.norm());
      }
    }
    in_plane += least > 0.2;
    return least;
  });
  EXPECT_GT(in_plane, 0u);
}

TEST(NoisyCopy, IsAsNearACopyAsTheHardnessSays) {
  expect_falls("noisy_copy", 10, 1.5, [](const Case& problem) {
    double most = 0;
    for (const Vec3<double>& x : corners(problem.a.shape)) {
      double least = kInfinity<double>;
      for (const Vec3<double>& y : corners(problem.b.shape)) {
        least = std::min(least, (x - y).cwiseAbs().maxCoeff());
      }
      most = std::max(most, least);
    }
    return most;
  });
}

// The least height of three corners over their longest side, and over that side's length.
double thinness(const Shape<double>& shape) {
  const std::vector<Vec3<double>> list = corners(shape);
  double least = kInfinity<double>;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i + 1; j < list.size(); ++j) {
      for (std::size_t k = j + 1; k < list.size(); ++k) {
        const Vec3<double> p = list[j] - list[i], q = list[k] - list[i];
        const double longest = std::max({p.squaredNorm(), q.squaredNorm(), (q - p).squaredNorm()});
        if (longest != 0) least = std::min(least, p.cross(q).norm() / longest);
      }
    }
  }
  return least;
}

TEST(Slivers, AreAsThinAsTheHardnessSays) {
  expect_falls("slivers", 10, 10, [](const Case& problem) {
    return std::min(thinness(problem.a.shape), thinness(problem.b.shape));
  });
}

}  // namespace
}  // namespace graze::corpus
