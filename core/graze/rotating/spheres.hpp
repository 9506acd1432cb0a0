// Spheres about the pivots that hold the bodies at every time: a linear cast of two balls.
//
// Internal lengths. Contact of the bodies needs |c + v t| <= R, c = c_B - c_A, R both reaches, radii and the
// target distance: no turn can change that. [The lecture's idea for MPR: a bounding sphere's linear cast as a
// first guess, here as a proved lower bound.]
// Rounding: c is within u |c| and pivots_error() of itself; the least |c + v t| is computed as the part of c
// across v, within 8 u |c|; R is raised by 32 u (|c| + R) and pivots_error(), so the half chord
// sqrt(R^2 - across^2) only grows.
#pragma once

#include <graze/rotating/moving_pair.hpp>

namespace graze::inline GRAZE_LINKAGE::detail {

struct SphereCast {
  bool meet = true;
  double begin = 0;  // not later than the first contact
};

// `more`: a length that R is raised by.
inline SphereCast cast_spheres(const MovingPair& pair, double t_end, double more) {
  constexpr double u = kUnitRoundoff<double>;
  const Vec3<double> c = pair.pivots(), v = pair.velocity();
  const double apart = c.norm();
  const double R = (pair.mobility_a().reach + pair.mobility_b().reach + pair.radius() + more) * (1 + 32 * u) +
                   32 * u * apart + 2 * pair.pivots_error();
  SphereCast out;
  if (apart <= R) return out;
  const double along = c.dot(v), speed_sq = v.squaredNorm();
  out.meet = false;
  if (!(along < 0 && speed_sq > 0)) return out;
  const Vec3<double> across = c - v * (along / speed_sq);
  const double half_sq = R * R - across.squaredNorm();
  if (!(half_sq >= 0)) return out;
  const double begin =
      (-along / std::sqrt(speed_sq) - std::sqrt(half_sq)) / std::sqrt(speed_sq) * (1 - 32 * u);
  if (begin > t_end) return out;
  out.meet = true;
  out.begin = std::max(begin, 0.0);
  return out;
}

}  // namespace graze::inline GRAZE_LINKAGE::detail
