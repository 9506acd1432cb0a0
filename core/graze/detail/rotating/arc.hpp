// Bounds the gap along an axis below its chord, by the arc on which a rotating body sees the axis.
//
// Lengths: internal; n unit. s_n(t) = the gap along n at t (slice.hpp).
//
// Over a slice [t_0, t_1], tau = (t - t_0) / (t_1 - t_0), two bounds have the form
//   s_n(t) >= (1 - tau) s_n(t_0) + tau s_n(t_1) - 4 tau (1 - tau) k.
// - By the chord (slice.hpp): k = M (t_1 - t_0)^2 / 8. M is that of the point that bends most. A box that tips about an
//   edge on the floor keeps that edge there, and its far corners bend. This bound would need slices of sqrt(d).
// - By the arc. Seen from a body X that rotates by w about the pivot c, an axis of the world moves on an arc of a
//   circle by the angle 2 phi. The same holds for an axis that rotates with the other body, seen from a body without
//   rotation. The arc lies in the triangle of its ends d_0, d_1 and the meeting d_m of its tangents. At the angle u from
//   its middle, x = u / phi, d = a d_0 + b d_m + c d_1 with
//     a + b + c = 1,    c - a = sin u / sin phi,    b = cos phi (cos u - cos phi) / sin^2 phi <= (1 - x^2) / 2.
//   The least of d.(x - c) over X's points is concave in d, hence no less than a p_0 + b p_m + c p_1, where each p is
//   the least along that direction. With q = p_m - (p_0 + p_1) / 2 this is p_0 + tau' (p_1 - p_0) + b q. Here tau' =
//   (1 + c - a) / 2 differs from tau = (1 + x) / 2 by at most 0.09 phi^2 (1 - x^2) for phi <= 1/2. As 1 - x^2 =
//   4 tau (1 - tau) and pivots move evenly, k = the sum over the bodies of max(0, -q) / 2 + 0.09 phi^2 |p_1 - p_0|.
//   If the lowest points stay on the axis of rotation, they cost nothing, however the other points move.
#pragma once

#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/rotating/moving_pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// How a body sees the axis move: about `axis` by 2 phi.
struct AxisArc {
  Vec3<double> axis = Vec3<double>::Zero();
  double phi = 0, raise = 0;  // raise: 1 / cos phi - 1, not below

  AxisArc() = default;
  AxisArc(const Mobility& by, double h) {
    if (!by.turns()) return;
    axis = graze::unit(by.w);
    phi = by.rate * h / 2;
    const double half = rounded_sine_cosine(phi / 2).sine;
    raise = 2 * half * half / rounded_sine_cosine(phi).cosine * (1 + 16 * kUnitRoundoff<double>);
  }
  // From the axis in the middle of the arc to the meeting point of the tangents.
  [[nodiscard]] Vec3<double> tangents_meet(const Vec3<double>& n) const {
    return n + raise * (n - dot(n, axis) * axis);
  }
};

// Returns k of the arc, or infinity if the axis does not move on one. k includes its rounding errors. These are the
// errors of three support points of each body, of an arm, and of the time in the middle of the slice, which is known
// within u.
inline double bend_of_arc(MovingPair& pair, AxisFrame frame, const Vec3<double>& own, double t_0, double t_1,
                          Counters& counters) {
  constexpr double kMostAngle = 0.5, u = kUnitRoundoff<double>;
  const double h = t_1 - t_0, t_m = t_0 + h / 2;
  const Mobility &m_a = pair.mobility_a(), &m_b = pair.mobility_b();
  // Seen from a rotating body, the other one must not rotate: rotations about two axes make no arc.
  if ((frame == AxisFrame::a && m_b.turns()) || (frame == AxisFrame::b && m_a.turns()))
    return kInfinity<double>;
  const AxisArc a = frame == AxisFrame::a ? AxisArc() : AxisArc(frame == AxisFrame::b ? m_b : m_a, h),
                b = frame == AxisFrame::b ? AxisArc() : AxisArc(frame == AxisFrame::a ? m_a : m_b, h);
  if (!(std::max(a.phi, b.phi) <= kMostAngle)) return kInfinity<double>;
  double error = 0, rotation_displacement = 0;
  // The greatest of A's points along its direction, and the least of B's, each about the pivot of the rotation.
  const auto reach = [&](double t) {
    if (pair.time() != t) pair.place(t);
    ++counters.supports;
    const Cso<double>& cso = pair.cso();
    const auto &side_a = cso.side_a(), &side_b = cso.side_b();
    const Vec3<double> n = pair.to_world(frame, own), way = (t - t_m) * pair.velocity();
    const Vec3<double> d_a = t == t_m ? a.tangents_meet(n) : n, d_b = t == t_m ? b.tangents_meet(n) : n;
    // A point of the body at rest is its pivot: the one that is at the other's in the middle of the slice.
    const Vec3<double> pivot_a = frame == AxisFrame::b ? Vec3<double>(pair.pivot_b_now() - way)
                                                       : Vec3<double>(Vec3<double>::Zero()),
                       pivot_b = frame == AxisFrame::a ? way : pair.pivot_b_now();
    const Vec3<double> x_a = side_a.to_world(side_a.support(side_a, side_a.to_own(d_a), nullptr).x),
                       x_b = side_b.to_world(
                           side_b.support(side_b, side_b.to_own(Vec3<double>(-d_b)), nullptr).x);
    error = std::max(error, 2 * pair.error() + pair.frame_error(frame) +
                                fl(32 * u *
                                   (norm(pair.center_a()) + norm(pair.center_b()) + norm(pair.pivot_b_now()) +
                                    norm(way))));
    // Along a rotating axis, the pivots do not separate evenly. The second derivative of n.(difference of the pivots)
    // is at most 2 |n'| |v| + |n''| |v| h / 2.
    if (frame != AxisFrame::world) {
      const Mobility& m = frame == AxisFrame::a ? m_a : m_b;
      rotation_displacement = std::max(
          rotation_displacement, m.across(n) * (2 + m.rate * h / 2) * norm(pair.velocity()) * (1 + 64 * u));
    }
    return std::pair(dot(d_a, x_a + pair.center_a() - pivot_a), dot(d_b, x_b + pair.center_b() - pivot_b));
  };
  const auto begin = reach(t_0), middle = reach(t_m), end = reach(t_1);
  error += fl(2 * u * t_1 * pair.top_speed());
  const auto bend = [&](const AxisArc& x, double p_0, double p_m, double p_1) {
    if (x.phi == 0) return 0.0;
    return std::max(0.0, (p_0 + p_1) / 2 - p_m + 2 * error) / 2 +
           fl(0.09 * x.phi * x.phi * std::abs(p_1 - p_0));
  };
  return bend(a, -begin.first, -middle.first, -end.first) + bend(b, begin.second, middle.second, end.second) +
         fl(rotation_displacement * h * h / 8 * (1 + 0x1p-40));
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
