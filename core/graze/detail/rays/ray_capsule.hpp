// Sphere and capsule as the solids of rays/ray_clip.hpp: within `radius` of the segment from -half_height to +half_height on z.
//
// The line's part in the infinite cylinder begins where  |p_xy + t w_xy| = radius. If that is beside the segment, it is
// the entry. Else the line can only enter through the ball at that end.
#pragma once

#include <graze/detail/rays/ray_clip.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct RayCapsule {
  double radius, half_height;

  [[nodiscard]] double reach() const { return radius + half_height; }
  [[nodiscard]] double support(const Triple& n) const {
    return fl(half_height * std::abs(n.z)) + fl(radius * square_root(dot(n, n)));
  }
  [[nodiscard]] bool contains(const Triple& x, double e) const {
    const Triple q = from_core(x);
    const double inner = radius - e;
    return inner > 0 && dot(q, q) <= inner * inner;
  }
  [[nodiscard]] Triple nearest(const Triple& x) const {
    const Triple q = from_core(x);
    const double length = square_root(dot(q, q));
    return length > radius ? (x - q) + (radius / length) * q : x;
  }
  [[nodiscard]] RayEntry enter(const Triple& p, const Triple& w) const {
    if (!(half_height > 0)) return enter_ball(p, w, 0);
    const double a = fl(w.x * w.x) + fl(w.y * w.y);
    if (!(a > 0)) {
      if (fl(p.x * p.x) + fl(p.y * p.y) > radius * radius) return {true, 0, {p.x, p.y, 0}};
      return enter_ball(p, w, std::copysign(half_height, -w.z));
    }
    const double across = fl(p.x * w.y) - fl(p.y * w.x), middle = -(fl(p.x * w.x) + fl(p.y * w.y)) / a;
    const double square = fl(a * radius * radius) - fl(across * across);
    if (square < 0) return {true, 0, {p.x + fl(middle * w.x), p.y + fl(middle * w.y), 0}};
    const double t = middle - square_root(square) / a, z = p.z + fl(t * w.z);
    if (std::abs(z) <= half_height) return {false, t, {p.x + fl(t * w.x), p.y + fl(t * w.y), 0}};
    return enter_ball(p, w, std::copysign(half_height, z));
  }

 private:
  // From the nearest point of the segment.
  [[nodiscard]] Triple from_core(const Triple& x) const {
    return {x.x, x.y, x.z - greater(lesser(x.z, half_height), -half_height)};
  }
  [[nodiscard]] RayEntry enter_ball(const Triple& p, const Triple& w, double z) const {
    const Triple q{p.x, p.y, p.z - z};
    const double ww = dot(w, w), t0 = -dot(q, w) / ww;
    const Triple near = q + t0 * w;
    const double square = fl(radius * radius) - dot(near, near);
    if (square < 0) return {true, 0, near};
    const double t = t0 - square_root(square / ww);
    return {false, t, q + t * w};
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
