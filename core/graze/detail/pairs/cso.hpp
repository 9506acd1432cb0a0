// C = A - B at t = 0, by its support function, in the units and the frame that the solvers work in.
//
//   internal length = world length 2^-k,  k such that the scale of the pair is near 1
//   The origin is the world's, so contact at t is  s r in C + ball(R),  with the path parameter s and
//   r = v 2^-j,  t = s 2^(k - j),  R = r_A + r_B + m  (radii of spheres, target distance). The axes are the world's.
// Powers of two are exact, so scaling a problem by one changes no bit of the solvers' input.
//
// A sphere is a point with a radius: the solvers use the polytope of the cores, with R beside it. `support` is the
// core's. `rounded_support` adds the ball, for MPR and for portals on curved surfaces.
//
// Rounding of a support point w = R_A a - (R_B b + d), d as in offset.hpp. |a|, |b| are the cores' radii about their
// scan's origin, M = |a| + |b| + |d|. Rotating a vector x is within kTurn u |x| per component: rows of R are within 9
// sqrt(3) u (or 0.6 sqrt(3) u where R is accurate), a product of three terms within 3 u. If R permutes the axes, the
// rotation is exact. Per component
//   point_error = 4 u M + kTurn u (|a| + |b|) + e.
// d is within 2 u, and two sums round once each. e is the point_error of the sides: the rounding of curved leaves and
// combinators themselves (leaf.hpp, tree.hpp), and the error of d where centres far out cancel (offset.hpp).
//
// Rounding of h(n) = n.w, over |n|:
//   reach_error = sqrt(3) point_error + 3 u M + choice_error.
// 3 u M is for the product. choice_error is for a point that is not the greatest. Either n was rotated,
// 2 kTurn u (|a| + |b|), or products were compared: support_error, 8 u (|a| + |b|) for polytopes.
#pragma once

#include <graze/detail/pairs/side.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// A support point w = a - b of C. It keeps the vertices of A and B. On a rounded C it also keeps the ball's unit
// direction e, and on a curved core the direction n that it is the support point of, of any length.
template <Scalar S>
struct CsoPoint {
  Vec3<S> w = Vec3<S>::Zero();
  Vec3<S> e = Vec3<S>::Zero();
  Vec3<S> n = Vec3<S>::Zero();
  std::uint32_t vertex_a = 0, vertex_b = 0;

  [[nodiscard]] bool same_feature(const CsoPoint& o) const {
    return vertex_a == o.vertex_a && vertex_b == o.vertex_b && e == o.e && (n == o.n || w == o.w);
  }
};

// Valid while the two bodies live. Bodies must have passed validate().
template <Scalar S>
class Cso {
 public:
  template <Scalar Given>
  Cso(const Body<Given>& body_a, const Body<Given>& body_b, Given target_distance = 0,
      Turning turning = Turning::quick) {
    const Bounds a = bounds(body_a.shape), b = bounds(body_b.shape);
    const Vec3<double> d =
        accurate_offset(body_a.position.template cast<double>(), as_double(body_a.orientation), a.center,
                        body_b.position.template cast<double>(), as_double(body_b.orientation), b.center);
    const double size_a = 2 * (a.half.maxCoeff() + a.radius), size_b = 2 * (b.half.maxCoeff() + b.radius);
    const double apart = (d + turn(body_b, b.middle) - turn(body_a, a.middle)).cwiseAbs().maxCoeff();
    const double scale = std::max({size_a, size_b, apart});
    k_ = scale > 0 ? exponent_of(scale) : 0;
    // Cubes must hold a target distance, however far beyond the bodies.
    if (target_distance > 0) k_ = std::max(k_, exponent_of(target_distance) - kRoom);
    scale_ = scale > 0 ? static_cast<S>(scale * power_of_two(-k_)) : S(0);
    a_ = make_side<S>(body_a, a, k_, turning);
    b_ = make_side<S>(body_b, b, k_, turning);
    d_ = (power_of_two(-k_) * d).template cast<S>();
    const double target = static_cast<double>(target_distance) * power_of_two(-k_);
    target_ = static_cast<S>(target);
    radius_ = a_.radius + b_.radius + target_;
    curved_ = a_.curved || b_.curved;
    const Vec3<double> v =
        body_b.displacement.template cast<double>() - body_a.displacement.template cast<double>();
    const double speed = v.cwiseAbs().maxCoeff();
    j_ = speed > 0 ? exponent_of(speed) : 0;
    r_ = (power_of_two(-j_) * v).template cast<S>();
    // Valid bodies have finite values, near 1 in internal units.
    GRAZE_ASSERT(scale_ >= 0 && scale_ <= 2 && radius_ < kInfinity<S> && d_.allFinite() && r_.allFinite());
  }

