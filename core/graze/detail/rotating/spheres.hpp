// Casts the spheres about the pivots that hold the bodies at every time: a linear cast of two balls.
//
// Internal lengths. Contact of the bodies needs |c + v t| <= R, c = c_B - c_A, R both reaches, radii and the target
// distance. No rotation can change that. [The lecture's idea for MPR: a bounding sphere's linear cast as a first
// guess, here as a proved lower bound.]
//
// Rounding: c is within u |c| and pivots_error() of itself. The least |c + v t| is computed as the part of c across
// v, within 8 u |c|. R is raised by 32 u (|c| + R) and pivots_error(), so the half chord sqrt(R^2 - across^2) only
// grows.
#pragma once

#include <graze/detail/rotating/moving_pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct SphereCast {
  bool meet = true;
  double begin = 0;  // not later than the first contact
};

// The time at which a point that moves as c + v t is within R of the origin. Any unit of length, R raised as above.
inline SphereCast cast_spheres(const Vec3<double>& c, const Vec3<double>& v, double R, double t_end) {
  constexpr double u = kUnitRoundoff<double>;
  const double apart = norm(c);
  SphereCast out;
  if (apart <= R) return out;
  const double along = dot(c, v), speed_sq = squared_norm(v);
  out.meet = false;
  if (!(along < 0 && speed_sq > 0)) return out;
  const Vec3<double> across = c - v * (along / speed_sq);
  const double half_sq = fl(R * R) - squared_norm(across);
  if (!(half_sq >= 0)) return out;
  const double begin =
      (-along / square_root(speed_sq) - square_root(half_sq)) / square_root(speed_sq) * (1 - 32 * u);
  if (begin > t_end) return out;
  out.meet = true;
  out.begin = std::max(begin, 0.0);
  return out;
}

// `more`: a length that R is raised by.
inline SphereCast cast_spheres(const MovingPair& pair, double t_end, double more) {
  constexpr double u = kUnitRoundoff<double>;
  const Vec3<double> c = pair.pivots();
  const double R =
      fl((pair.mobility_a().reach + pair.mobility_b().reach + pair.radius() + more) * (1 + 32 * u)) +
      fl(32 * u * norm(c)) + 2 * pair.pivots_error();
  return cast_spheres(c, pair.velocity(), R, t_end);
}

// The same for bodies as given, in the caller's unit, by slightly larger spheres, before anything is prepared. If
// these never meet, those above do not. Combinators, whose bounds take a walk, are left to those above.
//
// The pivot is within 16 u of the sum of its summands' lengths: 9 u for a rotation's entry, 3 u for a sum of three,
// and one sum. The core is in the ball about the middle of its bounds with their half diagonal, each within 8 u of
// the lengths it is computed from. `more`, in units in the last place: the tier's noise. The pair's scale is at most
// the distance of the boxes' centres and a diagonal (cso.hpp).
struct OuterSphere {
  Vec3<double> pivot = Vec3<double>::Zero();  // world
  double reach = 0;                           // about it, the ball included
  double lengths = 0;                         // of the pivot's summands, at least

  // Error bound of the distance of the body's points from the pivot above, including the rounding of both.
  [[nodiscard]] double bound() const {
    constexpr double u = kUnitRoundoff<double>;
    return fl(reach * (1 + 32 * u)) + fl(64 * u * lengths);
  }
};
template <Scalar S>
OuterSphere outer_sphere(const RotatingBody<S>& moving) {
  const Bounds bounds = detail::bounds(moving.body.shape);
  const Vec3<double> middle = bounds.center + bounds.middle;
  const bool turns = moving.rotation != Vec3<S>::Zero();
  const Vec3<double> pivot = turns ? wide(moving.pivot) : middle, position = wide(moving.body.position);
  OuterSphere out;
  out.pivot = position;
  if (pivot != Vec3<double>::Zero()) out.pivot += rotation_matrix(as_double(moving.body.orientation)) * pivot;
  out.reach = norm(middle - pivot) + norm(bounds.half) + bounds.radius;
  out.lengths = norm_1(position) + norm_1(pivot) + norm_1(middle);
  return out;
}
template <Scalar S>
bool outer_spheres_never_meet(const RotatingBody<S>& a, const RotatingBody<S>& b, double target, double t_end,
                              double more) {
  if (is_combined(a.body.shape) || is_combined(b.body.shape)) return false;
  constexpr double u = kUnitRoundoff<double>;
  const OuterSphere s_a = outer_sphere(a), s_b = outer_sphere(b);
  const Vec3<double> c = s_b.pivot - s_a.pivot, v = wide(b.body.displacement) - wide(a.body.displacement);
  // Not below the scale: of boxes' diagonals, and of their centres' distance.
  const double sizes = s_a.reach + s_b.reach, scale = 2 * sizes + norm(c);
  const double R = s_a.bound() + s_b.bound() + fl(target * (1 + 32 * u)) + fl((32 + 2 * more) * u * scale);
  return !cast_spheres(c, v, R, t_end).meet;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
