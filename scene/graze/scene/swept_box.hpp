// Boxes that move: what a body sweeps over a step, and whether two of them may ever meet.
//
//   box(s) = [low0 + s (low1 - low0), high0 + s (high1 - high0)] per axis,   s = t / t_max in [0, 1].
//
// Bounds. At every s the box holds the body. The body's own bounds, c + v t - h and c + v t + h, are linear in t. The
// bounds low0 and low1 are below the first at either end, high0 and high1 above the second, so the chords are too. So
// only the ends are rounded, and outward (bounds.cpp). A box of boxes takes the least and the greatest of each end:
// chords of lesser ends are lesser, and nothing rounds.
//
// Meeting. On an axis, P and Q meet at s iff P.high(s) >= Q.low(s) and Q.high(s) >= P.low(s): two linear
// functions of s with ends e0, e1. The sign of a rounded difference of doubles is that of the exact one (a flushed
// one is 0, which counts as meeting). So "never on this axis", e0 < 0 and e1 < 0, is decided exactly. Else the root
// is e0 / (e0 - e1), of two differences and a quotient of positive numbers, four roundings: it is moved outward by 8
// u. If on all axes together no s is left, the boxes never meet.
#pragma once

#include <algorithm>
#include <graze/rotating_body.hpp>

namespace graze::scene {

struct SweptBox {
  Vec3<double> low0, high0, low1, high1;

  // Holds nothing at first. Grown by boxes it becomes their box.
  [[nodiscard]] static SweptBox nothing() {
    const Vec3<double> most = Vec3<double>::Constant(kInfinity<double>);
    return {most, -most, most, -most};
  }
  void grow(const SweptBox& more) {
    low0 = low0.cwiseMin(more.low0);
    high0 = high0.cwiseMax(more.high0);
    low1 = low1.cwiseMin(more.low1);
    high1 = high1.cwiseMax(more.high1);
  }
};

// The s in [begin, end] at which boxes may meet. The interval is empty if begin > end.
struct Meeting {
  double begin = 0, end = 1;

  [[nodiscard]] bool possible() const { return begin <= end; }
  // Keeps the s at which a linear function from e0 to e1 may be 0 or more.
  void keep(double e0, double e1) {
    constexpr double kOutward = 8 * kUnitRoundoff<double>;
    if (e0 < 0) {
      begin = e1 < 0 ? kInfinity<double> : std::max(begin, -e0 / (e1 - e0) * (1 - kOutward));
    } else if (e1 < 0) {
      end = std::min(end, e0 / (e0 - e1) * (1 + kOutward));
    }
  }
};

[[nodiscard]] inline Meeting meeting(const SweptBox& p, const SweptBox& q) {
  Meeting out;
  for (int i = 0; i < 3; ++i) {
    out.keep(p.high0[i] - q.low0[i], p.high1[i] - q.low1[i]);
    out.keep(q.high0[i] - p.low0[i], q.high1[i] - p.low1[i]);
    if (!out.possible()) break;
  }
  return out;
}

// As q stands at s = 0.
[[nodiscard]] inline Meeting meeting_at_rest(const SweptBox& p, const SweptBox& q) {
  Meeting out;
  for (int i = 0; i < 3; ++i) {
    out.keep(p.high0[i] - q.low0[i], p.high1[i] - q.low0[i]);
    out.keep(q.high0[i] - p.low0[i], q.high0[i] - p.low1[i]);
    if (!out.possible()) break;
  }
  return out;
}

// The time, rounded up, by which a body that starts in a box has left a box at s = 0 for good. The body moves by v
// for each unit of t, v != 0. A negative time means that they never meet. On each axis along which
// it moves it leaves at the far side.
[[nodiscard]] inline double last_exit(const Vec3<double>& v, const SweptBox& start,
                                      const SweptBox& standing) {
  double least = kInfinity<double>;
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const double way = v[i] > 0 ? standing.high0[i] - start.low0[i] : start.high0[i] - standing.low0[i];
    if (way < 0) return -1;
    least = std::min(least, way / std::abs(v[i]) * (1 + 8 * kUnitRoundoff<double>));
  }
  return least;
}

// A body's rotation, as in RotatingBody.
struct Turn {
  Vec3<double> rotation = Vec3<double>::Zero(), pivot = Vec3<double>::Zero();
};

// The bounds of the body over [0, t_end], t_end finite, grown by a margin. The body must be valid. A rotating body
// gets the ball about the pivot, or the linear motion's box with the rotation_displacement added, whichever is
// smaller.
[[nodiscard]] SweptBox swept_box(const Body<double>& body, const Turn& turn, double t_end, double around);
[[nodiscard]] inline SweptBox swept_box(const RotatingBody<double>& moving, double t_end, double around) {
  return swept_box(moving.body, {moving.rotation, moving.pivot}, t_end, around);
}

// The box of a body whose contacts, at the target distance, a pair's cast may report. It adds half the distance, and
// 2^-36 of its scale, 131072 u, for tier standard, which answers for shapes within kappa u scale.
[[nodiscard]] SweptBox contact_box(const Body<double>& body, const Turn& turn, double t_end,
                                   double target_distance);
[[nodiscard]] inline SweptBox contact_box(const RotatingBody<double>& moving, double t_end,
                                          double target_distance) {
  return contact_box(moving.body, {moving.rotation, moving.pivot}, t_end, target_distance);
}

}  // namespace graze::scene