  // The moved bodies of a rotating cast at some time: the rotations of the cores of the rotating ones, each
  // entry within 11 u, and the offset, internal units, within 2 u.
  void place(const Mat3<S>* rotation_a, const Mat3<S>* rotation_b, const Vec3<S>& offset) {
    if (rotation_a) a_.turn_to(*rotation_a);
    if (rotation_b) b_.turn_to(*rotation_b);
    d_ = offset;  // of a way that outgrows the doubles infinite or NaN: then nothing is found or proved
  }

  // The core's support point along n (any length). For the rounded C, n is a unit vector, or 0 for any point of C.
  [[nodiscard]] CsoPoint<S> support(const Vec3<S>& n) const {
    CsoPoint<S> out;
    const SidePoint<S> a = a_.support(a_, a_.to_own(n), nullptr);
    const SidePoint<S> b = b_.support(b_, b_.to_own(-n), nullptr);
    out.vertex_a = a.vertex;
    out.vertex_b = b.vertex;
    if (curved_) out.n = n;
    out.w = a_.to_world(a.x) - (b_.to_world(b.x) + d_);
    return out;
  }
  [[nodiscard]] CsoPoint<S> rounded_support(const Vec3<S>& unit_n) const {
    CsoPoint<S> out = support(unit_n);
    if (radius_ > 0) {
      GRAZE_ASSERT(unit_n == Vec3<S>::Zero() || !(std::abs(squared_norm(unit_n) - 1) > S(kNearUnit)));
      out.e = unit_n;
      out.w += radius_ * unit_n;
    }
    return out;
  }

  // The middle of the core's bounds: a good first guess, though for a hull it may lie outside C.
  [[nodiscard]] Vec3<S> middle() const { return a_.to_world(a_.middle) - (b_.to_world(b_.middle) + d_); }

  // (p_B + R_B c_B) - (p_A + R_A c_A), c the centres of the sides.
  [[nodiscard]] const Vec3<S>& offset() const { return d_; }
  [[nodiscard]] bool curved() const { return curved_; }
  [[nodiscard]] const Vec3<S>& direction() const { return r_; }  // r, or zero if nothing moves
  [[nodiscard]] bool moves() const { return r_ != Vec3<S>::Zero(); }
  [[nodiscard]] S radius() const { return radius_; }
  [[nodiscard]] S target() const { return target_; }
  // It is in [1, 2] internal units (0 for two coinciding points), and within a factor 3 below the pair's scale. The
  // pair's scale is the largest side of either box in its own axes, or the largest coordinate of the distance between
  // their centres.
  [[nodiscard]] S scale() const { return scale_; }
  // See above. `extent` is M, which also bounds |w|.
  [[nodiscard]] S extent() const { return a_.reach + b_.reach + norm(d_); }
  [[nodiscard]] S point_error() const {
    return kUnitRoundoff<S> * (4 * extent() + fl(a_.turn * a_.reach) + fl(b_.turn * b_.reach)) +
           a_.point_error + b_.point_error;
  }
  // How far over |n| the points that the sides choose may lie below the greatest.
  [[nodiscard]] S choice_error() const {
    return a_.support_error + b_.support_error +
           2 * kUnitRoundoff<S> * (fl(a_.turn * a_.reach) + fl(b_.turn * b_.reach));
  }
  [[nodiscard]] S reach_error() const {
    return fl(S(1.75) * point_error()) + fl(3 * kUnitRoundoff<S> * extent()) + choice_error();
  }

  [[nodiscard]] const Side<S>& side_a() const { return a_; }
  [[nodiscard]] const Side<S>& side_b() const { return b_; }

  [[nodiscard]] int length_exponent() const { return k_; }
  [[nodiscard]] int speed_exponent() const { return j_; }
  // t = s 2^(k - j), and its inverse. It is infinite if t_max is, or if it is out of S's range. Never -0, which one
  // compiler's std::max() makes 0 and another's keeps.
  [[nodiscard]] S to_time(S s) const {
    return static_cast<S>(static_cast<double>(s) * power_of_two(k_ - j_)) + S(0);
  }
  [[nodiscard]] S to_parameter(S t) const {
    return static_cast<S>(static_cast<double>(t) * power_of_two(j_ - k_));
  }
  [[nodiscard]] S to_length(S internal) const {
    return static_cast<S>(static_cast<double>(internal) * power_of_two(k_)) + S(0);
  }

 private:
  template <Scalar Given>
  static Vec3<double> turn(const Body<Given>& body, const Vec3<double>& x) {
    if (body.orientation.is_identity()) return x;
    return rotation_matrix(as_double(body.orientation)) * x;
  }

  Side<S> a_, b_;
  Vec3<S> d_ = Vec3<S>::Zero(), r_ = Vec3<S>::Zero();
  S radius_ = 0, target_ = 0, scale_ = 0;
  // Thrice this, and what a few terms add, is below the largest exponent of a double that splits into halves
  // (offset.hpp), 996: a portal's height is a sum of products of three. In float twice this, below 127.
  static constexpr int kRoom = sizeof(S) == 8 ? 300 : 50;
  int k_ = 0, j_ = 0;
  bool curved_ = false;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
