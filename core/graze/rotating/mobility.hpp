// How fast a turning body's points move along an axis: the bounds that every safe step rests on.
//
// Lengths in the unit of the points given, angles in radians, t in units of the step. n is a unit vector in
// world axes, w the rotation vector, x(t) = R(w t) x_0 a point about the pivot. Then
//   |d/dt n.x|      = |(n x w) . x| <= |n x w| rho            rho: largest distance from the axis of rotation
//   |d^2/dt^2 n.x|  = |n_perp . x_perp| |w|^2 <= |w| |n x w| rho      (n_perp, x_perp: across w).
// The ball of a sphere, a capsule or a rounded shape turns with no effect, so rho is the core's alone: a ball
// about its centre and a capsule about its axis do not move.
//
// A solid of revolution is the same set whatever its turn about its own axis a, so its points may be followed
// in a frame that turns by w less its part along a(t), of length |w x a|, constant. About the foot c of the
// pivot on the axis, with s = a.w and r the largest |x_0 - c|:
//   velocity <= |n x w| |c_perp| + |w x a| r,     acceleration <= |w| |n x w| |c_perp| + |w x a|(|w x a| +
//   |s|) r.
// The lesser of both bounds counts.   [Mirtich 1996, 2.3: the first bound, with |w| rho for |n x w| rho.]
#pragma once

#include <graze/rotating/rotating_body.hpp>
#include <graze/side.hpp>

namespace graze::detail {

struct Mobility {
  Vec3<double> w = Vec3<double>::Zero();
  double rate = 0;   // |w|
  double rho = 0;    // largest distance of the core's points from the axis of rotation
  double reach = 0;  // and from the pivot
  // Whatever the turn, the core is in the cylinder of radius rho about the axis of rotation, between these
  // two heights along w from the pivot.
  double low = 0, high = 0;
  bool revolves = false;      // a solid of revolution: the second kind of bound exists
  double tilt_rate = 0;       // |w x a|
  double own_rate = 0;        // |a.w|
  double center_rho = 0;      // |c_perp|
  double revolved_reach = 0;  // r

