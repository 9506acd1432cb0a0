// The lines on a body that a viewer sees: edges of polytopes, rims of cylinders and cones.
#include <Eigen/Geometry>
#include <algorithm>
#include <graze/detail/shapes/quickhull.hpp>
#include <map>
#include <numbers>

#include "reports/drawing/geometry.hpp"

namespace graze::draw {
namespace {

using Lines = std::vector<std::vector<Flat>>;

// Distinct points about their middle, brought to magnitudes below 2: what Quickhull takes. Empty if they are
// one point.
std::vector<Vec3<double>> prepared(const std::vector<Vec>& vertices) {
  Vec low = vertices[0], high = vertices[0];
  for (const Vec& x : vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Vec middle = (low + high) / 2;
  const Real reach = (high - low).maxCoeff() / 2;
  if (!(reach > 0)) return {};
  std::vector<Vec3<double>> out;
  for (const Vec& x : vertices) {
    Vec3<double> p = ((x - middle) / reach).cast<double>();
    for (int i = 0; i < 3; ++i) {
      if (std::abs(p[i]) < detail::exact::kLeastCoordinate) p[i] = 0;
    }
    out.push_back(p);
  }
  return out;
}

// An edge is not drawn if its two faces are coplanar up to rounding.
bool is_flat(const Vec& n, const Vec& m) { return n.cross(m).norm() <= Real(1e-9) && n.dot(m) > 0; }

Lines polytope_edges(const std::vector<Vec>& vertices, const Pose& pose, const View& view) {
  std::vector<Vec3<double>> points = prepared(vertices);
  std::vector<std::uint32_t> distinct;
  const auto less = [&](std::uint32_t i, std::uint32_t j) {
    return std::lexicographical_compare(points[i].begin(), points[i].end(), points[j].begin(),
                                        points[j].end());
  };
  for (std::uint32_t i = 0; i < points.size(); ++i) distinct.push_back(i);
  std::sort(distinct.begin(), distinct.end(), less);
  const auto equal = [&](std::uint32_t i, std::uint32_t j) { return points[i] == points[j]; };
  distinct.erase(std::unique(distinct.begin(), distinct.end(), equal), distinct.end());
  const detail::exact::PointSet set(points);
  if (!set.valid()) return {};

  struct Face {
    Vec normal;
    bool seen;
  };
  const Vec towards = pose.rotation.transpose() * view.towards;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Face> left;  // edge -> the face on its left
  for (const detail::HullTriangle& t : detail::Quickhull(set, distinct).surface()) {
    const auto p = [&](std::size_t i) { return Vec(points[t[i]].cast<Real>()); };
    const Vec n = Vec((p(1) - p(0)).cross(p(2) - p(0))).normalized();
    for (std::size_t e = 0; e < 3; ++e) left[{t[e], t[(e + 1) % 3]}] = {n, n.dot(towards) > 0};
  }
  Lines lines;
  for (const auto& [edge, face] : left) {
    const Face& other = left.at({edge.second, edge.first});
    if (edge.first > edge.second || !(face.seen || other.seen) || is_flat(face.normal, other.normal))
      continue;
    const auto end = [&](std::uint32_t i) {
      return view.project(pose.position + pose.rotation * vertices[i]);
    };
    lines.push_back({end(edge.first), end(edge.second)});
  }
  return lines;
}

// The circle about z at that height.
std::vector<Flat> rim(Real radius, Real z, const Pose& pose, const View& view) {
  constexpr int kParts = 48;
  std::vector<Flat> line;
  for (int k = 0; k <= kParts; ++k) {
    const Real angle = 2 * std::numbers::pi_v<Real> * k / kParts;
    line.push_back(view.project(pose.position +
                                pose.rotation * Vec(radius * std::cos(angle), radius * std::sin(angle), z)));
  }
  return line;
}

}  // namespace

std::vector<std::vector<Flat>> visible_edges(const Shape<double>& shape, const Pose& pose, const View& view) {
  const Real facing = view.towards.dot(pose.rotation.col(2));
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
    const Real z = facing < 0 ? -cylinder->half_height : cylinder->half_height;
    return {rim(cylinder->radius, z, pose, view)};
  }
  if (const auto* cone = std::get_if<Cone<double>>(&shape)) {
    if (facing < 0) return {rim(cone->radius, -cone->half_height, pose, view)};
    return {};
  }
  const std::optional<std::vector<Vec>> vertices = polytope_vertices(shape);
  return vertices && vertices->size() > 3 ? polytope_edges(*vertices, pose, view) : Lines();
}

}  // namespace graze::draw
