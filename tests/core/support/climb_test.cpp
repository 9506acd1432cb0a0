// The climb against brute force in rational arithmetic: the answer must be the one vertex that comes last in
// the exact order (n.x, x_0, x_1, x_2), the first given of equal ones.
#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <graze/support/climb.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/shared/large_hulls.hpp"

namespace graze {
namespace {

using boost::multiprecision::cpp_rational;
using test::Draw;
using test::Family;
using test::large_hull;

struct Counted {
  long heights = 0, exact_comparisons = 0;
  void height() { ++heights; }
  void exact_comparison() { ++exact_comparisons; }
};

template <class S, class Given>
cpp_rational exact_height(const Vec3<S>& n, const Vec3<Given>& x) {
  cpp_rational sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += cpp_rational(static_cast<double>(n[i])) * cpp_rational(static_cast<double>(x[i]));
  }
  return sum;
}

// Rational numbers are slow: they compare only what long double cannot tell apart.
template <class S, class Given>
std::uint32_t brute_force(const std::vector<Vec3<Given>>& vertices, const Vec3<S>& n) {
  using Long = long double;
  static_assert(std::numeric_limits<Long>::digits >= 64);
  std::vector<Long> height;
  Long most = -std::numeric_limits<Long>::infinity(), size = 0;
  for (const Vec3<Given>& x : vertices) {
    Long sum = 0, magnitude = 0;
    for (int i = 0; i < 3; ++i) {
      const Long product = Long(n[i]) * Long(x[i]);
      sum += product;
      magnitude += std::abs(product);
    }
    height.push_back(sum);
    most = std::max(most, sum);
    size = std::max(size, magnitude);
  }
  std::uint32_t best = 0;
  bool found = false;
  cpp_rational best_height;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    if (height[i] < most - size * 0x1p-60L) continue;
    const cpp_rational h = exact_height(n, vertices[i]);
    const auto later = [&] {
      for (int k = 0; k < 3; ++k) {
        if (vertices[i][k] != vertices[best][k]) return vertices[i][k] > vertices[best][k];
      }
      return false;
    };
    if (!found || h > best_height || (h == best_height && later())) {
      found = true;
      best = i;
      best_height = h;
    }
  }
  return best;
}

// Random ones; axes; normals of and perpendiculars to triangles and edges of vertices near one another, as
// rounded; and all of these off by an ulp in one component.
template <class S, class Given>
std::vector<Vec3<S>> directions(const Hull<Given>& hull, Draw& draw, int count) {
  std::vector<Vec3<S>> out;
  for (int i = 0; i < 3; ++i) {
    out.push_back(Vec3<S>::Unit(i));
    out.push_back(-Vec3<S>::Unit(i));
  }
  const auto scan_point = [&](std::uint32_t k) {
    return Vec3<S>(S(hull.scan(0)[k]), S(hull.scan(1)[k]), S(hull.scan(2)[k]));
  };
  for (int i = 0; i < count; ++i) {
    Vec3<S> n = draw.vector<S>(1);
    if (i % 3 > 0 && hull.has_adjacency()) {
      const HullGraph<Given>& graph = hull.graph();
      const std::uint32_t r = static_cast<std::uint32_t>(draw.bits() % graph.vertex.size());
      const std::uint32_t *first = graph.neighbours.list(r), *last = graph.neighbours.list(r + 1);
      const auto some = [&] {
        return scan_point(graph.vertex[first[draw.bits() % std::uint64_t(last - first)]]);
      };
      const Vec3<S> at = scan_point(graph.vertex[r]), edge = some() - at;
      n = i % 3 == 1 ? Vec3<S>(edge.cross(some() - at))
                     : Vec3<S>(n - edge * (n.dot(edge) / edge.squaredNorm()));
      if (draw.bits() & 1) n = -n;
      if (!(n.cwiseAbs().maxCoeff() > 0)) n = at;
    }
    out.push_back(n);
    const int k = static_cast<int>(draw.bits() % 3);
    n[k] = std::nextafter(n[k], S(draw.bits() & 1 ? 2 : -2));
    // Next to 0 is subnormal, which is 0 where subnormals are flushed.
    if (std::abs(n[k]) < std::numeric_limits<S>::min()) n[k] = std::copysign(S(0x1p-100), n[k]);
    out.push_back(n);
  }
  return out;
}

