// Compares the map of a large hull with its scan, to the bit, and the vertices that a list omits with heights
// in long double.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <graze/cast.hpp>
#include <graze/detail/shapes/leaf.hpp>
#include <optional>

#include "tests/shared/large_hulls.hpp"

namespace graze {
namespace {

using test::Draw;
using test::Family;
using test::large_hull;

template <class S>
Vec3<S> scan_point(const Hull<S>& hull, std::uint32_t k) {
  return {hull.choice_scan(0)[k], hull.choice_scan(1)[k], hull.choice_scan(2)[k]};
}

// Random directions, axes, diagonals and other borders of squares, and normals of and perpendiculars to edges
// of the hull. Some have a component that hardly counts, and all but the first occur off by an ulp as well.
template <class S, class Given>
std::vector<Vec3<S>> directions(const Hull<Given>& hull, Draw& draw, int count) {
  std::vector<Vec3<S>> out;
  for (int i = 0; i < 3; ++i) {
    out.push_back(Vec3<S>::Unit(i));
    out.push_back(-Vec3<S>::Unit(i));
  }
  const detail::HullGraph<Given>& graph = hull.graph();
  const std::array<float, 3>& reach = graph.map.reach();
  for (int i = 0; i < count; ++i) {
    Vec3<S> n = draw.vector<S>(1);
    if (i % 4 == 1) {
      // On a border of squares, or beside it by as much as its place may be mistaken.
      const auto eighth = [&](std::size_t axis) {
        const double beside = draw.bits() & 1 ? 0x1p-10 * draw.between(-1, 1) : 0;
        return S((double(draw.bits() % 17) - 8) / 8 * (1 + beside) / double(reach[axis]));
      };
      n = {eighth(0), eighth(1), eighth(2)};
    } else if (i % 4 > 1) {
      const auto r = static_cast<std::uint32_t>(draw.bits() % graph.vertex.size());
      const std::uint32_t *first = graph.neighbours.list(r), *last = graph.neighbours.list(r + 1);
      const auto edge = [&] {
        const std::uint32_t to = first[draw.bits() % std::uint64_t(last - first)];
        return Vec3<S>(
            (scan_point(hull, graph.vertex[to]) - scan_point(hull, graph.vertex[r])).template cast<S>());
      };
      const Vec3<S> e = edge();
      n = i % 4 == 2 ? Vec3<S>(e.cross(edge())) : Vec3<S>(n - e * (n.dot(e) / e.squaredNorm()));
      if (draw.bits() & 1) n = -n;
    }
    if (i % 16 == 5) n[static_cast<int>(draw.bits() % 3)] *= S(0x1p-30);
    if (!(n.cwiseAbs().maxCoeff() > S(0x1p-60))) n = Vec3<S>(1, 2, 3);
    out.push_back(n);
    const int k = static_cast<int>(draw.bits() % 3);
    n[k] = std::nextafter(n[k], S(draw.bits() & 1 ? 2 : -2));
    out.push_back(n);
  }
  return out;
}

template <class Given>
Hull<Given> mapped(Family family, int vertices) {
  return with_adjacency(large_hull<Given>(family, vertices, 900 + static_cast<std::uint64_t>(vertices)));
}

// How many directions were answered by a list.
template <class S, class Given>
long compare_with_scan(const Hull<Given>& hull, int count, const char* what) {
  Draw draw{17};
  long listed = 0;
  const detail::DirectionMap& map = hull.graph().map;
  for (const Vec3<S>& d : directions<S>(hull, draw, count)) {
    EXPECT_EQ(detail::hull_support(hull, d), detail::scan_hull(hull, d)) << what << " " << d.transpose();
    const Vec3<float> f = d.template cast<float>();
    detail::DirectionMap::List list;
    if (!map.find(f[0], f[1], f[2], list)) continue;
    ++listed;
    EXPECT_EQ(list.vertex[detail::approximate_scan(list.xyz, list.size, f[0], f[1], f[2])],
              detail::approximate_scan(hull.approximate_scan(0), hull.padded_size(), f[0], f[1], f[2]))
        << what << " " << d.transpose();
  }
  return listed;
}

constexpr Family kMapped[] = {Family::sphere,       Family::cylinder, Family::turned_cylinder,
                              Family::lattice_ball, Family::needle,   Family::plate,
                              Family::cone};

TEST(DirectionMap, TheSameVertexAsAScanOfAll) {
  long listed = 0, asked = 0;
  for (const Family family : kMapped) {
    for (const int vertices : {200, 512, 2048, 4100}) {
      const std::string what = std::to_string(static_cast<int>(family)) + ", " + std::to_string(vertices);
      const Hull<double> wide = mapped<double>(family, vertices);
      const Hull<float> narrow = mapped<float>(family, vertices);
      ASSERT_FALSE(wide.graph().map.empty()) << what;
      ASSERT_FALSE(narrow.graph().map.empty()) << what;
      listed += compare_with_scan<double>(wide, 1000, what.c_str());
      listed += compare_with_scan<float>(wide, 500, what.c_str());
      listed += compare_with_scan<double>(narrow, 500, what.c_str());
      listed += compare_with_scan<float>(narrow, 1000, what.c_str());
      asked += 2 * 3000;
    }
  }
  EXPECT_GT(listed, asked * 99 / 100);
}

// If floats hardly resolve the heights of two points, both are kept.
TEST(DirectionMap, TheSameOfPointsWithATwinBesideThem) {
  for (const double apart : {1e-8, 1e-7, 3e-7}) {
    const std::vector<Vec3<double>> points = large_hull<double>(Family::sphere, 300, 5);
    std::vector<Vec3<double>> twins = points;
    Draw draw{7};
    for (const Vec3<double>& p : points) twins.emplace_back(p + apart * draw.vector<double>(1));
    const Hull<double> hull = with_adjacency(twins);
    ASSERT_FALSE(hull.graph().map.empty());
    EXPECT_GT(compare_with_scan<double>(hull, 2000, "twins"), 3000);
    EXPECT_GT(compare_with_scan<float>(hull, 2000, "twins"), 3000);
  }
}

// Beside the border of two squares by as much as a direction's place is mistaken.
TEST(DirectionMap, TheSameJustBesideTheBordersOfSquares) {
  for (const int vertices : {700, 2500}) {
    const Hull<float> hull = mapped<float>(Family::sphere, vertices);
    const detail::DirectionMap& map = hull.graph().map;
    const auto k = static_cast<double>(map.squares_along_edge());
    Draw draw{53};
    long wrong = 0;
    for (int round = 0; round < 400000; ++round) {
      double on[3] = {1, draw.between(-1, 1), 0};
      on[2] = (2 * double(draw.bits() % (map.squares_along_edge() + 1)) / k - 1) *
              (1 + 0x1p-10 * draw.between(0, 1));
      const std::size_t turn = draw.bits() % 3;
      float d[3];
      for (std::size_t i = 0; i < 3; ++i) d[i] = float(on[(i + turn) % 3] / double(map.reach()[i]));
      detail::DirectionMap::List list;
      ASSERT_TRUE(map.find(d[0], d[1], d[2], list));
      wrong += list.vertex[detail::approximate_scan(list.xyz, list.size, d[0], d[1], d[2])] !=
               detail::approximate_scan(hull.approximate_scan(0), hull.padded_size(), d[0], d[1], d[2]);
    }
    EXPECT_EQ(wrong, 0) << vertices;
  }
}

TEST(DirectionMap, TheSameFarFromTheOriginAndOfPointsGivenTwice) {
  for (const Vec3<double>& offset :
       {Vec3<double>(0.6, 0, 0), Vec3<double>(2, -1, 0.1), Vec3<double>(1e6, 3, -7)}) {
    std::vector<Vec3<double>> points = large_hull<double>(Family::sphere, 500, 5);
    for (Vec3<double>& p : points) p += offset;
    points.insert(points.end(), points.begin(), points.begin() + 250);
    const Hull<double> hull = with_adjacency(points);
    ASSERT_FALSE(hull.graph().map.empty());
    EXPECT_GT(compare_with_scan<double>(hull, 1000, "offset"), 1000);
  }
}

// The promise of the map, also for directions 2^-15 beside the one that was looked up. A vertex that is not
// in the list is lower than one in it by 10 u B, B the sum of |d_i| times the reach.
TEST(DirectionMap, WhatAListLeavesOutIsLowerByMoreThanFloatsRound) {
  using Long = long double;
  constexpr Long kRounding = 10 * Long(kUnitRoundoff<float>);
  long left_out = 0;
  for (const Family family : kMapped) {
    const Hull<double> hull = mapped<double>(family, 600);
    const detail::DirectionMap& map = hull.graph().map;
    Draw draw{23};
    for (const Vec3<float>& d : directions<float>(hull, draw, 300)) {
      detail::DirectionMap::List list;
      if (!map.find(d[0], d[1], d[2], list)) continue;
      std::vector<bool> kept(hull.size(), false);
      for (std::size_t i = 0; i < list.size; ++i) kept[list.vertex[i]] = true;
      Long n[3], most = 0, size = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        n[i] = Long(d[static_cast<int>(i)]) * Long(map.reach()[i]);
        most = std::max(most, std::abs(n[i]));
      }
      for (Long& one : n) {
        if (std::abs(one) < most) one += (draw.bits() & 1 ? 1 : -1) * most * 0x1p-15L;
        size += std::abs(one);
      }
      const auto height = [&](std::size_t k) {
        Long sum = 0;
        for (int i = 0; i < 3; ++i)
          sum += n[i] * Long(hull.approximate_scan(i)[k]) / Long(map.reach()[static_cast<std::size_t>(i)]);
        return sum;
      };
      Long in = -std::numeric_limits<Long>::infinity(), out = in;
      for (std::size_t k = 0; k < hull.size(); ++k)
        (kept[k] ? in : out) = std::max(kept[k] ? in : out, height(k));
      left_out += std::count(kept.begin(), kept.end(), false);
      EXPECT_GT(in - out, kRounding * size) << static_cast<int>(family) << " " << d.transpose();
    }
  }
  EXPECT_GT(left_out, 100000);
}

// Measured: 16 vertices a list on a sphere, 96 to 192 bytes a vertex. On two rings 155 of 4,096.
TEST(DirectionMap, ListsAreShortAndTakeLittleRoom) {
  for (const int vertices : {256, 1024, 2048, 4096}) {
    const Hull<double> hull = mapped<double>(Family::sphere, vertices);
    const detail::DirectionMap& map = hull.graph().map;
    Draw draw{6};
    double sum = 0;
    constexpr int kRounds = 1000;
    for (int round = 0; round < kRounds; ++round) {
      const Vec3<float> d = draw.vector<float>(1);
      detail::DirectionMap::List list;
      ASSERT_TRUE(map.find(d[0], d[1], d[2], list));
      sum += static_cast<double>(list.size);
    }
    EXPECT_LT(sum / kRounds, 17) << vertices;
    EXPECT_LT(map.bytes(), 200u * hull.size()) << vertices;
  }
  for (const Family family : {Family::cylinder, Family::cone, Family::turned_cylinder}) {
    const Hull<double> hull = mapped<double>(family, 4096);
    EXPECT_LT(hull.graph().map.bytes(), 400u * hull.size());
  }
}

TEST(DirectionMap, NoneWhereItWouldNotPay) {
  EXPECT_TRUE(mapped<double>(Family::sphere, detail::kMapFrom - 1).graph().map.empty());
  EXPECT_FALSE(mapped<double>(Family::sphere, detail::kMapFrom).graph().map.empty());
  // All but two vertices are clouds about two opposite corners: half of them can be the farthest along anything.
  std::vector<Vec3<double>> clouds = {{1, -1, 1}, {-1, 1, -1}};
  Draw draw{31};
  for (int i = 0; i < 400; ++i)
    clouds.emplace_back((i % 2 ? 1 : -1) * (Vec3<double>(1, 1, 1) + 1e-9 * draw.vector<double>(1)));
  const Hull<double> two = with_adjacency(clouds);
  ASSERT_TRUE(two.has_adjacency());
  EXPECT_TRUE(two.graph().map.empty());
  // Floats cannot tell its sides apart.
  std::vector<Vec3<double>> thin = large_hull<double>(Family::sphere, 300, 5);
  for (Vec3<double>& p : thin) p[1] = std::ldexp(p[1], -70);
  const Hull<double> sheet = with_adjacency(thin);
  ASSERT_TRUE(sheet.has_adjacency());
  EXPECT_TRUE(sheet.graph().map.empty());
  EXPECT_EQ(detail::hull_support(sheet, Vec3<double>(1, 2, 3)),
            detail::scan_hull(sheet, Vec3<double>(1, 2, 3)));
}

TEST(DirectionMap, DirectionsOfNoUseFindNothing) {
  const Hull<double> hull = mapped<double>(Family::sphere, 300);
  const detail::DirectionMap& map = hull.graph().map;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kHuge = std::numeric_limits<float>::infinity();
  detail::DirectionMap::List list;
  EXPECT_TRUE(map.find(1, 2, 3, list));
  for (const float odd : {kNan, kHuge, -kHuge, 0x1p100F}) {
    EXPECT_FALSE(map.find(odd, 0, 1, list)) << odd;
    EXPECT_FALSE(map.find(0, odd, 1, list)) << odd;
    EXPECT_FALSE(map.find(1, 0, odd, list)) << odd;
  }
  EXPECT_FALSE(map.find(0, 0, 0, list));
  EXPECT_FALSE(map.find(0x1p-90F, 0, 0, list));
  Draw draw{6};
  for (int round = 0; round < 50; ++round) {
    const Vec3<double> n = draw.vector<double>(1);
    for (const int exponent : {-900, -90, -70, 70, 90, 900}) {
      const Vec3<double> scaled = std::ldexp(1.0, exponent) * n;
      EXPECT_EQ(detail::hull_support(hull, scaled), detail::scan_hull(hull, n)) << exponent;
    }
  }
}

// Every number of an answer is the same with adjacency as without.
template <class S>
void expect_same_casts(Tier tier, std::optional<Method> method) {
  Draw draw{41};
  long hits = 0;
  for (const Family family : kMapped) {
    const std::vector<Vec3<S>> one = large_hull<S>(family, 300, 43),
                               other = large_hull<S>(Family::sphere, 800, 44);
    const Hull<S> plain[] = {Hull<S>(one), Hull<S>(other)},
                  mapped[] = {with_adjacency(one), with_adjacency(other)};
    const S size = plain[0].largest();
    for (int round = 0; round < 40; ++round) {
      Body<S> a{.shape = plain[0]}, b{.shape = plain[1]};
      b.position = (size + 2) * draw.vector<S>(1).normalized();
      b.displacement = -2 * b.position + S(0.3) * size * draw.vector<S>(1);
      if (round % 4 == 0) b.displacement[round / 4 % 3] = 0;
      if (round % 2 == 0) {
        const Eigen::Matrix<S, 4, 1> q =
            Eigen::Matrix<S, 4, 1>(1, S(draw.between(-1, 1)), S(draw.between(-1, 1)), 0);
        a.orientation = {q[0], q[1], q[2], q[3]};
      }
      const CastOptions<S> options{.tier = tier, .method = method};
      const CastResult<S> without = cast(a, b, options);
      a.shape = mapped[0];
      b.shape = mapped[1];
      const CastResult<S> with = cast(a, b, options);
      hits += without.outcome == Outcome::hit;
      EXPECT_EQ(with.outcome, without.outcome);
      EXPECT_EQ(with.toi_lower, without.toi_lower);
      EXPECT_EQ(with.toi_upper, without.toi_upper);
      EXPECT_EQ(with.normal, without.normal);
      EXPECT_EQ(with.counters.supports, without.counters.supports);
      EXPECT_EQ(with.counters.exact_decisions, without.counters.exact_decisions);
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(DirectionMap, CastsAnswerTheSameBits) {
  for (const Tier tier : {Tier::standard, Tier::exact, Tier::certified}) {
    expect_same_casts<double>(tier, {});
    expect_same_casts<float>(tier, {});
  }
  expect_same_casts<double>(Tier::standard, Method::gjk_ray_cast);
  expect_same_casts<float>(Tier::standard, Method::conservative_advancement);
}

}  // namespace
}  // namespace graze
