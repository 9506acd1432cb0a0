#include <gtest/gtest.h>
#include <graze/detail/shapes/hull_graph.hpp>

#include <boost/multiprecision/cpp_int.hpp>
#include <set>

#include "tests/shared/large_hulls.hpp"

namespace graze {
namespace {

using boost::multiprecision::cpp_rational;
using detail::GraphMaker;
using detail::HullTriangle;
using test::Draw;
using Points = std::vector<Vec3<double>>;
using Faces = std::vector<std::vector<std::uint32_t>>;

Hull<double> derived(const Points& points) { return with_adjacency(std::span<const Vec3<double>>(points)); }
bool verified(const Points& points, const Faces& faces) {
  return with_faces(std::span<const Vec3<double>>(points), std::span<const std::vector<std::uint32_t>>(faces))
      .has_adjacency();
}
std::set<std::uint32_t> vertices_of(const Hull<double>& hull) {
  return {hull.graph().vertex.begin(), hull.graph().vertex.end()};
}

// sign det[b - a, c - a, d - a] of integer points.
int integer_side(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c, const Vec3<double>& d) {
  std::int64_t m[3][3];
  for (int i = 0; i < 3; ++i) {
    m[0][i] = static_cast<std::int64_t>(b[i] - a[i]);
    m[1][i] = static_cast<std::int64_t>(c[i] - a[i]);
    m[2][i] = static_cast<std::int64_t>(d[i] - a[i]);
  }
  const std::int64_t det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (det > 0) - (det < 0);
}

// Is p in the hull of the others, by every tetrahedron of them (Caratheodory)? An equal point is its own.
bool extreme(const Points& points, std::size_t p) {
  Points others;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] != points[p]) others.push_back(points[i]);
  }
  const std::size_t n = others.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        for (std::size_t d = c + 1; d < n; ++d) {
          const Vec3<double>* t[] = {&others[a], &others[b], &others[c], &others[d]};
          const int whole = integer_side(*t[0], *t[1], *t[2], *t[3]);
          if (whole == 0) continue;
          bool inside = true;
          for (int k = 0; k < 4 && inside; ++k) {
            const Vec3<double>* s[] = {t[0], t[1], t[2], t[3]};
            s[k] = &points[p];
            inside = whole * integer_side(*s[0], *s[1], *s[2], *s[3]) >= 0;
          }
          if (inside) return false;
        }
      }
    }
  }
  return true;
}

bool flat(const Points& points) {
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        for (std::size_t d = c + 1; d < points.size(); ++d) {
          if (integer_side(points[a], points[b], points[c], points[d]) != 0) return false;
        }
      }
    }
  }
  return true;
}

TEST(PointSet, OrientationNearAPlaneIsExact) {
  Draw draw{61};
  int zeros = 0, close = 0;
  for (int round = 0; round < 3000; ++round) {
    Points p;
    for (int i = 0; i < 3; ++i) p.push_back(draw.vector<double>(1));
    const double s = draw.between(-1, 1), t = draw.between(-1, 1);
    Vec3<double> fourth = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    if (round % 3 == 1) {  // exactly coplanar, by coordinates of few bits
      for (Vec3<double>& x : p) x = (x * 64).array().round() / 64;
      fourth = p[0] + 2 * (p[1] - p[0]) - (p[2] - p[0]);
    } else if (round % 3 == 2) {  // exactly coplanar, with all bits: a parallelogram that does not round
      for (int i = 0; i < 3; ++i) p[1][i] = p[0][i] + std::ldexp(std::round(p[1][i] * 1024), -60);
      fourth = p[2] + (p[1] - p[0]);
    }
    fourth = fourth.cwiseMax(-1.9).cwiseMin(1.9);
    p.push_back(fourth);
    const detail::exact::PointSet set(p);
    ASSERT_TRUE(set.valid());
    cpp_rational m[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) m[i][k] = cpp_rational(p[i + 1][k]) - cpp_rational(p[0][k]);
    }
    const cpp_rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    ASSERT_EQ(set.orientation(0, 1, 2, 3), det.sign()) << round;
    zeros += det == 0;
    close += det != 0 && abs(det) < 1e-14;
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(close, 500);
}