template <class S, class Given>
void expect_exact_maxima(Family family, int vertices, int count, long& ties) {
  const std::vector<Vec3<Given>> given =
      large_hull<Given>(family, vertices, 900 + static_cast<std::uint64_t>(vertices));
  const Hull<Given> hull = with_adjacency(std::span<const Vec3<Given>>(given));
  std::vector<Vec3<Given>> prepared;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    prepared.emplace_back(hull.scan(0)[k], hull.scan(1)[k], hull.scan(2)[k]);
  }
  Draw draw{17};
  std::uint32_t last = kNoStart;
  ASSERT_TRUE(hull.has_adjacency());
  Counted counted;
  for (const Vec3<S>& n : directions<S>(hull, draw, count)) {
    const std::uint32_t expected = brute_force(prepared, n),
                        any = static_cast<std::uint32_t>(draw.bits() % hull.size());
    const std::uint32_t cold = detail::climb(hull, n, kNoStart, counted);
    ASSERT_EQ(cold, expected) << static_cast<int>(family) << " " << vertices << " " << n.transpose();
    ASSERT_EQ((climb_support<S, Given>(hull, n, last)), expected);
    ASSERT_EQ((climb_support<S, Given>(hull, n, any)), expected);
    ASSERT_EQ((detail::scan<S, Given>(hull, n)), expected);
    last = cold;
  }
  ties += counted.exact_comparisons;
}

TEST(Climb, TiesAndNearTiesEndAtTheExactMaximumFromEveryStart) {
  long ties = 0;
  for (const Family family : test::kFamilies) {
    for (const int vertices : {24, 100, 700}) {
      expect_exact_maxima<double, double>(family, vertices, 60, ties);
      expect_exact_maxima<float, float>(family, vertices, 60, ties);
    }
  }
  EXPECT_GT(ties, 1000);
}

TEST(Climb, HullOfDoublesAlongFloatsAndTheOtherWayRound) {
  long ties = 0;
  for (const Family family : test::kFamilies) {
    expect_exact_maxima<float, double>(family, 300, 60, ties);
    expect_exact_maxima<double, float>(family, 300, 60, ties);
  }
  EXPECT_GT(ties, 100);
}

TEST(Climb, FourThousandVertices) {
  long ties = 0;
  for (const Family family : test::kFamilies) expect_exact_maxima<double, double>(family, 4096, 12, ties);
  EXPECT_GT(ties, 0);
}

// Every edge of a long flat path gains less than the rounding of a height: a walk that stopped within its
// band would stop anywhere.
TEST(Climb, LongPathThatGainsLessThanTheBandOnEveryEdge) {
  std::vector<Vec3<double>> vertices;
  constexpr int kRing = 2000;
  for (int i = 0; i < kRing; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRing;
    vertices.emplace_back(std::cos(angle), std::sin(angle), 1);
    vertices.emplace_back(std::cos(angle), std::sin(angle), -1);
  }
  const Hull<double> hull = with_adjacency(std::span<const Vec3<double>>(vertices));
  ASSERT_TRUE(hull.has_adjacency());
  for (const double tilt : {0x1p-45, 0x1p-52, 0x1p-60, 0x1p-300, 0x1p-900}) {
    for (const Vec3<double>& n : {Vec3<double>(-tilt, 0, 1), Vec3<double>(tilt / 3, tilt, -1)}) {
      const std::uint32_t expected = brute_force(vertices, n);
      for (std::uint32_t start = 0; start < vertices.size(); start += 97) {
        ASSERT_EQ((climb_support<double, double>(hull, n, start)), expected) << tilt;
      }
    }
  }
}

TEST(Climb, LengthOfTheDirectionChangesNothing) {
  const std::vector<Vec3<double>> vertices = large_hull<double>(Family::turned_cylinder, 200, 5);
  const Hull<double> hull = with_adjacency(std::span<const Vec3<double>>(vertices));
  Draw draw{6};
  for (int round = 0; round < 50; ++round) {
    const Vec3<double> n = round < 6 ? Vec3<double>((round % 2 ? 1 : -1) * Vec3<double>::Unit(round / 2))
                                     : draw.vector<double>(1);
    const std::uint32_t expected = brute_force(vertices, n);
    for (const int exponent : {-1000, -600, 600, 1020}) {
      const Vec3<double> scaled = std::ldexp(1.0, exponent) * n;
      EXPECT_EQ((climb_support<double, double>(hull, scaled, kNoStart)), expected) << exponent;
      EXPECT_EQ((detail::scan<double, double>(hull, scaled)), expected) << exponent;
    }
  }
}

