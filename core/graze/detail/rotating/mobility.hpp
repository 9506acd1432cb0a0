// Bounds the speed of a rotating body's points along an axis. Every safe step relies on these bounds.
//
// Lengths in the unit of the points given, angles in radians, t in units of the step. The unit vector n is in
// world axes, w is the rotation vector, x(t) = R(w t) x_0 a point about the pivot. Then
//   |d/dt n.x|      = |(n x w) . x| <= |n x w| rho            rho: largest distance from the axis of rotation
//   |d^2/dt^2 n.x|  = |n_perp . x_perp| |w|^2 <= |w| |n x w| rho      (n_perp, x_perp: across w).
// The ball of a sphere, a capsule or a rounded shape rotates with no effect, so rho is the core's alone. A ball about
// its centre and a capsule about its axis do not move.
//
// A solid of revolution is the same set however it is rotated about its own axis a. Its points may therefore be
// followed in a frame that rotates by w less its part along a(t), of length |w x a|, constant. About the foot c
// of the pivot on the axis, with s = a.w and r the largest |x_0 - c|:
//   velocity     <= |n x w| |c_perp| + |w x a| r
//   acceleration <= |w| |n x w| |c_perp| + |w x a| (|w x a| + |s|) r
// The lesser of both bounds counts.   [Mirtich 1996, 2.3: the first bound, with |w| rho for |n x w| rho.]
//
// Rounding. Each number here is an upper bound of the exact value. Two of them are 0 if their operands are
// parallel or cancel, and no factor raises a 0:
//   n x w    is formed from exact products (`length_of_cross`). It is 0 only if n and w are parallel.
//   arms     x - pivot: the difference is exact, hi + lo, and the discarded part counts whole (`Arm`).
// tests/bounds checks each against ball arithmetic.
#pragma once

#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/pairs/side.hpp>
#include <graze/detail/rotating/profile.hpp>
#include <graze/rotating_body.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Returns |l x r|, never too small, and too large by at most 2^-39 of itself. It is 0 only if the cross product is 0.
//
// If the angle is not small, it is computed in plain doubles. An entry is within u (|l_j r_k| + |l_k r_j|) and u of
// itself, the vector within 3 u |l| |r| and 2 u of itself. If its length exceeds 2^-10 |l| |r|, that is less than
// 2^-41 of it, and 2^-40 makes up for all. Squares of the lengths within 2^+-400 keep every rounding relative: the
// underflow of a product is below 2^-1074, and 2^-800 is not. Otherwise each entry is a difference of two exact
// products, within 2^-100 of itself (offset.hpp), however much cancels. The result is too large by at most 16 u.
// Components of r are 0 or above 2^-200, so products are exact unless a component of l is below 2^-700. Such a part
// of l is counted whole.
inline double length_of_cross(const Vec3<double>& l, const Vec3<double>& r) {
  const double l_sq = squared_norm(l), r_sq = squared_norm(r);
  if (l_sq > 0x1p-400 && l_sq < 0x1p400 && r_sq > 0x1p-400 && r_sq < 0x1p400) {
    const double length_sq = squared_norm(cross(l, r));
    if (length_sq > 0x1p-20 * (l_sq * r_sq)) return square_root(length_sq) * (1 + 0x1p-40);
  }
  constexpr double kExact = 0x1p-700;
  Vec3<double> c;
  double vanishing = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const TwoDoubles difference = two_product(l[j], r[k]) + -two_product(l[k], r[j]);
    c[i] = std::abs(difference.hi);
    if (l[i] != 0 && std::abs(l[i]) < kExact) vanishing = 4 * kExact;
  }
  const double size = r.cwiseAbs().maxCoeff();
  return (scaled_norm(c) + fl(vanishing * size)) * (1 + 12 * kUnitRoundoff<double>);
}

struct Mobility {
  Vec3<double> w = Vec3<double>::Zero();
  double rate = 0;   // |w|
  double rho = 0;    // largest distance of the core's points from the axis of rotation
  double reach = 0;  // and from the pivot
  // However the body rotates, the core is in the cylinder of radius rho about the axis of rotation, between these two
  // heights along w from the pivot.
  double low = 0, high = 0;
  bool revolves = false;      // a solid of revolution: the second bound exists
  double tilt_rate = 0;       // |w x a|
  double own_rate = 0;        // |a.w|
  double center_rho = 0;      // |c_perp|
  double revolved_reach = 0;  // r
  Profile profile;            // if the pivot is on its own axis

