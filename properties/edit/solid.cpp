#include "properties/edit/solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "properties/edit/shape.hpp"

namespace graze::law {

namespace {

constexpr double kLeastHeight = 1e-6;

// For a hull: from a vertex to the farthest, from that edge to the farthest, from that plane to the farthest.
bool has_height(const Hull<double>& hull) {
  if (hull.size() < 4) return false;
  const Vec3<double>& first = hull.vertex(0);
  Vec3<double> edge = Vec3<double>::Zero(), normal = Vec3<double>::Zero();
  for (const Vec3<double>& x : hull.vertices()) {
    if ((x - first).norm() > edge.norm()) edge = x - first;
  }
  for (const Vec3<double>& x : hull.vertices()) {
    const Vec3<double> across = edge.stableNormalized().cross(x - first);
    if (across.norm() > normal.norm()) normal = across;
  }
  const double size = edge.norm();
  if (!(normal.norm() > kLeastHeight * size)) return false;
  normal.stableNormalize();
  return std::any_of(hull.vertices().begin(), hull.vertices().end(), [&](const Vec3<double>& x) {
    return std::abs(normal.dot(x - first)) > kLeastHeight * size;
  });
}

}  // namespace

bool is_solid(const Shape<double>& shape) {
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) return sphere->radius > 0;
  if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) return capsule->radius > 0;
  if (const auto* box = std::get_if<Box<double>>(&shape)) return box->half_extents.minCoeff() > 0;
  if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) return ellipsoid->radii.minCoeff() > 0;
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape))
    return cylinder->radius > 0 && cylinder->half_height > 0;
  if (const auto* cone = std::get_if<Cone<double>>(&shape)) return cone->radius > 0 && cone->half_height > 0;
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) return has_height(*hull);
  if (const auto* rounded = std::get_if<Rounded<double>>(&shape); rounded != nullptr && rounded->radius > 0)
    return true;
  const std::vector<SharedShape<double>> parts = parts_of(shape);
  return std::any_of(parts.begin(), parts.end(),
                     [](const SharedShape<double>& part) { return part && is_solid(part->shape); });
}

}  // namespace graze::law