TEST(PointSet, CoordinatesWhoseProductsUnderflowAreRefused) {
  EXPECT_TRUE(detail::exact::PointSet({{1, 0x1p-280, 0}}).valid());
  EXPECT_FALSE(detail::exact::PointSet({{1, 0x1p-281, 0}}).valid());
  EXPECT_FALSE(detail::exact::PointSet({{2, 0, 0}}).valid());
  EXPECT_FALSE(detail::exact::PointSet({{std::numeric_limits<double>::quiet_NaN(), 0, 0}}).valid());
  // At the end of the range: det = -(2^-280)^3, beside a tie.
  const double e = 0x1p-280;
  const detail::exact::PointSet set({{0, 0, 0}, {e, 0, 0}, {0, e, 0}, {0, 0, -e}, {e, e, 0}});
  EXPECT_EQ(set.orientation(0, 1, 2, 3), -1);
  EXPECT_EQ(set.orientation(0, 1, 2, 4), 0);
}

TEST(HeightSign, WidelySpreadTermsAreSummedExactly) {
  // The first components tie, and the second decides, 2^-900 as large.
  EXPECT_EQ(detail::exact::height_sign({1, 0x1p-900, 0}, {1, 1, 0}, {1, -1, 0}), 1);
  EXPECT_EQ(detail::exact::height_sign({1, -0x1p-900, 0}, {1, 1, 0}, {1, -1, 0}), -1);
  EXPECT_EQ(detail::exact::height_sign({0x1p-1000, 0x1p-1000, 0}, {1, -1, 3}, {-1, 1, 0}), 0);
  EXPECT_EQ(detail::exact::height_sign({1, 1, 1}, {1, 0x1p-53, 0x1p-106}, {1 + 0x1p-52, -0x1p-53, 0}), 1);
  EXPECT_EQ(detail::exact::height_sign({1, 1, 1}, {1, 0x1p-53, 0}, {1 + 0x1p-52, -0x1p-53, 0}), 0);
}

TEST(HullGraph, DuplicatesAndPointsInsideFacesAndEdgesAreNoVertices) {
  Points points;
  for (int copy = 0; copy < 2; ++copy) {
    for (int i = 0; i < 27; ++i) points.emplace_back(i % 3, i / 3 % 3, i / 9);
  }
  const Hull<double> hull = derived(points);
  ASSERT_TRUE(hull.has_adjacency());
  EXPECT_EQ(vertices_of(hull), (std::set<std::uint32_t>{0, 2, 6, 8, 18, 20, 24, 26}));
  EXPECT_EQ(hull.size(), 54u);  // and nothing is dropped from the hull itself
  EXPECT_EQ(hull.graph().rank[27], hull.graph().rank[0]);
  EXPECT_EQ(hull.graph().rank[13], detail::HullGraph<double>::kNone);
}

// On grids of 2 to 5 steps most draws are degenerate one way or another.
TEST(HullGraph, VerticesAreTheExtremePointsOfSmallLattices) {
  Draw draw{62};
  int flats = 0, solids = 0, redundant = 0;
  for (int round = 0; round < 1500; ++round) {
    const std::uint64_t steps = 2 + draw.bits() % 4, count = 4 + draw.bits() % 9;
    Points points;
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto coordinate = [&] { return static_cast<double>(draw.bits() % steps); };
      points.emplace_back(coordinate(), coordinate(), coordinate());
    }
    const Hull<double> hull = derived(points);
    ASSERT_EQ(hull.has_adjacency(), !flat(points)) << round;
    if (!hull.has_adjacency()) {
      ++flats;
      continue;
    }
    ++solids;
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (std::find(points.begin(), points.begin() + i, points[i]) == points.begin() + i &&
          extreme(points, i)) {
        expected.insert(i);
      }
    }
    redundant += expected.size() < points.size();
    ASSERT_EQ(vertices_of(hull), expected) << round;
  }
  EXPECT_GT(flats, 100);
  EXPECT_GT(solids, 500);
  EXPECT_GT(redundant, 500);
}

// A closed triangulation of a sphere with v vertices has 3 v - 6 edges, each known from both ends.
TEST(HullGraph, NeighboursAreATriangulation) {
  for (const test::Family family : test::kFamilies) {
    for (const int count : {12, 60, 400}) {
      const Hull<double> hull = derived(test::large_hull<double>(family, count, 63));
      const detail::HullGraph<double>& graph = hull.graph();
      EXPECT_EQ(graph.neighbours.entries.size(), 6 * graph.vertex.size() - 12);
      for (std::uint32_t r = 0; r < graph.vertex.size(); ++r) {
        for (const std::uint32_t* s = graph.neighbours.list(r); s != graph.neighbours.list(r + 1); ++s) {
          EXPECT_NE(std::find(graph.neighbours.list(*s), graph.neighbours.list(*s + 1), r),
                    graph.neighbours.list(*s + 1));
        }
      }
    }
  }
}

