// Bounds the gap along an axis that moves below its chord, by support points about the middle of the slice.
//
// The chord's bound in slice.hpp counts the point that bends most. A box that tips about a corner or an edge keeps that
// where it is, and its far corners bend, so that slices would be as short as the root of the gap. Here only points count
// that come near the axis's support.
//
// Lengths: internal. Over [t_0, t_1], h long, tau = (t - t_0) / h, the axis n moves evenly in the axes of the world or of
// a body, from n_0 to n_1, its length at most 1. With any point c_Y on the axis of rotation of body Y and h_Y the support
// function of Y about it, in Y's own axes,
//   s(t) = n.(c_B - c_A) - h_A(d_A) - h_B(d_B),    d_A = n and d_B = -n as Y sees them.
// - d_Y is within 4 tau (1 - tau) beta of its chord, beta = max |d_Y''| h^2 / 8. So it is (1 - tau - b/2) d_0 + b (d_m +
//   e) + (tau - b/2) d_1, with d_m the mean of d_0 and d_1, b = 2 min(tau, 1 - tau) and |e| <= 2 beta. h_Y is sublinear.
//   Hence it exceeds its chord by at most b k_Y, where k_Y = max h_Y(d_m + e) - (h_Y(d_0) + h_Y(d_1)) / 2. And b <= 4
//   tau (1 - tau). The greatest is at one of the corners of a tetrahedron about that ball. If only one rotation w takes
//   part, d_Y'' and e are across w, and a triangle about the disc suffices.
// - c_B - c_A = D moves by V t, and |(n.D)''| <= |n''| |D| + 2 |n'| |V|.
// Therefore s is at most 4 tau (1 - tau) k below its chord, with k = k_A + k_B + |(n.D)''| h^2 / 8. In the frame of a
// body that body has k_Y = 0.
#pragma once

#include <graze/detail/rotating/moving_pair.hpp>
#include <graze/detail/search/robust/line_frame.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Returns k. n_0 and n_1 in world axes. `contact`: about where the bodies are nearest at t_0, from A's pivot. The points
// c_Y are next to it. k includes its rounding: that of six support points, of the directions in own axes, and of arms.
inline double bend_of_supports(MovingPair& pair, AxisFrame frame, const Vec3<double>& n_0, double t_0,
                               const Vec3<double>& n_1, double t_1, const Vec3<double>& contact,
                               Counters& counters) {
  constexpr double u = kUnitRoundoff<double>, kMostBend = 1.0 / 16, raise = 1 + 64 * u;
  const double h = t_1 - t_0;
  const Mobility &m_a = pair.mobility_a(), &m_b = pair.mobility_b();
  const Vec3<double> v = pair.velocity();
  const double axis_rate = pair.axis_change(frame, n_0, t_0, n_1, t_1) / h;
  const auto across = [&](const Mobility& m) { return std::max(m.across(n_0), m.across(n_1)); };
  const bool in_world = frame == AxisFrame::world;
  const Mobility& with = frame == AxisFrame::b ? m_b : m_a;  // of the frame, if that is a body's
  // |d_Y''| h^2 / 8
  const auto beta_of = [&](const Mobility& m, AxisFrame own) {
    if (frame == own || (in_world && !m.turns())) return 0.0;
    const double rate = in_world ? m.rate * (across(m) + 2 * axis_rate)
                                 : norm(with.w - m.w) * (with.rate + m.rate + 2 * axis_rate);
    return rate * h * h / 8 * raise;
  };
  const double beta_a = beta_of(m_a, AxisFrame::a), beta_b = beta_of(m_b, AxisFrame::b);
  if (!(std::max(beta_a, beta_b) <= kMostBend)) return kInfinity<double>;

  if (pair.time() != t_0) pair.place(t_0);
  const auto &side_a = pair.cso().side_a(), &side_b = pair.cso().side_b();
  const auto next_to_contact = [&](const Mobility& m, const Vec3<double>& pivot) {
    if (!m.turns()) return contact;
    const Vec3<double> axis = graze::unit(m.w);
    return Vec3<double>(pivot + dot(axis, contact - pivot) * axis);
  };
  const Vec3<double> c_a = next_to_contact(m_a, Vec3<double>::Zero()),
                     c_b = next_to_contact(m_b, pair.pivot_b_now());
  const Vec3<double> own_a = side_a.to_own(Vec3<double>(c_a - pair.center_a())),
                     own_b = side_b.to_own(Vec3<double>(c_b - pair.center_b()));
  const Vec3<double> a_0 = side_a.to_own(n_0), b_0 = side_b.to_own(Vec3<double>(-n_0));
  double error = pair.error();
  const double lengths =
      norm(c_a) + norm(c_b) + norm(contact) + norm(pair.center_a()) + norm(pair.center_b());
  pair.place(t_1);
  const Vec3<double> a_1 = side_a.to_own(n_1), b_1 = side_b.to_own(Vec3<double>(-n_1));
  error = 4 * std::max(error, pair.error()) +
          fl(64 * u * (pair.cso().extent() + pair.radius() + lengths + h * norm(v)));

  // w: of the one rotation that takes part, in own axes, or 0.
  const auto beyond_chord = [&](const Side<double>& side, const Vec3<double>& c, const Vec3<double>& d_0,
                                const Vec3<double>& d_1, double beta, const Vec3<double>& w) {
    if (beta == 0) return 0.0;
    counters.supports += 3;  // at most six of one body
    const auto reach = [&](const Vec3<double>& d) {
      return dot(d, Vec3<double>(side.support(side, d, nullptr).x - c));
    };
    const Vec3<double> middle = (d_0 + d_1) / 2;
    double most = -kInfinity<double>;
    const auto look = [&](const Vec3<double>& e) { most = std::max(most, reach(Vec3<double>(middle + e))); };
    if (w != Vec3<double>::Zero()) {
      // The corners of a triangle about the disc of radius 2 beta are twice as far.
      const Frame<double> about(graze::unit(w));
      const double r = 4 * beta * (1 + 8 * u), side_way = r * 0.8660254037844387;
      look(r * about.e1);
      look(-r / 2 * about.e1 + side_way * about.e2);
      look(-r / 2 * about.e1 - side_way * about.e2);
    } else {
      // Those of a tetrahedron about the ball are three times as far.
      const double r = 6 * beta / square_root(3.0) * (1 + 8 * u);
      look({r, r, r});
      look({r, -r, -r});
      look({-r, r, -r});
      look({-r, -r, r});
    }
    return std::max(0.0, most - (reach(d_0) + reach(d_1)) / 2 + error);
  };
  double bend = fl(2 * axis_rate * norm(v));
  if (!in_world) {
    const double turning = across(with);
    const double apart =
        std::max(norm(c_b - c_a), norm(Vec3<double>(c_b - c_a + h * v))) + fl(8 * u * lengths);
    bend += fl(with.rate * (turning + 2 * axis_rate) * apart) + fl(2 * turning * norm(v));
  }
  // The rotation that takes part alone: in the axes of the world a body's own. In a body's axes both do.
  const auto alone = [&](const Side<double>& side, const Mobility& own, const Mobility& other) {
    if (!in_world && own.turns() && other.turns()) return Vec3<double>(Vec3<double>::Zero());
    return side.to_own(in_world || own.turns() ? own.w : other.w);
  };
  return beyond_chord(side_a, own_a, a_0, a_1, beta_a, alone(side_a, m_a, m_b)) +
         beyond_chord(side_b, own_b, b_0, b_1, beta_b, alone(side_b, m_b, m_a)) +
         fl(bend * h * h / 8 * raise);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
