// Decides: the convex hull of integer points, exactly, in the dimension that it has. Solids use CGAL's
// convex_hull_3. Points, segments and polygons use the few signs that they need.
// Brackets: nothing.
// Costs: nearly all of what linear_truth.cpp's construction costs.
// Cannot be trusted: if CGAL's hull is wrong. Therefore linear_program.cpp and nef_minkowski.cpp are used as
// checks.
#include "oracles/polytope/exact_cso.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost_mp.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <iterator>
#include <map>
#include <stdexcept>

namespace graze::oracle {
namespace {

// Most of a difference's faces are parallelograms, whose fourth corner no filter separates from the plane of
// the others, so the exact decision dominates the cost. Integers of 512 bits on the stack decide in a fifth
// of the time of the lazy exact kernel. The lazy kernel serves the coordinates that they cannot hold: for b
// bits, a plane's normal has 2 b + 3, and its sign at a point 3 b + 8.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 512, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;
constexpr std::size_t kWideBits = 160;

struct WideIntegers {
  using Kernel = CGAL::Simple_cartesian<Wide>;

  static Wide from(const Integer& i) {
    std::array<std::uint64_t, 8> limbs{};
    std::size_t count = 0;
    mpz_export(limbs.data(), &count, -1, sizeof limbs[0], 0, 0, i.get_mpz_t());
    Wide out = 0;
    if (count == 0) return out;  // import_bits reads the last of its range
    boost::multiprecision::import_bits(out, limbs.begin(), limbs.begin() + static_cast<std::ptrdiff_t>(count),
                                       64, false);
    return sgn(i) < 0 ? -out : out;
  }
  static Integer to(const Wide& wide) {
    std::vector<std::uint64_t> limbs;
    boost::multiprecision::export_bits(abs(wide), std::back_inserter(limbs), 64, false);
    Integer out;
    mpz_import(out.get_mpz_t(), limbs.size(), -1, sizeof limbs[0], 0, 0, limbs.data());
    return wide < 0 ? Integer(-out) : out;
  }
};

struct LazyRationals {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact = Kernel::FT::ET;

  // CGAL chooses the rationals of its exact kernel by what it finds: boost's over GMP, its own, or gmpxx's.
  static Kernel::FT from(const Integer& i) {
    const Rational q(i);
    return Kernel::FT(Exact(q.get_mpq_t()));
  }
  static Integer to(const Kernel::FT& x) { return numerator(CGAL::exact(x)); }

 private:
  template <class Number>
  static Integer numerator(const Number& e) {
    if constexpr (requires { e.backend().data(); }) {
      return Integer(mpq_numref(e.backend().data()));
    } else if constexpr (requires { e.mpq(); }) {
      return Integer(mpq_numref(e.mpq()));
    } else {
      return e.get_num();
    }
  }
};

int add_half_space(ConvexHull& hull, IntVec normal, const IntVec& through) {
  HalfSpace& h = hull.half_spaces.emplace_back();
  h.offset = dot(normal, through);
  h.normal = std::move(normal);
  return static_cast<int>(hull.half_spaces.size()) - 1;
}

void add_equality(ConvexHull& hull, const IntVec& normal, const IntVec& through) {
  add_half_space(hull, normal, through);
  add_half_space(hull, -normal, through);
}

void add_facet(ConvexHull& hull, int half_space, std::vector<int> loop) {
  HullFacet& facet = hull.facets.emplace_back();
  facet.half_space = half_space;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const IntVec along = hull.vertices[loop[(i + 1) % n]] - hull.vertices[loop[i]];
    facet.outward.push_back(cross(along, hull.half_spaces[half_space].normal));
  }
  facet.loop = std::move(loop);
}

// Two directions that span the plane perpendicular to d.
std::array<IntVec, 2> perpendicular(const IntVec& d) {
  const IntVec first = sgn(d.x) != 0 || sgn(d.y) != 0 ? IntVec{d.y, -d.x, 0} : IntVec{1, 0, 0};
  return {first, cross(d, first)};
}

ConvexHull point_hull(const IntVec& p) {
  ConvexHull hull;
  hull.vertices = {p};
  add_equality(hull, {1, 0, 0}, p);
  add_equality(hull, {0, 1, 0}, p);
  add_equality(hull, {0, 0, 1}, p);
  return hull;
}

ConvexHull segment_hull(const std::vector<IntVec>& points, const IntVec& along) {
  ConvexHull hull;
  hull.dimension = 1;
  const auto before = [&](const IntVec& l, const IntVec& r) { return dot(l, along) < dot(r, along); };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), before);
  hull.vertices = {*low, *high};
  hull.edges.push_back({0, 1, {0, 0}, *high - *low});
  for (const IntVec& n : perpendicular(along)) add_equality(hull, n, *low);
  add_half_space(hull, -along, *low);
  add_half_space(hull, along, *high);
  return hull;
}