// The derivation against the check of faces, which shares only the sign of a determinant with it.
TEST(HullGraph, DerivedTrianglesAreAcceptedAsFaces) {
  for (const test::Family family : {test::Family::sphere, test::Family::cylinder,
                                    test::Family::turned_cylinder, test::Family::cone, test::Family::plate}) {
    const Points points = test::large_hull<double>(family, 150, 63);  // distinct: numbered as given
    const GraphMaker maker(detail::exact_scan(Hull<double>(std::span<const Vec3<double>>(points))));
    Faces faces;
    for (const HullTriangle& t : maker.derive()) faces.push_back({t[0], t[1], t[2]});
    EXPECT_TRUE(verified(points, faces));
    // One triangle beheaded by a point that is not a vertex of the hull: concave.
    Points more = points;
    const Vec3<double> middle = (points[faces[7][0]] + points[faces[7][1]] + points[faces[7][2]]) / 3;
    more.emplace_back(0.5 * middle);
    const std::uint32_t inner = static_cast<std::uint32_t>(points.size());
    Faces dented = faces;
    const std::vector<std::uint32_t> t = faces[7];
    dented[7] = {t[0], t[1], inner};
    dented.push_back({t[1], t[2], inner});
    dented.push_back({t[2], t[0], inner});
    EXPECT_TRUE(verified(more, faces));
    EXPECT_FALSE(verified(more, dented));
  }
}

TEST(HullGraph, NoneForLowerDimensionsAndWhatIsOutOfRange) {
  Draw draw{65};
  const auto none = [](const Points& points) { return !derived(points).has_adjacency(); };
  EXPECT_TRUE(none({}));
  EXPECT_TRUE(none({{1, 2, 3}}));
  EXPECT_TRUE(none({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
  Points line, plane, lifted;
  for (int i = 0; i < 40; ++i) {
    const double s = std::round(draw.between(-1e6, 1e6)), t = std::round(draw.between(-1e6, 1e6));
    line.emplace_back(3 * s, 5 * s, -7 * s);
    plane.emplace_back(s, t, 3 * s - 5 * t);  // exact: integers
  }
  lifted = plane;
  lifted[17][2] = std::nextafter(lifted[17][2], 1e9);
  EXPECT_TRUE(none(line));
  EXPECT_TRUE(none(plane));
  EXPECT_FALSE(none(lifted));
  const Points simplex = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_FALSE(none(simplex));
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), kInfinity<double>, 1e-100}) {
    Points spoilt = simplex;
    spoilt[3][2] = odd;
    EXPECT_TRUE(none(spoilt)) << odd;
  }
  // In float the scan of the small coordinate underflows, beside a large one.
  const std::vector<Vec3<float>> spread = {{1e30f, 0, 0}, {0, 1e30f, 0}, {0, 0, 1e-20f}, {0, 0, 0}};
  EXPECT_FALSE(with_adjacency(std::span<const Vec3<float>>(spread)).has_adjacency());
}

TEST(HullGraph, LargeCommonOffsetIsNoObstacle) {
  Points points = test::large_hull<double>(test::Family::sphere, 100, 66);
  for (Vec3<double>& p : points) p = p + Vec3<double>(1e9, -3e7, 5);
  const Hull<double> hull = derived(points);
  ASSERT_TRUE(hull.has_adjacency());
  EXPECT_GT(hull.graph().vertex.size(), 90u);
}

class HintedBox : public testing::Test {
 protected:
  // Vertex k has x_i = 1 where bit i of k is set. The faces are anticlockwise from outside.
  HintedBox() {
    for (unsigned k = 0; k < 8; ++k) points.emplace_back(k & 1u ? 1 : 0, k & 2u ? 1 : 0, k & 4u ? 1 : 0);
  }
  Points points;
  Faces faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
};

TEST_F(HintedBox, TrueFacesAreAccepted) {
  EXPECT_TRUE(verified(points, faces));
  points.emplace_back(0.5, 0.25, 0.5);  // interior
  points.emplace_back(0.5, 0.25, 1);    // on a face
  points.emplace_back(1, 0, 1);         // a duplicate
  EXPECT_TRUE(verified(points, faces));
  faces[1] = {4, 10, 7, 6};  // by its duplicate's name
  EXPECT_TRUE(verified(points, faces));
}

