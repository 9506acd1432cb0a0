// Shared by the quick casts: the first direction, the point at which the path passes a triangle, and their results.
//
// The path is s r, in the units and the frame of prepared_pair.hpp.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/pairs/sweep_limits.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// How often weights are corrected.
inline constexpr int kFastCorrections = 2;
// The half width of a cube over its half diagonal.
inline constexpr double kFastBall = 0.58;

// outcome not_converged: it gave up.
struct FastSweep {
  Outcome outcome = Outcome::not_converged;
  double lower = 0, upper = 0;  // hit: of s
  Triple n{0, 0, 0};            // hit, miss: the axis, of any length
  int size = 0;                 // hit: corners
  std::array<double, 4> lambda{};
};

// The approximate direction at which a ball as large as C would be met. If the path passes beside that ball, the
// direction across the path. With p the ball's centre beside the line and R its radius, it is along -(R p + (R^2 -
// p^2) r), |r| taken for 1.
template <class Pair>
[[nodiscard]] Triple fast_first_direction(const Pair& pair) {
  const Triple& r = pair.direction();
  const double r_sq = dot(r, r), ball = fl(kFastBall * (pair.a().reach() + pair.b().reach())) + pair.radius();
  const Triple c = -pair.offset(), beside = r_sq * c - dot(c, r) * r;
  const double radius = ball * r_sq, room = std::max(fl(radius * radius) - dot(beside, beside), 0.0);
  return -(radius * beside + room * r);
}

// A triangle of vertices of C, which the line of r passes.
struct FastTriangle {
  const Triple &c0, &c1, &c2, &r;
  double r_sq;

  // The parameter s at which the line passes the triangle, with its weights. NaN if it does not within `near`, per
  // component.
  //
  // The weights are quotients of determinants of corners. These round by u of the square of C's distance, over the
  // triangle's area as seen. If the path is far longer than C is large, the point p that the weights make is off the
  // line. Its distance g = p - s r is the correction. Let e, f be the edges from c_0 and N = e x f. The weights of
  // c_1 and c_2 that remove g are g.(r x f) / N.r and g.(e x r) / N.r. The vector g is small and rounds by u of its
  // two terms.
  double pass(double near, std::array<double, 4>& lambda) const {
    const Triple m0 = cross(c0, r), m1 = cross(c1, r), m2 = cross(c2, r);
    const double l0 = std::max(dot(c1, m2), 0.0), l1 = std::max(dot(c2, m0), 0.0),
                 l2 = std::max(dot(c0, m1), 0.0), one = 1 / (l0 + l1 + l2);
    lambda = {l0 * one, l1 * one, l2 * one, 0};
    Triple g;
    double s = place(lambda, g);
    for (int round = 0; round < kFastCorrections && largest(g) > near; ++round) {
      correct(g, lambda);
      s = place(lambda, g);
    }
    return largest(g) <= near ? s : std::numeric_limits<double>::quiet_NaN();
  }
  // Does the line pass inside of each edge, its determinant above what rounding may add to it?
  [[nodiscard]] bool holds_line(double rounding) const {
    const Triple m0 = cross(c0, r), m1 = cross(c1, r), m2 = cross(c2, r);
    return dot(c1, m2) > rounding && dot(c2, m0) > rounding && dot(c0, m1) > rounding;
  }

 private:
  // The triangle's point at these weights: s, and its distance from the line.
  double place(const std::array<double, 4>& lambda, Triple& g) const {
    const Triple p = lambda[0] * c0 + lambda[1] * c1 + lambda[2] * c2;
    const double s = dot(p, r) / r_sq;
    g = p - s * r;
    return s;
  }
  [[gnu::noinline]] void correct(const Triple& g, std::array<double, 4>& lambda) const {
    const Triple e = c1 - c0, f = c2 - c0, a = cross(r, f), b = cross(e, r);
    const double one = 1 / dot(cross(e, f), r);
    const double l1 = std::max(lambda[1] + fl(dot(g, a) * one), 0.0),
                 l2 = std::max(lambda[2] + fl(dot(g, b) * one), 0.0), l0 = std::max(1 - l1 - l2, 0.0),
                 all = 1 / (l0 + l1 + l2);
    lambda = {l0 * all, l1 * all, l2 * all, 0};
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
