// The cone as a solid of rays/ray_clip.hpp: apex (0, 0, half_height), disk of `radius` at z = -half_height, both above 0.
//
// q = x - apex, k = radius / (2 half_height). The double cone is f(q) = |q_xy|^2 - k^2 q_z^2 <= 0, and the solid is its
// lower half above the base. Along the line f = A t^2 + 2 B t + C, from the point that is nearest to the apex, so that
// coordinates shrink as the apex is passed nearer by. B^2 - A C = k^2 (Y_x^2 + Y_y^2) - X^2, where X and Y are the
// components of q x w: nothing cancels but what is small.
#pragma once

#include <graze/detail/rays/ray_clip.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct RayCone {
  RayCone(double r, double h) : radius(r), half_height(h), slope(r / (2 * h)) {}
  double radius, half_height, slope;

  [[nodiscard]] double reach() const { return radius + half_height; }
  [[nodiscard]] double support(const Triple& n) const {
    return greater(half_height * n.z,
                   fl(radius * square_root(fl(n.x * n.x) + fl(n.y * n.y))) - fl(half_height * n.z));
  }
  [[nodiscard]] bool contains(const Triple& x, double e) const {
    const double inward = fl(slope * (half_height - x.z)) - square_root(fl(x.x * x.x) + fl(x.y * x.y));
    return inward >= e * square_root(1 + fl(slope * slope)) && x.z - e >= -half_height;
  }
  [[nodiscard]] Triple nearest(const Triple& x) const {
    const double z = greater(lesser(x.z, half_height), -half_height), most = slope * (half_height - z);
    const double out = square_root(fl(x.x * x.x) + fl(x.y * x.y)), inward = out > most ? most / out : 1.0;
    return {inward * x.x, inward * x.y, z};
  }
  [[nodiscard]] RayEntry enter(const Triple& p, const Triple& w) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const Triple from_apex{p.x, p.y, p.z - half_height};
    const double t0 = -dot(from_apex, w) / dot(w, w), kk = slope * slope;
    const Triple q = from_apex + t0 * w;
    const double across = fl(q.x * w.y) - fl(q.y * w.x), y0 = fl(w.z * q.x) - fl(q.z * w.x),
                 y1 = fl(w.z * q.y) - fl(q.z * w.y);
    const double a = fl(w.x * w.x) + fl(w.y * w.y), A = a - fl(kk * w.z * w.z);
    const double square = fl(kk * (fl(y0 * y0) + fl(y1 * y1))) - fl(across * across);
    if (square < 0) return passes_side(w, a, A, across);
    const double B = (fl(q.x * w.x) + fl(q.y * w.y)) - fl(kk * q.z * w.z),
                 C = (fl(q.x * q.x) + fl(q.y * q.y)) - fl(kk * q.z * q.z);
    const double sum = -(B + std::copysign(square_root(square), B));
    const double first = C / sum, second = sum / A;
    double side = lesser(first, second), exit = greater(first, second);
    if (A < 0) {
      // One part in either half. The lower one's is where the line goes down.
      side = w.z < 0 ? exit : -kFar;
      exit = w.z < 0 ? kFar : lesser(first, second);
    } else if (!(q.z + fl(0.5 * (side + exit) * w.z) <= 0)) {
      return passes_above(w, a, A, across);
    }
    double enter = side;
    if (w.z != 0) {
      const double base = (-2 * half_height - q.z) / w.z;
      if (w.z > 0 ? base > exit : base < side) return passes_rim(q, w, base);
      if (w.z > 0) enter = greater(enter, base);
    } else if (q.z < -2 * half_height) {
      return {true, 0, {0, 0, -1}};
    }
    if (enter > side) return {false, t0 + enter, {0, 0, -1}};
    const double x = q.x + fl(enter * w.x), y = q.y + fl(enter * w.y);
    return {false, t0 + enter, {x, y, slope * square_root(fl(x * x) + fl(y * y))}};
  }

 private:
  // The tangent plane that holds the line's direction, on the side where the line passes.
  [[nodiscard]] RayEntry passes_side(const Triple& w, double a, double A, double across) const {
    if (!(A >= 0)) return {true, 0, {0, 0, 0}};
    const double along = -slope * w.z / a, beside = std::copysign(square_root(A), across) / a;
    return {true, 0, {fl(along * w.x) + fl(beside * w.y), fl(along * w.y) - fl(beside * w.x), slope}};
  }
  // A level line above the apex, or one that meets the upper half alone.
  [[nodiscard]] RayEntry passes_above(const Triple& w, double a, double A, double across) const {
    if (w.z == 0) return {true, 0, {0, 0, 1}};
    return passes_side(w, a, A, across);
  }
  [[nodiscard]] static RayEntry passes_rim(const Triple& q, const Triple& w, double t) {
    const double x = q.x + fl(t * w.x), y = q.y + fl(t * w.y);
    return {true, 0, {x, y, -(fl(x * w.x) + fl(y * w.y)) / w.z}};
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