  [[nodiscard]] bool turns() const { return rate > 0; }
  // Of the turn alone, the motion that all points share not counted.
  [[nodiscard]] double speed(const Vec3<double>& n) const {
    if (!turns()) return 0;
    const double across = n.cross(w).norm(), plain = across * rho;
    return revolves ? std::min(plain, across * center_rho + tilt_rate * revolved_reach) : plain;
  }
  [[nodiscard]] double acceleration(const Vec3<double>& n) const {
    if (!turns()) return 0;
    const double across = rate * n.cross(w).norm(), plain = across * rho;
    if (!revolves) return plain;
    return std::min(plain, across * center_rho + tilt_rate * (tilt_rate + own_rate) * revolved_reach);
  }
  // How far the body as a set gets from where it was, at most, within time t.
  [[nodiscard]] double sway(double t) const {
    if (!turns()) return 0;
    const double chord = std::min(rate * t, 2.0);
    if (!revolves) return chord * rho;
    return chord * std::min(rho, center_rho + tilt_rate / rate * revolved_reach);
  }
  // Of any point of the body as a set, along any n.
  [[nodiscard]] double top_acceleration() const {
    if (!turns()) return 0;
    const double plain = rate * rate * rho;
    return revolves ? std::min(plain,
                               rate * rate * center_rho + tilt_rate * (tilt_rate + own_rate) * revolved_reach)
                    : plain;
  }
  [[nodiscard]] double top_speed() const {
    if (!turns()) return 0;
    return revolves ? std::min(rate * rho, rate * center_rho + tilt_rate * revolved_reach) : rate * rho;
  }
};

// The axis of revolution of a shape, own frame: 0, 1, 2, or -1 where there is none.
template <Scalar S>
int axis_of_revolution(const Shape<S>& shape) {
  if (std::holds_alternative<Cylinder<S>>(shape) || std::holds_alternative<Cone<S>>(shape)) return 2;
  if (const auto* e = std::get_if<Ellipsoid<S>>(&shape)) {
    for (const int i : {2, 1, 0}) {
      if (e->radii[(i + 1) % 3] == e->radii[(i + 2) % 3]) return i;
    }
  }
  return -1;
}

// Every axis is one of revolution.
template <Scalar S>
bool is_ball(const Shape<S>& shape) {
  const auto* e = std::get_if<Ellipsoid<S>>(&shape);
  return e && e->radii[0] == e->radii[1] && e->radii[1] == e->radii[2];
}

// Is w exactly along the body's own axis? Without an orientation, or with one that permutes the axes, that
// can be read off the numbers.
template <Scalar S>
bool is_along_own_axis(const RotatingBody<S>& moving, int own) {
  const Quaternion<double> q = as_double(moving.body.orientation);
  if (!permutes_axes(q)) return false;
  const Vec3<double> a = rotation_matrix(q).col(own).array().round();
  return a.cross(wide(moving.rotation)) == Vec3<double>::Zero();
}

// Is the body's point x exactly on the axis of rotation? As above.
template <Scalar S>
bool is_on_axis(const RotatingBody<S>& moving, const Vec3<double>& pivot, const Vec3<double>& x) {
  if (x == pivot) return true;
  const Quaternion<double> q = as_double(moving.body.orientation);
  if (!permutes_axes(q)) return false;
  const Vec3<double> w = rotation_matrix(q).array().round().matrix().transpose() * wide(moving.rotation);
  Vec3<double> arm;
  for (int i = 0; i < 3; ++i) {
    const TwoDoubles difference = two_sum(x[i], -pivot[i]);
    if (difference.lo != 0) return false;
    arm[i] = difference.hi;
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const TwoDoubles one = two_product(w[j], arm[k]), other = two_product(w[k], arm[j]);
    if (one.hi != other.hi || one.lo != other.lo) return false;
  }
  return true;
}

// Calls visit(x) for points in the body's own frame whose hull holds the core: its vertices, or the corners
// of its bounds.
template <Scalar S, class Visit>
void for_each_outer_point(const Shape<S>& shape, const Bounds& bounds, const Visit& visit) {
  if (const auto* hull = std::get_if<Hull<S>>(&shape)) {
    const double unit = power_of_two(hull->exponent());
    for (std::uint32_t k = 0; k < hull->size(); ++k) {
      visit(Vec3<double>(bounds.center + unit * hull_vertex<double>(*hull, k)));
    }
  } else if (const auto* segment = std::get_if<Segment<S>>(&shape)) {
    visit(wide(segment->a));
    visit(wide(segment->b));
  } else if (const auto* triangle = std::get_if<Triangle<S>>(&shape)) {
    visit(wide(triangle->a));
    visit(wide(triangle->b));
    visit(wide(triangle->c));
  } else {
    for (std::uint32_t k = 0; k < 8; ++k) {
      visit(Vec3<double>(bounds.center + bounds.middle + box_vertex(bounds.half, k)));
    }
  }
}

inline constexpr double kMobilityRounding = 8;

// unit: what one world length is. Errors: a rotated vector is within 0.6 sqrt(3) u and a product's 3 u, a
// cross product adds 3 u, so each number is raised by kMobilityRounding u of the lengths in it. pivot: the
// centre of the rotation, or any point for a body that does not turn.
template <Scalar S>
Mobility mobility(const RotatingBody<S>& moving, const Vec3<double>& pivot, const Bounds& bounds,
                  double unit) {
  Mobility out;
  out.w = wide(moving.rotation);
  out.rate = out.w.norm();
  if (!out.turns()) {
    const Vec3<double> middle = bounds.center + bounds.middle;
    out.reach = unit * (bounds.half + (middle - pivot).cwiseAbs()).norm() *
                (1 + kMobilityRounding * kUnitRoundoff<double>);
    return out;
  }
  const double raise = 1 + kMobilityRounding * kUnitRoundoff<double>;
  out.rate *= raise;
  const Mat3<double> turn = moving.body.orientation.is_identity()
                                ? Mat3<double>(Mat3<double>::Identity())
                                : accurate_rotation_matrix(as_double(moving.body.orientation));
  const Vec3<double> axis = graze::unit(out.w);
  out.low = kInfinity<double>;
  out.high = -kInfinity<double>;
  for_each_outer_point(moving.body.shape, bounds, [&](const Vec3<double>& x) {
    const Vec3<double> arm = turn * (x - pivot);
    const double slack =
        kMobilityRounding * kUnitRoundoff<double> * (x.cwiseAbs().sum() + pivot.cwiseAbs().sum());
    out.rho = std::max(out.rho, is_on_axis(moving, pivot, x) ? 0.0 : unit * (axis.cross(arm).norm() + slack));
    out.reach = std::max(out.reach, x == pivot ? 0.0 : unit * (arm.norm() + slack));
    out.low = std::min(out.low, unit * (axis.dot(arm) - slack));
    out.high = std::max(out.high, unit * (axis.dot(arm) + slack));
  });
  if (is_ball(moving.body.shape)) {
    // About an axis along w: it turns with its centre.
    const Vec3<double> center = Vec3<double>::Zero();
    out.revolves = true;
    out.own_rate = out.rate;
    out.revolved_reach = unit * bounds.half.norm() * raise;
    out.center_rho = is_on_axis(moving, pivot, center)
                         ? 0.0
                         : unit * (axis.cross(turn * pivot).norm() +
                                   kMobilityRounding * kUnitRoundoff<double> * pivot.cwiseAbs().sum());
  } else if (const int own = axis_of_revolution(moving.body.shape); own >= 0) {
    out.revolves = true;
    const Vec3<double> a = turn.col(own);
    const double noise = kMobilityRounding * kUnitRoundoff<double>;
    out.tilt_rate = is_along_own_axis(moving, own) ? 0.0 : out.w.cross(a).norm() + noise * out.rate;
    out.own_rate = std::abs(out.w.dot(a)) * raise + noise * out.rate;
    Vec3<double> foot = -pivot;  // of the pivot on the axis, about the pivot
    foot[own] = 0;
    out.center_rho =
        foot == Vec3<double>::Zero() ? 0.0 : unit * (axis.cross(turn * foot).norm() + noise * foot.norm());
    const Vec3<double> most = bounds.half + bounds.middle.cwiseAbs() + bounds.center.cwiseAbs();
    out.revolved_reach = unit * std::hypot(most[(own + 1) % 3], most[own] + std::abs(pivot[own])) * raise;
  }
  return out;
}

}  // namespace graze::detail
