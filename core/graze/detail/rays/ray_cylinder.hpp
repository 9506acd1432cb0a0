// The cylinder as a solid of rays/ray_clip.hpp: {x^2 + y^2 <= radius^2, |z| <= half_height}.
//
// The line is in it where it is in the infinite cylinder and between the two planes. If these two parts do not meet,
// the line passes a rim at time s, at p_xy outside of the circle. Then n = (p_xy / |p_xy|, beta) with n.w = 0
// separates them.
#pragma once

#include <graze/detail/rays/ray_clip.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct RayCylinder {
  double radius, half_height;

  [[nodiscard]] double reach() const { return radius + half_height; }
  [[nodiscard]] double support(const Triple& n) const {
    return fl(half_height * std::abs(n.z)) + fl(radius * square_root(fl(n.x * n.x) + fl(n.y * n.y)));
  }
  [[nodiscard]] bool contains(const Triple& x, double e) const {
    const double inner = radius - e;
    return inner > 0 && fl(x.x * x.x) + fl(x.y * x.y) <= inner * inner && std::abs(x.z) + e <= half_height;
  }
  [[nodiscard]] Triple nearest(const Triple& x) const {
    const double out = square_root(fl(x.x * x.x) + fl(x.y * x.y)), inward = out > radius ? radius / out : 1.0;
    return {inward * x.x, inward * x.y, greater(lesser(x.z, half_height), -half_height)};
  }
  [[nodiscard]] RayEntry enter(const Triple& p, const Triple& w) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    double enter = -kFar, exit = kFar, side = -kFar;
    if (const double a = fl(w.x * w.x) + fl(w.y * w.y); a > 0) {
      const double across = fl(p.x * w.y) - fl(p.y * w.x), middle = -(fl(p.x * w.x) + fl(p.y * w.y)) / a;
      const double square = fl(a * radius * radius) - fl(across * across);
      if (square < 0) return {true, 0, {p.x + fl(middle * w.x), p.y + fl(middle * w.y), 0}};
      const double half = square_root(square) / a;
      enter = side = middle - half;
      exit = middle + half;
    } else if (fl(p.x * p.x) + fl(p.y * p.y) > radius * radius) {
      return {true, 0, {p.x, p.y, 0}};
    }
    if (w.z != 0) {
      const double cap = std::copysign(half_height, w.z), one = 1 / w.z;
      const double low = (-cap - p.z) * one, high = (cap - p.z) * one;
      if (low > exit) return passes_rim(p, w, low);
      if (high < enter) return passes_rim(p, w, high);
      enter = greater(enter, low);
    } else if (std::abs(p.z) > half_height) {
      return {true, 0, {0, 0, p.z}};
    }
    if (enter > side) return {false, enter, {0, 0, -w.z}};
    return {false, enter, {p.x + fl(enter * w.x), p.y + fl(enter * w.y), 0}};
  }

 private:
  [[nodiscard]] static RayEntry passes_rim(const Triple& p, const Triple& w, double t) {
    const double x = p.x + fl(t * w.x), y = p.y + fl(t * w.y);
    return {true, 0, {x, y, -(fl(x * w.x) + fl(y * w.y)) / w.z}};
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