TEST(Climb, DirectionsThatPointNowhereEnd) {
  const std::vector<Vec3<double>> vertices = large_hull<double>(Family::sphere, 300, 5);
  const Hull<double> hull = with_adjacency(std::span<const Vec3<double>>(vertices));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3<double>& n :
       {Vec3<double>(nan, 0, 1), Vec3<double>(kInfinity<double>, -kInfinity<double>, 0)}) {
    EXPECT_LT((climb_support<double, double>(hull, n, 3)), hull.size());
    EXPECT_LT((detail::scan<double, double>(hull, n)), hull.size());
  }
  EXPECT_EQ((climb_support<double, double>(hull, Vec3<double>::Zero(), 3)),
            brute_force(vertices, Vec3<double>::Zero().eval()));
}

TEST(Climb, OfEqualVerticesTheFirstGiven) {
  std::vector<Vec3<double>> vertices = large_hull<double>(Family::sphere, 100, 5);
  std::vector<Vec3<double>> twice = vertices;
  twice.insert(twice.end(), vertices.begin(), vertices.end());
  const Hull<double> hull = with_adjacency(std::span<const Vec3<double>>(twice));
  Draw draw{6};
  for (int round = 0; round < 100; ++round) {
    const std::uint32_t start = static_cast<std::uint32_t>(draw.bits() % twice.size());
    EXPECT_LT((climb_support<double, double>(hull, draw.vector<double>(1), start)), vertices.size());
  }
}

TEST(Climb, HullWithoutAdjacencyIsScannedToTheSameAnswer) {
  Draw draw{8};
  for (const Family family : test::kFamilies) {
    const std::vector<Vec3<double>> vertices = large_hull<double>(family, 61, 5);
    const Hull<double> plain{std::span<const Vec3<double>>(vertices)};
    const Hull<double> graph = with_adjacency(std::span<const Vec3<double>>(vertices));
    for (const Vec3<double>& n : directions<double>(graph, draw, 40)) {
      EXPECT_EQ((climb_support<double, double>(plain, n, kNoStart)),
                (climb_support<double, double>(graph, n, kNoStart)));
    }
  }
}

// Measured: 43 heights at 4096 vertices of a sphere, 37 of a cylinder, 21 at 64.
TEST(Climb, HeightsLookedAtGrowSlowerThanTheVertices) {
  for (const Family family : {Family::sphere, Family::cylinder, Family::turned_cylinder, Family::plate}) {
    double before = 60;
    for (const int vertices : {256, 512, 1024, 2048, 4096}) {
      const std::vector<Vec3<double>> given = large_hull<double>(family, vertices, 5);
      const Hull<double> hull = with_adjacency(std::span<const Vec3<double>>(given));
      Draw draw{6};
      Counted counted;
      constexpr int kRounds = 500;
      for (int round = 0; round < kRounds; ++round) {
        detail::climb(hull, draw.vector<double>(1), kNoStart, counted);
      }
      const double heights = static_cast<double>(counted.heights) / kRounds;
      EXPECT_LT(heights, 1.3 * before) << vertices;
      EXPECT_LT(heights, 60) << vertices;
      before = heights;
    }
  }
}

TEST(Climb, WarmStartNearTheAnswerLooksAtLess) {
  const std::vector<Vec3<double>> given = large_hull<double>(Family::sphere, 4096, 5);
  const Hull<double> hull = with_adjacency(std::span<const Vec3<double>>(given));
  Draw draw{6};
  Counted cold, warm;
  for (int round = 0; round < 500; ++round) {
    const Vec3<double> n = draw.vector<double>(1), near = n + 0.01 * draw.vector<double>(1);
    const std::uint32_t start = climb_support<double, double>(hull, near, kNoStart);
    detail::climb(hull, n, kNoStart, cold);
    detail::climb(hull, n, start, warm);
  }
  EXPECT_LT(2 * warm.heights, cold.heights);
}

}  // namespace
}  // namespace graze