// Andrew's monotone chain in the plane with the given normal. Points are sorted.
ConvexHull polygon_hull(const std::vector<IntVec>& points, const IntVec& normal) {
  // A point left of (p, q) about the normal: dot(cross(q - p, r - p), normal) > 0. Lexicographic order is a
  // sweep order of the plane too. Distinct points of it with equal (x, y) differ in z consistently, because
  // the order is by x, then y, then z, and each is a linear function on the plane.
  const auto turn = [&](const IntVec& p, const IntVec& q, const IntVec& r) {
    return sgn(dot(cross(q - p, r - p), normal));
  };
  std::vector<IntVec> chain;
  const auto sweep = [&](auto begin, auto end) {
    const std::size_t base = chain.size();
    for (auto it = begin; it != end; ++it) {
      while (chain.size() >= base + 2 && turn(chain[chain.size() - 2], chain.back(), *it) <= 0)
        chain.pop_back();
      chain.push_back(*it);
    }
    chain.pop_back();
  };
  sweep(points.begin(), points.end());
  sweep(points.rbegin(), points.rend());

  ConvexHull hull;
  hull.dimension = 2;
  hull.vertices = std::move(chain);
  const int n = static_cast<int>(hull.vertices.size());
  const int up = add_half_space(hull, normal, hull.vertices[0]);
  const int down = add_half_space(hull, -normal, hull.vertices[0]);
  std::vector<int> loop;
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    loop.push_back(i);
    hull.edges.push_back({i, next, {0, 1}, hull.vertices[next] - hull.vertices[i]});
    add_half_space(hull, cross(hull.edges.back().direction, normal), hull.vertices[i]);
  }
  add_facet(hull, up, loop);
  std::reverse(loop.begin(), loop.end());
  add_facet(hull, down, loop);
  return hull;
}

template <class Numbers>
ConvexHull solid_hull_in(const std::vector<IntVec>& points) {
  using Point = typename Numbers::Kernel::Point_3;
  std::vector<Point> exact_points;
  exact_points.reserve(points.size());
  for (const IntVec& p : points) {
    exact_points.emplace_back(Numbers::from(p.x), Numbers::from(p.y), Numbers::from(p.z));
  }
  CGAL::Surface_mesh<Point> mesh;
  CGAL::convex_hull_3(exact_points.begin(), exact_points.end(), mesh);

  ConvexHull hull;
  hull.dimension = 3;
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    hull.vertices.push_back({Numbers::to(p.x()), Numbers::to(p.y()), Numbers::to(p.z())});
  }
  std::map<std::pair<int, int>, int> facet_of_half_edge;
  for (const auto f : mesh.faces()) {
    std::vector<int> loop;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      loop.push_back(static_cast<int>(v.idx()));
    const IntVec& p = hull.vertices[loop[0]];
    IntVec normal = cross(hull.vertices[loop[1]] - p, hull.vertices[loop[2]] - p);
    const int facet = static_cast<int>(hull.facets.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      facet_of_half_edge[{loop[i], loop[(i + 1) % loop.size()]}] = facet;
    }
    const int half_space = add_half_space(hull, std::move(normal), p);
    add_facet(hull, half_space, std::move(loop));
  }
  for (const auto& [ends, facet] : facet_of_half_edge) {
    const auto [from, to] = ends;
    if (from > to) continue;
    hull.edges.push_back(
        {from, to, {facet, facet_of_half_edge.at({to, from})}, hull.vertices[to] - hull.vertices[from]});
  }
  return hull;
}

ConvexHull solid_hull(const std::vector<IntVec>& points) {
  const bool fits = std::all_of(points.begin(), points.end(), [](const IntVec& p) {
    return std::max({mpz_sizeinbase(p.x.get_mpz_t(), 2), mpz_sizeinbase(p.y.get_mpz_t(), 2),
                     mpz_sizeinbase(p.z.get_mpz_t(), 2)}) <= kWideBits;
  });
  return fits ? solid_hull_in<WideIntegers>(points) : solid_hull_in<LazyRationals>(points);
}

}  // namespace

ConvexHull convex_hull(std::vector<IntVec> points) {
  if (points.empty()) throw std::invalid_argument("the hull of no points");
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() == 1) return point_hull(points[0]);
  const IntVec& p = points[0];
  const IntVec along = points[1] - p;
  IntVec normal;
  for (std::size_t i = 2; i < points.size() && normal.is_zero(); ++i) normal = cross(along, points[i] - p);
  if (normal.is_zero()) return segment_hull(points, along);
  for (const IntVec& q : points) {
    if (sgn(dot(normal, q - p)) != 0) return solid_hull(points);
  }
  return polygon_hull(points, normal);
}

}  // namespace graze::oracle
