// An ellipsoid, a cylinder or a cone in numbers that are exact in any arithmetic: a quadric, cut by two planes.
//
// Inside of it, the sum of k_i x_i^2 is at most L^2, and low <= x_axis <= high. k_i = +-(root[0] root[1])^2 and L is the
// product of the limit.
//
//                k                            L            planes
//   ellipsoid    (r_1 r_2)^2, ...             r_0 r_1 r_2  none
//   cylinder     1, 1, 0                      r            z = -h, h
//   cone         (2 h)^2, (2 h)^2, -r^2       0            z = -2 h, 0, as its apex is the origin
//   flat         a radius of 0 is two planes, z = 0, and the radii left make the quadric. Two are the cylinder r = 0
//
// Frame: the solid's axes, at its centre, a cone's at its apex.
#pragma once

#include <graze/detail/pairs/side.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

template <Scalar S>
[[nodiscard]] bool is_quadric(const Shape<S>& shape) {
  return std::holds_alternative<Ellipsoid<S>>(shape) || std::holds_alternative<Cylinder<S>>(shape) ||
         std::holds_alternative<Cone<S>>(shape);
}

// The largest extent of the solid.
template <Scalar S>
[[nodiscard]] double largest_extent(const Shape<S>& shape) {
  if (const auto* ellipsoid = std::get_if<Ellipsoid<S>>(&shape)) return double(ellipsoid->radii.maxCoeff());
  if (const auto* cylinder = std::get_if<Cylinder<S>>(&shape))
    return double(std::max(cylinder->radius, cylinder->half_height));
  const auto& cone = std::get<Cone<S>>(shape);
  return double(std::max(cone.radius, cone.half_height));
}

struct Quadric {
  std::array<std::array<double, 2>, 3> root{};
  std::array<double, 3> limit = {1, 1, 1};
  int axis = -1;  // of the planes, or none
  double low = 0, high = 0;
  double apex = 0, tilt = 0;  // a cone's half height and radius: its k_2 is negative

  // With every length times a power of two.
  template <Scalar S>
  explicit Quadric(const Shape<S>& shape, double unit = 1) {
    if (const auto* ellipsoid = std::get_if<Ellipsoid<S>>(&shape)) {
      take_ellipsoid(unit * wide(ellipsoid->radii));
    } else if (const auto* cylinder = std::get_if<Cylinder<S>>(&shape)) {
      take_cylinder(2, unit * double(cylinder->radius), unit * double(cylinder->half_height));
    } else {
      const auto& cone = std::get<Cone<S>>(shape);
      take_cone(unit * double(cone.radius), unit * double(cone.half_height));
    }
  }
  [[nodiscard]] double sign(std::size_t i) const { return i == 2 && apex > 0 ? -1 : 1; }

 private:
  void take_ellipsoid(const Vec3<double>& r) {
    std::array<std::size_t, 3> full{};
    std::size_t fulls = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (r[int(i)] > 0) {
        limit[fulls] = r[int(i)];
        full[fulls++] = i;
      } else {
        axis = int(i);
      }
    }
    if (fulls == 1) return take_cylinder(int(full[0]), 0, r[int(full[0])]);
    if (fulls == 0) {
      root = {{{1, 1}, {1, 1}, {1, 1}}};
      limit[0] = 0;
      axis = -1;
      return;
    }
    // 1 stands for a radius that is left out.
    for (std::size_t i = 0; i < fulls; ++i) root[full[i]] = {limit[(i + 1) % 3], limit[(i + 2) % 3]};
  }
  void take_cylinder(int along, double radius, double half_height) {
    axis = along;
    limit = {radius, 1, 1};
    for (int i = 0; i < 3; ++i)
      if (i != along) root[std::size_t(i)] = {1, 1};
    high = half_height;
    low = -half_height;
  }
  void take_cone(double radius, double half_height) {
    if (!(half_height > 0)) return take_cylinder(2, radius, 0);
    axis = 2;
    limit[0] = 0;
    root = {{{2 * half_height, 1}, {2 * half_height, 1}, {radius, 1}}};
    low = -2 * half_height;
    apex = half_height;
    tilt = radius;
  }
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