  [[nodiscard]] bool turns() const { return rate > 0; }
  // |n x w|
  [[nodiscard]] double across(const Vec3<double>& n) const { return length_of_cross(n, w); }
  // Speed due to the rotation alone, without the translation that all points share.
  [[nodiscard]] double speed(const Vec3<double>& n) const {
    if (!turns()) return 0;
    const double sine = across(n), plain = sine * rho;
    return revolves ? std::min(plain, fl(sine * center_rho) + fl(tilt_rate * revolved_reach)) : plain;
  }
  [[nodiscard]] double acceleration(const Vec3<double>& n) const { return acceleration_for(across(n)); }
  // The same for an n for which |n x w| is known. If n moves evenly, by axis_rate per unit of t, the second
  // derivative of n.x gains 2 n'.x': twice axis_rate times the speed.
  [[nodiscard]] double acceleration_for(double across, double axis_rate = 0) const {
    if (!turns()) return 0;
    const double sine = rate * (across + 2 * axis_rate), plain = sine * rho;
    if (!revolves) return plain;
    return std::min(plain, fl(sine * center_rho) +
                               fl(tilt_rate * (tilt_rate + own_rate + 2 * axis_rate) * revolved_reach));
  }
  // Largest displacement of the body as a set due to its rotation within time t.
  [[nodiscard]] double rotation_displacement(double t) const {
    if (!turns()) return 0;
    const double chord = std::min(rate * t, 2.0);
    if (!revolves) return chord * rho;
    return chord * std::min(rho, center_rho + fl(tilt_rate / rate * revolved_reach));
  }
  // Largest acceleration of any point of the body as a set, along any n.
  [[nodiscard]] double top_acceleration() const {
    if (!turns()) return 0;
    const double plain = rate * rate * rho;
    return revolves ? std::min(plain, fl(rate * rate * center_rho) +
                                          fl(tilt_rate * (tilt_rate + own_rate) * revolved_reach))
                    : plain;
  }
  // The most that a solid with a profile reaches along n in a span h of t, with its own axis at both ends given, entries
  // within u.
  [[nodiscard]] double profile_reach(const Vec3<double>& n, const Vec3<double>& a_0, const Vec3<double>& a_1,
                                     double h) const {
    constexpr double u = kUnitRoundoff<double>;
    const double c_0 = dot(n, a_0), c_1 = dot(n, a_1), turned = fl(across(n) * tilt_rate),
                 bulge = turned * h * h / 8, middle = dot(n, w) / rate * (dot(a_0, w) / rate),
                 half = turned / (rate * rate) + fl(64 * u * (turned / (rate * rate) + std::abs(middle)));
    const double least = std::max(std::min(c_0, c_1) - bulge, middle - half) - 8 * u,
                 most = std::min(std::max(c_0, c_1) + bulge, middle + half) + 8 * u;
    return profile.reach(std::max(least, -1.0), std::min(most, 1.0));
  }
  [[nodiscard]] double top_speed() const {
    if (!turns()) return 0;
    return revolves ? std::min(rate * rho, fl(rate * center_rho) + fl(tilt_rate * revolved_reach))
                    : rate * rho;
  }
};

// The axis of revolution of a shape, own frame: 0, 1 or 2, or -1 if the shape has no such axis.
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

// Is every axis an axis of revolution?
template <Scalar S>
bool is_ball(const Shape<S>& shape) {
  const auto* e = std::get_if<Ellipsoid<S>>(&shape);
  return e && e->radii[0] == e->radii[1] && e->radii[1] == e->radii[2];
}

// The shape without its rounding and without poses that have no effect. It has the same core and is often a leaf,
// whose bounds are exact.
template <Scalar S>
const Shape<S>& unwrapped(const Shape<S>& shape) {
  if (const auto* rounded = std::get_if<Rounded<S>>(&shape)) return unwrapped<S>(rounded->shape->shape);
  if (const auto* posed = std::get_if<Posed<S>>(&shape);
      posed && posed->orientation.is_identity() && posed->position == Vec3<S>::Zero())
    return unwrapped<S>(posed->shape->shape);
  return shape;
}

// Is w exactly along the body's own axis? The numbers show this for a body without an orientation, or with one that
// permutes the axes.
template <Scalar S>
bool is_along_own_axis(const RotatingBody<S>& moving, int own) {
  const Quaternion<double> q = as_double(moving.body.orientation);
  if (!permutes_axes(q)) return false;
  const Vec3<double> a = rotation_matrix(q).col(own).array().round();
  return length_of_cross(a, wide(moving.rotation)) == 0;
}

// The vector from the pivot to the body's point base + rest, own frame. Its error is at most `lost`. The lengths
// |base| + |rest| and |pivot| may be of any size.
struct Arm {
  Vec3<double> x;
  double lost = 0;

