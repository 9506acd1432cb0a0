#include "reports/pages/mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "oracles/polytope/integer_scene.hpp"

namespace graze::show {
namespace {

using draw::Mat;
using draw::Pose;
using draw::Real;
using draw::Vec;
using Support = std::function<Vec(const Vec&)>;

constexpr int kLeastRings = 4, kMostRings = 20, kRingDirections = 12;
// The grid of a difference. Its contact is magnified less than the bodies', so the last ring is at 0.1
// degrees.
constexpr Grid kOfDifference = {28, 14, 8};
constexpr Real kFirstRing = 0.3L;  // radians
// With more differences than these, the hull is not formed. The difference is then sampled as a curved shape
// is.
constexpr std::size_t kMostDifferences = 4096;
// Planes that differ by less are one face, to the eye: of polytopes only what rounding makes of one face.
constexpr double kSmoothAngle = 0.6, kFlatAngle = 1e-7;  // radians

double unit_dot(const oracle::IntVec& l, const oracle::IntVec& r) {
  // Normals of small faces have large integers: brought to doubles by their exponents first.
  const auto to_unit = [](const oracle::IntVec& n) {
    long most = 0;
    std::array<double, 3> part{};
    std::array<long, 3> exponent{};
    const mpz_class* const x[] = {&n.x, &n.y, &n.z};
    for (std::size_t i = 0; i < 3; ++i) {
      part[i] = mpz_get_d_2exp(&exponent[i], x[i]->get_mpz_t());
      if (part[i] != 0) most = std::max(most, exponent[i]);
    }
    Vec3<double> out;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      out[i] = part[k] == 0 ? 0 : std::ldexp(part[k], static_cast<int>(std::max(exponent[k] - most, -2000L)));
    }
    return Vec3<double>(out.normalized());
  };
  return to_unit(l).dot(to_unit(r));
}

// The exact hull of points that are doubles.
Mesh hull_mesh(const std::vector<Vec3<double>>& points, bool curved) {
  oracle::Integer unit = 1;
  std::vector<oracle::RationalPoint> exact;
  exact.reserve(points.size());
  for (const Vec3<double>& point : points) {
    exact.push_back(oracle::rational(point));
    oracle::fold_denominators(unit, exact.back());
  }
  std::vector<oracle::IntVec> integers;
  integers.reserve(points.size());
  for (const oracle::RationalPoint& point : exact) integers.push_back(oracle::times(unit, point));
  const oracle::ConvexHull hull = oracle::convex_hull(std::move(integers));
  Mesh mesh{.curved = curved};
  for (const oracle::IntVec& x : hull.vertices) {
    mesh.vertices.emplace_back(oracle::nearest_double(oracle::fraction(x.x, unit)),
                               oracle::nearest_double(oracle::fraction(x.y, unit)),
                               oracle::nearest_double(oracle::fraction(x.z, unit)));
  }
  for (const oracle::HullFacet& facet : hull.facets) {
    for (std::size_t i = 1; i + 1 < facet.loop.size(); ++i)
      mesh.triangles.push_back({facet.loop[0], facet.loop[i], facet.loop[i + 1]});
  }
  const double least = std::cos(curved ? kSmoothAngle : kFlatAngle);
  for (const oracle::HullEdge& edge : hull.edges) {
    bool seen = hull.dimension < 3;
    if (!seen) {
      const auto normal = [&](int facet) -> const oracle::IntVec& {
        return hull
            .half_spaces[static_cast<std::size_t>(hull.facets[static_cast<std::size_t>(facet)].half_space)]
            .normal;
      };
      seen = unit_dot(normal(edge.facets[0]), normal(edge.facets[1])) < least;
    }
    if (seen) mesh.edges.push_back({edge.from, edge.to});
  }
  return mesh;
}

// Points of a curved set, by its support mapping.
std::vector<Vec3<double>> sampled(const Support& support, const Vec& towards, Grid grid) {
  Vec half;
  for (int i = 0; i < 3; ++i) half[i] = (support(Vec::Unit(i))[i] - support(Vec(-Vec::Unit(i)))[i]) / 2;
  const Real most = half.maxCoeff();
  std::vector<Vec3<double>> points;
  // To six digits of the extent: the grid is a sample anyway, and short numbers make short pages.
  const Real digits = most > 0 ? std::pow(Real(10), 6 - std::ceil(std::log10(most))) : Real(1);
  const auto add_coarse = [&](const Vec& n) {
    const Vec x = support(n);
    Vec3<double> short_one;
    for (int i = 0; i < 3; ++i) short_one[i] = static_cast<double>(std::round(x[i] * digits) / digits);
    points.push_back(short_one);
  };
  const auto add_both = [&](const Vec& n) {
    add_coarse(n);
    // For a long, thin set: the direction whose point lies as far along the length as n.
    if (most <= 0) return;
    const Vec scaled(n[0] / std::max(half[0], most / 1000), n[1] / std::max(half[1], most / 1000),
                     n[2] / std::max(half[2], most / 1000));
    if (half.minCoeff() < Real(0.7) * most) add_coarse(scaled);
  };
  for (int j = 0; j <= grid.parallels; ++j) {
    const Real latitude = std::numbers::pi_v<Real> * (Real(j) / grid.parallels - Real(0.5));
    const int around = j == 0 || j == grid.parallels ? 1 : grid.meridians;
    for (int i = 0; i < around; ++i) {
      const Real longitude = 2 * std::numbers::pi_v<Real> * i / grid.meridians;
      const Real across = around == 1 ? 0 : std::cos(latitude);
      add_both(Vec(across * std::cos(longitude), across * std::sin(longitude), std::sin(latitude)));
    }
  }
  if (towards.norm() > 0) {
    const Vec n = towards.normalized(), first = n.unitOrthogonal(), second = n.cross(first);
    points.emplace_back(support(n).cast<double>());
    Real angle = kFirstRing;
    for (int k = 0; k < grid.rings; ++k, angle /= 2) {
      for (int i = 0; i < kRingDirections; ++i) {
        const Real turn = 2 * std::numbers::pi_v<Real> * (i + Real(k % 2) / 2) / kRingDirections;
        const Vec side = std::cos(turn) * first + std::sin(turn) * second;
        points.emplace_back(support(Vec(std::cos(angle) * n + std::sin(angle) * side)).cast<double>());
      }
    }
  }
  return points;
}

}  // namespace

