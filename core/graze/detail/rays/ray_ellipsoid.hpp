// The ellipsoid as a solid of rays/ray_clip.hpp: {sum (x_i / radii_i)^2 <= 1}, no radius being 0.
//
// Divided by the radii it is the unit ball, and a normal n of the ball is n_i / radii_i there.
#pragma once

#include <graze/detail/rays/ray_clip.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct RayEllipsoid {
  explicit RayEllipsoid(const Triple& r) : radii(r), per{1 / r.x, 1 / r.y, 1 / r.z} {}
  Triple radii, per;

  [[nodiscard]] double reach() const { return largest(radii); }
  [[nodiscard]] double support(const Triple& n) const {
    const Triple scaled = times(radii, n);
    return square_root(dot(scaled, scaled));
  }
  [[nodiscard]] bool contains(const Triple& x, double e) const {
    const Triple y = times(per, x);
    const double inner = 1 - fl(e * largest(per));
    return inner > 0 && dot(y, y) <= inner * inner;
  }
  [[nodiscard]] Triple nearest(const Triple& x) const {
    const Triple y = times(per, x);
    const double out = square_root(dot(y, y));
    return out > 1 ? (1 / out) * x : x;
  }
  [[nodiscard]] RayEntry enter(const Triple& p, const Triple& w) const {
    const Triple q = times(per, p), v = times(per, w);
    const double vv = dot(v, v), t0 = -dot(q, v) / vv;
    const Triple near = q + t0 * v;
    const double square = 1 - dot(near, near);
    if (square < 0) return {true, 0, times(per, near)};
    const double t = t0 - square_root(square / vv);
    return {false, t, times(per, q + t * v)};
  }

 private:
  [[nodiscard]] static Triple times(const Triple& a, const Triple& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
