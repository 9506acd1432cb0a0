// The largest ball that lies in a shape and touches its boundary at a given point: a proof of depth that takes no search.
//
// If A holds a ball of radius r_a that touches it at its contact point, and B one of radius r_b, A - B holds one of
// radius r_a + r_b. If the depth at that contact is no more, no other direction is less deep. A search knows the
// contact only as a possible local minimum, and this proves that it is the least one (round_depth.hpp).
//
// Units: any.   Frame: the shape's own axes, about its centre.
//
//   ellipsoid   c^2 / |M n|: c the least radius, M n the radii times n. For the ball about x(n) - r n and any n',
//               Cauchy and Schwarz give |M n| |M n'| >= sum (m_i^2 - c^2) n_i n'_i + c^2. That is |M n| times the
//               reach of the ball.
//   planes      r (1 - e.n) <= the distance of the point from the plane with normal e.
//   cylinder, cone, around the axis: the ball's centre x - r n, at the distance q from the axis, has q <= a - r k.
//               a and k are from the slant. Squared, C - 2 B r + A r^2 >= 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The data that the inner balls of a shape depend on. `flat`: it has no inside, as a point, a segment or a disc. The
// others have extents above 0 in every direction.
struct SolidCore {
  enum class Kind { flat, box, ellipsoid, cylinder, cone } kind = Kind::flat;
  Vec3<double> half = Vec3<double>::Zero();  // half extents, or radii, or radius, radius, half height
};

// Rounding of what is compared, over the lengths in it.
inline constexpr double kInnerBallRounding = 16 * kUnitRoundoff<double>;

// r <= distance / (1 - e.n). A distance below -noise is that of a point that is not in the shape: no ball at all.
inline double below_plane(double distance, double facing, double noise) {
  if (!(distance >= -noise)) return -kInfinity<double>;  // NaN as well
  const double closing = 1 - facing;
  return closing > kInnerBallRounding ? std::max(distance, 0.0) / closing : kInfinity<double>;
}

// The least r > 0 where a r^2 - 2 b r + c falls below 0, `under` being b^2 - a c. Within `noise` of 0 b is 0. If c, a
// square of `size`, is as much below 0, the point is not in the shape.
inline double falls_below(double a, double b, double c, double under, double noise, double size) {
  if (!(c >= -noise * size)) return -kInfinity<double>;  // NaN as well
  if (b <= noise && a >= -kInnerBallRounding) return kInfinity<double>;
  if (under < 0) return kInfinity<double>;
  const double sum = b + square_root(under);
  return sum > 0 ? std::max(c, 0.0) / sum : kInfinity<double>;
}

// n: unit, the outward normal at x on the boundary. The result is 0 if no ball touches there, as at an edge, and
// -infinity if x is not in the shape. The ball may be out of the shape by kInnerBallRounding of its size. A flat core
// and an ellipsoid do not need x.
inline double inner_ball(const SolidCore& core, const Vec3<double>& x, const Vec3<double>& n) {
  using Kind = SolidCore::Kind;
  const Vec3<double>& h = core.half;
  const double noise = kInnerBallRounding * h.maxCoeff();
  const auto between_planes = [&](int i) {
    return std::min(below_plane(h[i] - x[i], n[i], noise), below_plane(h[i] + x[i], -n[i], noise));
  };
  switch (core.kind) {
    case Kind::flat:
      return 0;
    case Kind::box:
      return std::min({between_planes(0), between_planes(1), between_planes(2)});
    case Kind::ellipsoid: {
      const double least = h.minCoeff(), reach = norm(scaled_by_axis(h, n));
      return reach > 0 ? least * least / reach : 0;
    }
    case Kind::cylinder:
    case Kind::cone:
      break;
  }
  // The distance of the slant from the axis at x, and how much less of it there is for each unit of r.
  const bool is_cone = core.kind == Kind::cone;
  const double slant = hypotenuse(h[0], 2 * h[2]);
  const double across = is_cone ? 2 * h[2] / slant : 1, up = is_cone ? h[0] / slant : 0;
  const double a = is_cone ? (h[2] - x[2]) * up / across : h[0], k = (1 - fl(n[2] * up)) / across;
  const double out_sq = fl(x[0] * x[0]) + fl(x[1] * x[1]), along = fl(x[0] * n[0]) + fl(x[1] * n[1]),
               flat_sq = fl(n[0] * n[0]) + fl(n[1] * n[1]);
  // B^2 - A C = |k x - a n|^2 - |x x n|^2 across the axis. A ball about a point near the axis fills the shape there, and
  // B^2 and A C would cancel.
  const double u = fl(k * x[0]) - fl(a * n[0]), v = fl(k * x[1]) - fl(a * n[1]),
               turned = fl(x[0] * n[1]) - fl(x[1] * n[0]),
               under = (fl(u * u) + fl(v * v)) - fl(turned * turned);
  const double around =
      falls_below(fl(k * k) - flat_sq, fl(a * k) - along, fl(a * a) - out_sq, under, noise, 2 * h.maxCoeff());
  const double ends = is_cone ? below_plane(h[2] + x[2], -n[2], noise) : between_planes(2);
  return std::min({around, k > 0 ? a / k : 0.0, ends});
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
