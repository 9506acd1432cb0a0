// Replaces a fast rotating body by the cylinder about the axis of rotation that it sweeps in a whole turn. The
// cylinder only translates. If another body stays clear of it, the angle of rotation does not matter.
//
// Internal lengths, frame of moving_pair.hpp. The core of a rotating body is, at every time, in the cylinder of
// radius rho between the heights low and high along w from the pivot (mobility.hpp). Its support point along n is
// exact up to 16 u of its size. Along a fixed n it has no acceleration. The length of a slice is therefore limited
// only by the other body's rotation and the bodies' translation.
//
// If n is known, less than the cylinder suffices: the most that the body reaches along n. That is by the circles of its
// outer points, or for a solid of revolution by its profile (profile.hpp), within a span of time.
#pragma once

#include <graze/detail/rotating/moving_pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The bodies that are replaced by their swept cylinder.
struct WholeTurns {
  bool a = false, b = false;
  [[nodiscard]] bool any() const { return a || b; }
};

// A support point about the pivot. If n is along the axis within rounding, any point of the rim is a valid one,
// within u rho, provided that it is across the axis. Therefore products are used, not the difference n - (n.u) u.
inline Vec3<double> swept_point(const Mobility& m, const Vec3<double>& n) {
  const Vec3<double> axis = unit(m.w);
  const double along = dot(n, axis);
  return (along >= 0 ? m.high : m.low) * axis + m.rho * unit(Vec3<double>(cross(axis, cross(n, axis))));
}

// A proof must be one that a checker can repeat: the ball of a combinator is not one number.
template <Scalar S>
bool has_plain_ball(const Shape<S>& shape) {
  return !is_combined(shape);
}

// A support point of the CSO as placed.
inline CsoPoint<double> swept_support(const MovingPair& pair, const WholeTurns& whole,
                                      const Vec3<double>& n) {
  const Cso<double>& cso = pair.cso();
  CsoPoint<double> out = cso.support(n);
  out.n = n;
  if (whole.a) {
    const auto& a = cso.side_a();
    const Vec3<double> x = a.to_world(a.support(a, a.to_own(n), &out.vertex_a).x);
    out.w += swept_point(pair.mobility_a(), n) - (pair.center_a() + x);
    out.vertex_a = 0;
  }
  if (whole.b) {
    const auto& b = cso.side_b();
    const Vec3<double> d = -n, x = b.to_world(b.support(b, b.to_own(d), &out.vertex_b).x);
    out.w += (pair.center_b() + x) - (pair.pivot_b_now() + swept_point(pair.mobility_b(), d));
    out.vertex_b = 0;
  }
  return out;
}

inline double swept_error(const MovingPair& pair) {
  const auto size = [](const Mobility& m) { return m.turns() ? m.rho + m.high - m.low : 0.0; };
  return pair.error() + 64 * kUnitRoundoff<double> *
                            (size(pair.mobility_a()) + size(pair.mobility_b()) + norm(pair.center_a()) +
                             norm(pair.center_b()) + norm(pair.pivot_b_now()));
}

// As the pair's own, of the swept bodies.
inline double swept_gap(const MovingPair& pair, const WholeTurns& whole, const Vec3<double>& n,
                        Counters& counters) {
  ++counters.supports;
  return -dot(n, swept_support(pair, whole, n).w) - pair.radius() - swept_error(pair);
}
inline double swept_bend(const MovingPair& pair, const WholeTurns& whole, const Vec3<double>& n) {
  return (whole.a ? 0.0 : pair.mobility_a().acceleration(n)) +
         (whole.b ? 0.0 : pair.mobility_b().acceleration(n));
}

// The gaps along n at both ends of [t_0, t_1], with the most that these bodies reach in between. If no other body
// rotates, no gap in between is below their chord. Leaves the bodies at t_1.
inline std::pair<double, double> gaps_between(MovingPair& pair, const WholeTurns& whole,
                                              const Vec3<double>& n, double t_0, double t_1,
                                              Counters& counters) {
  const Vec3<double> d_b = -n;
  double reach = pair.radius();
  if (whole.a) reach += pair.reach(AxisFrame::a, n, t_0, t_1);
  if (whole.b) reach += pair.reach(AxisFrame::b, d_b, t_0, t_1);
  const auto gap_at = [&](double t) {
    if (pair.time() != t) pair.place(t);
    ++counters.supports;
    const auto &a = pair.cso().side_a(), &b = pair.cso().side_b();
    Vec3<double> apart = pair.pivot_b_now();
    if (!whole.a) apart -= pair.center_a() + a.to_world(a.support(a, a.to_own(n), nullptr).x);
    if (!whole.b)
      apart += pair.center_b() - pair.pivot_b_now() + b.to_world(b.support(b, b.to_own(d_b), nullptr).x);
    return dot(n, apart) - reach - swept_error(pair);
  };
  const double first = gap_at(t_0);
  return {first, gap_at(t_1)};
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