int rings_for(double length, double size) {
  // Within the last ring, at the angle a, the mesh is short by a^2/2 of a radius, of half the size at most.
  int rings = 1;
  for (Real angle = kFirstRing; rings < kMostRings && angle * angle / 4 * Real(size) >= Real(length);
       angle /= 2)
    ++rings;
  return std::max(rings, kLeastRings);
}

Mesh mesh_of(const Shape<double>& shape, const Vec& towards, Grid grid) {
  if (const std::optional<std::vector<Vec>> vertices = draw::polytope_vertices(shape)) {
    std::vector<Vec3<double>> points;
    for (const Vec& vertex : *vertices) points.emplace_back(vertex.cast<double>());
    return hull_mesh(points, false);
  }
  return hull_mesh(sampled([&](const Vec& n) { return draw::support_point(shape, n); }, towards, grid), true);
}

Mesh mesh_of_difference(const Shape<double>& a, const Pose& at_a, const Shape<double>& b, const Pose& at_b,
                        double margin, const Vec& normal) {
  if (margin == 0) {
    const auto of_a = draw::polytope_vertices(a), of_b = draw::polytope_vertices(b);
    if (of_a && of_b && of_a->size() * of_b->size() <= kMostDifferences) {
      std::vector<Vec3<double>> points;
      for (const Vec& x : *of_a) {
        for (const Vec& y : *of_b) {
          const Vec difference = (at_a.rotation * x - at_b.rotation * y) + (at_a.position - at_b.position);
          points.emplace_back(difference.cast<double>());
        }
      }
      return hull_mesh(points, false);
    }
  }
  const auto support = [&](const Vec& n) {
    const Vec in_a = draw::support_point(a, at_a.rotation.transpose() * n);
    const Vec in_b = draw::support_point(b, at_b.rotation.transpose() * Vec(-n));
    return Vec(at_a.rotation * in_a - at_b.rotation * in_b + (at_a.position - at_b.position) +
               Real(margin) * n.normalized());
  };
  return hull_mesh(sampled(support, normal, kOfDifference), true);
}

}  // namespace graze::show