  Arm(const Vec3<double>& base, const Vec3<double>& rest, const Vec3<double>& pivot) {
    for (int i = 0; i < 3; ++i) {
      const TwoDoubles out = two_sum(base[i], -pivot[i]), all = two_sum(out.hi, rest[i]);
      x[i] = all.hi;
      lost += std::abs(all.lo) + std::abs(out.lo);
    }
  }
  [[nodiscard]] bool is_zero() const { return lost == 0 && x == Vec3<double>::Zero(); }
};

// Is the arm's end exactly on the axis of rotation? As above.
template <Scalar S>
class AxisOfRotation {
 public:
  explicit AxisOfRotation(const RotatingBody<S>& moving) {
    const Quaternion<double> q = as_double(moving.body.orientation);
    permutes_ = permutes_axes(q);
    if (permutes_) w_ = rotation_matrix(q).array().round().matrix().transpose() * wide(moving.rotation);
  }
  [[nodiscard]] bool holds(const Arm& arm) const {
    return arm.is_zero() || (permutes_ && !(arm.lost > 0) && length_of_cross(arm.x, w_) == 0);
  }

 private:
  bool permutes_ = false;
  Vec3<double> w_ = Vec3<double>::Zero();  // own axes, if those are the world's in another order
};
template <Scalar S>
bool is_on_axis(const RotatingBody<S>& moving, const Arm& arm) {
  return AxisOfRotation<S>(moving).holds(arm);
}

// Calls visit(base, rest) for points base + rest in the body's own frame. Their hull holds the core up to the
// distance `beyond_bounds`. The points are its vertices, or the corners of its bounds.
template <Scalar S, class Visit>
void for_each_outer_point(const Shape<S>& shape, const Bounds& bounds, const Visit& visit) {
  const Vec3<double> zero = Vec3<double>::Zero();
  if (const auto* hull = std::get_if<Hull<S>>(&shape)) {
    const double unit = power_of_two(hull->exponent());
    for (std::uint32_t k = 0; k < hull->size(); ++k) {
      visit(bounds.center, Vec3<double>(unit * hull_vertex<double>(*hull, k)));
    }
  } else if (const auto* segment = std::get_if<Segment<S>>(&shape)) {
    visit(wide(segment->a), zero);
    visit(wide(segment->b), zero);
  } else if (const auto* triangle = std::get_if<Triangle<S>>(&shape)) {
    visit(wide(triangle->a), zero);
    visit(wide(triangle->b), zero);
    visit(wide(triangle->c), zero);
  } else {
    for (std::uint32_t k = 0; k < 8; ++k) {
      visit(bounds.center, Vec3<double>(bounds.middle + box_vertex(bounds.half, k)));
    }
  }
}

template <Scalar S>
bool is_combined(const Shape<S>& shape) {
  return std::holds_alternative<Posed<S>>(shape) || std::holds_alternative<Rounded<S>>(shape) ||
         std::holds_alternative<Sum<S>>(shape) || std::holds_alternative<HullOf<S>>(shape);
}

// Largest distance of a point of the core from the hull of the outer points. A leaf has no rounding. A combinator's
// bounds come from its own support points. They add one u of their coordinates each for the last sum, and the rest as
// tree.hpp counts it. Points and choice both count, as a greatest coordinate is either's.
template <Scalar S>
double beyond_bounds(const Shape<S>& shape, const Bounds& bounds) {
  if (!is_combined(shape)) return 0;
  const TreeRounding own = tree_rounding(shape, Turning::accurate);
  return 2 * (kUnitRoundoff<double> *
                  (own.point + own.choice + 8 * norm_1(bounds.half + bounds.middle.cwiseAbs())) +
              fl(3 * kTwoDoublesOfANode * nodes_of<S>(shape) * lengths_of<S>(shape)));
}

// Error of the quantities computed from an arm. A rotated vector is within 0.6 sqrt(3) u and a product's 3 u. A cross
// product with a unit vector, itself within 4 u, adds 7 u, so the total is 12 u.
inline constexpr double kMobilityRounding = 16;

// For a body that does not rotate only the reach counts, from a point of its own frame, within 8 u of itself.
inline double reach_at_rest(const Bounds& bounds, double beyond, const Vec3<double>& from) {
  const Arm middle(bounds.center, bounds.middle, from);
  const Vec3<double> most = bounds.half + middle.x.cwiseAbs();
  return (norm(most) + middle.lost + beyond) * (1 + kMobilityRounding * kUnitRoundoff<double>);
}