TEST_F(HintedBox, TamperedFacesAreIgnored) {
  const auto refused = [&](const auto& tamper) {
    Points p = points;
    Faces f = faces;
    tamper(p, f);
    return !verified(p, f);
  };
  EXPECT_TRUE(refused([](Points&, Faces& f) { f.clear(); }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { f.pop_back(); }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { f.push_back(f[0]); }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { std::reverse(f[2].begin(), f[2].end()); }));
  EXPECT_TRUE(refused([](Points&, Faces& f) {
    for (auto& face : f) std::reverse(face.begin(), face.end());
  }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { f[3].pop_back(); }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { f[3] = {2, 6}; }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { f[3][2] = 8; }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { std::swap(f[3][1], f[3][2]); }));
  EXPECT_TRUE(refused([](Points&, Faces& f) { f[0] = f[1]; }));
  EXPECT_TRUE(refused([](Points& p, Faces&) { p.emplace_back(0.5, 0.5, std::nextafter(1.0, 2.0)); }));
  EXPECT_TRUE(refused([](Points& p, Faces&) { p[7][2] = std::nextafter(1.0, 0.0); }));  // 4 5 7 6 is bent
  // Bent the convex way along the fan's diagonal 4-7, it is right again.
  EXPECT_FALSE(refused([](Points& p, Faces&) { p[4][2] = p[7][2] = std::nextafter(1.0, 2.0); }));
  // Two boxes, and two that share a corner.
  for (const double apart : {3.0, 1.0}) {
    EXPECT_TRUE(refused([&](Points& p, Faces& f) {
      for (unsigned k = 0; k < 8; ++k) p.emplace_back(p[k] + Vec3<double>::Constant(apart));
      for (unsigned k = 0; k < 6; ++k) {
        f.push_back(f[k]);
        for (std::uint32_t& i : f.back()) i += 8;
      }
    }));
  }
}

// Every edge of a pentagram's double pyramid is convex, its surface is a sphere, its middle is below every
// triangle: only the count of what a ray meets says that it goes round twice.
TEST(HullGraph, SurfaceThatGoesRoundTwiceIsIgnored) {
  for (const std::uint32_t step : {1u, 2u}) {
    Points points;
    for (int i = 0; i < 5; ++i) {
      const double angle = 2 * std::numbers::pi * i / 5;
      points.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    points.emplace_back(0, 0, 1);
    points.emplace_back(0, 0, -1);
    Faces faces;
    for (std::uint32_t i = 0; i < 5; ++i) {
      const std::uint32_t from = i * step % 5, to = (i + 1) * step % 5;
      faces.push_back({from, to, 5});
      faces.push_back({to, from, 6});
    }
    EXPECT_EQ(verified(points, faces), step == 1);
  }
}

TEST(HullGraph, CornersInsideTheEdgesOfVerifiedFacesAreKept) {
  // A box whose faces are cut into grids: corners inside faces and edges.
  Points points;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      points.emplace_back(i, j, 0);
      points.emplace_back(i, j, 3);
    }
  }
  const auto at = [](int i, int j, int top) { return static_cast<std::uint32_t>(2 * (4 * i + j) + top); };
  Faces faces;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      faces.push_back({at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1)});
      faces.push_back({at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)});
    }
    faces.push_back({at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1)});
    faces.push_back({at(i + 1, 3, 0), at(i, 3, 0), at(i, 3, 1), at(i + 1, 3, 1)});
    faces.push_back({at(0, i + 1, 0), at(0, i, 0), at(0, i, 1), at(0, i + 1, 1)});
    faces.push_back({at(3, i, 0), at(3, i + 1, 0), at(3, i + 1, 1), at(3, i, 1)});
  }
  const Hull<double> hull =
      with_faces(std::span<const Vec3<double>>(points), std::span<const std::vector<std::uint32_t>>(faces));
  ASSERT_TRUE(hull.has_adjacency());
  EXPECT_EQ(hull.graph().vertex.size(), points.size());
  EXPECT_EQ(hull.graph().neighbours.entries.size(), 6 * points.size() - 12);
}

}  // namespace
}  // namespace graze