// The most that the core reaches from its pivot along n at any angle of its rotation, by the circles of its outer points
// about the axis of rotation. It is within 26 u of the reach, of which swept_error() covers what the slack does not.
template <Scalar S>
double reach_at_all_angles(const RotatingBody<S>& moving, const Mobility& body, const Vec3<double>& pivot,
                           double unit, const Mat3<double>& turn, const Vec3<double>& n) {
  constexpr double noise = kMobilityRounding * kUnitRoundoff<double>, raise = 1 + noise;
  const Shape<S>& shape = unwrapped<S>(moving.body.shape);
  const Bounds bounds = detail::bounds(shape);
  const Vec3<double> axis = graze::unit(body.w);
  const double beyond = beyond_bounds<S>(shape, bounds), along = dot(n, axis), across = norm(cross(n, axis));
  double most = -kInfinity<double>;
  for_each_outer_point(shape, bounds, [&](const Vec3<double>& base, const Vec3<double>& rest) {
    const Arm own(base, rest, pivot);
    const Vec3<double> arm = turn * own.x;
    const double slack = fl(noise * norm_1(own.x)) + fl(own.lost * raise) + beyond;
    most = std::max(most, fl(along * dot(axis, arm)) + fl(across * norm(cross(axis, arm))) + slack);
  });
  return unit * most;
}

// unit: the internal length of one world length. `bounds` are those of the unwrapped shape. pivot: the centre of
// rotation, or any point for a body that does not rotate. turn: the rotation of a body's orientation, entries within
// 0.6 u. It is not read for a body that does not rotate.
template <Scalar S>
Mobility mobility(const RotatingBody<S>& moving, const Vec3<double>& pivot, const Bounds& bounds, double unit,
                  const Mat3<double>& turn) {
  constexpr double noise = kMobilityRounding * kUnitRoundoff<double>, raise = 1 + noise;
  const Shape<S>& shape = unwrapped<S>(moving.body.shape);
  const double beyond = beyond_bounds<S>(shape, bounds);
  Mobility out;
  out.w = wide(moving.rotation);
  out.rate = norm(out.w) * raise;
  if (!out.turns()) {
    out.reach = unit * reach_at_rest(bounds, beyond, pivot);
    return out;
  }
  const Vec3<double> axis = graze::unit(out.w);
  out.low = kInfinity<double>;
  out.high = -kInfinity<double>;
  const AxisOfRotation<S> about(moving);
  // The greatest length of all, and the greatest slack of all: an upper bound of both for every point.
  double across_sq = 0, arm_sq = 0, across_slack = 0, arm_slack = 0;
  for_each_outer_point(shape, bounds, [&](const Vec3<double>& base, const Vec3<double>& rest) {
    const Arm own(base, rest, pivot);
    const Vec3<double> arm = turn * own.x;
    const double slack = fl(noise * norm_1(own.x)) + fl(own.lost * raise) + beyond;
    if (!(beyond == 0 && about.holds(own))) {
      across_sq = std::max(across_sq, squared_norm(cross(axis, arm)));
      across_slack = std::max(across_slack, slack);
    }
    arm_sq = std::max(arm_sq, squared_norm(arm));
    arm_slack = std::max(arm_slack, slack);
    out.low = std::min(out.low, unit * (dot(axis, arm) - slack));
    out.high = std::max(out.high, unit * (dot(axis, arm) + slack));
  });
  out.rho = unit * (square_root(across_sq) + across_slack);
  out.reach = unit * (square_root(arm_sq) + arm_slack);
  const Vec3<double> zero = Vec3<double>::Zero();
  if (is_ball<S>(shape)) {
    // For an axis along w: it rotates with its centre.
    const Arm center(zero, zero, pivot);
    out.revolves = true;
    out.own_rate = out.rate;
    out.revolved_reach = unit * norm(bounds.half) * raise;
    out.center_rho =
        about.holds(center) ? 0.0 : unit * (norm(cross(axis, turn * pivot)) + fl(noise * norm_1(pivot)));
  } else if (const int own = axis_of_revolution<S>(shape); own >= 0) {
    out.revolves = true;
    const Vec3<double> a = turn.col(own);
    out.tilt_rate = is_along_own_axis(moving, own) ? 0.0 : norm(cross(out.w, a)) + fl(noise * out.rate);
    out.own_rate = fl(std::abs(dot(out.w, a)) * raise) + fl(noise * out.rate);
    Vec3<double> foot = -pivot;  // foot of the pivot on the axis, relative to the pivot
    foot[own] = 0;
    out.center_rho = foot == zero ? 0.0 : unit * (norm(cross(axis, turn * foot)) + fl(noise * norm_1(foot)));
    const Vec3<double> most = bounds.half + bounds.middle.cwiseAbs() + bounds.center.cwiseAbs();
    out.revolved_reach = unit * hypotenuse(most[(own + 1) % 3], most[own] + std::abs(pivot[own])) * raise;
    if (foot == zero) out.profile = profile_of<S>(shape, own, pivot[own], unit);
  }
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
