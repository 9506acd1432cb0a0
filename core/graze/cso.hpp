// C = A - B at t = 0, by its support function, in the units and the frame that the solvers work in.
//
//   internal length = world length 2^-k,  k such that the scale of the pair is near 1;
//   origin at the world's, so that contact at t is  s r in C + ball(R),  with the path parameter s and
//   r = v 2^-j,  t = s 2^(k - j),  R = r_A + r_B + m  (radii of spheres, target distance), axes the world's.
// Powers of two are exact, so scaling a problem by one changes no bit of what the solvers see.
//
// A sphere is a point with a radius: the solvers see the polytope of the cores and R beside it. `support` is
// the core's; `rounded_support` adds the ball, for MPR and for portals on curved surfaces.
//
// Rounding of a support point w = R_A a - (R_B b + d), d as in offset.hpp; |a|, |b| the cores' radii about
// their scan's origin, M = |a| + |b| + |d|. Turning a vector x is within kTurn u |x| per component: rows of R
// within 9 sqrt(3) u (or 0.6 sqrt(3) u where R is accurate), a product of three terms 3 u; nothing where R
// permutes the axes. Per component
//   point_error = 4 u M + kTurn u (|a| + |b|):  d is within 2 u, two sums round once each.
// Rounding of h(n) = n.w, over |n|:
//   reach_error = sqrt(3) point_error + 3 u M + (6 + 2 kTurn) u (|a| + |b|): the product, and a vertex that
//   is not the greatest because n was turned and products compared (3 u), each counted at both vertices.
#pragma once

#include <graze/body.hpp>
#include <graze/offset.hpp>

namespace graze {

// A support point of C: w = a - b, by the vertices of A and B and, on a rounded C, the ball's unit direction
// e.
template <Scalar S>
struct CsoPoint {
  Vec3<S> w = Vec3<S>::Zero();
  Vec3<S> e = Vec3<S>::Zero();
  std::uint32_t vertex_a = 0, vertex_b = 0;

  [[nodiscard]] bool same_feature(const CsoPoint& o) const {
    return vertex_a == o.vertex_a && vertex_b == o.vertex_b && e == o.e;
  }
};

namespace detail {

// One body of the pair: its core polytope in internal units, in its own axes about its scan's centre.
template <Scalar S>
struct Side {
  using Support = std::uint32_t (*)(const Side&, const Vec3<S>& direction);
  using Vertex = Vec3<S> (*)(const Side&, std::uint32_t index);

  Support support = nullptr;
  Vertex vertex = nullptr;
  const void* hull = nullptr;
  S unit = 1;                                                // internal length of one scan unit
  Vec3<S> half = Vec3<S>::Zero(), middle = Vec3<S>::Zero();  // bounds, internal units, own axes
  Mat3<S> rotation = Mat3<S>::Identity();
  bool rotated = false;
  S turn = 0;  // turning x is within turn u |x| per component
  S radius = 0;

  [[nodiscard]] Vec3<S> to_own(const Vec3<S>& n) const {
    return rotated ? Vec3<S>(rotation.transpose() * n) : n;
  }
  [[nodiscard]] Vec3<S> to_world(const Vec3<S>& x) const { return rotated ? Vec3<S>(rotation * x) : x; }
  // Bounds |x| over the core.
  [[nodiscard]] S reach() const { return (half + middle.cwiseAbs()).norm(); }
};

template <Scalar S>
std::uint32_t point_support(const Side<S>&, const Vec3<S>&) {
  return 0;
}
template <Scalar S>
Vec3<S> point_vertex(const Side<S>&, std::uint32_t) {
  return Vec3<S>::Zero();
}

template <Scalar S>
std::uint32_t box_support(const Side<S>&, const Vec3<S>& d) {
  return (d[0] >= 0 ? 1u : 0u) | (d[1] >= 0 ? 2u : 0u) | (d[2] >= 0 ? 4u : 0u);
}
template <Scalar S>
Vec3<S> box_vertex(const Side<S>& side, std::uint32_t k) {
  return {k & 1u ? side.half[0] : -side.half[0], k & 2u ? side.half[1] : -side.half[1],
          k & 4u ? side.half[2] : -side.half[2]};
}

// The first vertex that is greatest along d, as rounded: at most 4 u |d|_1 reach below the true maximum.
template <Scalar S, Scalar Given>
std::uint32_t hull_support(const Side<S>& side, const Vec3<S>& d) {
  const auto& hull = *static_cast<const Hull<Given>*>(side.hull);
  const Given *x = hull.scan(0), *y = hull.scan(1), *z = hull.scan(2);
  constexpr std::size_t kLanes = Hull<Given>::kBlock;
  using Index = std::conditional_t<sizeof(S) == 8, std::int64_t, std::int32_t>;
  const S dx = d[0], dy = d[1], dz = d[2];
  S best[kLanes];
  Index at[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) {
    best[l] = S(x[l]) * dx + S(y[l]) * dy + S(z[l]) * dz;
    at[l] = static_cast<Index>(l);
  }
  const std::size_t n = hull.padded_size();
  for (std::size_t i = kLanes; i < n; i += kLanes) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const S value = S(x[i + l]) * dx + S(y[i + l]) * dy + S(z[i + l]) * dz;
      const bool up = value > best[l];
      best[l] = up ? value : best[l];
      at[l] = up ? static_cast<Index>(i + l) : at[l];
    }
  }
  std::size_t lane = 0;
  for (std::size_t l = 1; l < kLanes; ++l) {
    if (best[l] > best[lane] || (best[l] == best[lane] && at[l] < at[lane])) lane = l;
  }
  return at[lane] < static_cast<Index>(hull.size()) ? static_cast<std::uint32_t>(at[lane]) : 0u;
}
template <Scalar S, Scalar Given>
Vec3<S> hull_vertex(const Side<S>& side, std::uint32_t k) {
  const auto& hull = *static_cast<const Hull<Given>*>(side.hull);
  return side.unit * Vec3<S>(S(hull.scan(0)[k]), S(hull.scan(1)[k]), S(hull.scan(2)[k]));
}

// Bounds of a shape in world lengths about its centre, in double: what the choice of units needs.
struct Bounds {
  Vec3<double> center = Vec3<double>::Zero(), half = Vec3<double>::Zero(), middle = Vec3<double>::Zero();
  double radius = 0;
};
template <Scalar S>
Bounds bounds(const Point<S>&) {
  return {};
}
template <Scalar S>
Bounds bounds(const Sphere<S>& sphere) {
  Bounds out;
  out.radius = sphere.radius;
  return out;
}
template <Scalar S>
Bounds bounds(const Box<S>& box) {
  Bounds out;
  out.half = box.half_extents.template cast<double>();
  return out;
}
template <Scalar S>
Bounds bounds(const Hull<S>& hull) {
  const double unit = std::ldexp(1.0, hull.exponent());
  Bounds out;
  out.center = hull.center().template cast<double>();
  out.half = unit * hull.scan_half_extents().template cast<double>();
  out.middle = unit * hull.scan_middle().template cast<double>();
  return out;
}

template <Scalar S, Scalar Given>
void set_core(Side<S>& side, const Point<Given>&, int) {
  side.support = &point_support<S>;
  side.vertex = &point_vertex<S>;
}
template <Scalar S, Scalar Given>
void set_core(Side<S>& side, const Sphere<Given>&, int k) {
  set_core(side, Point<Given>{}, k);
}
template <Scalar S, Scalar Given>
void set_core(Side<S>& side, const Box<Given>&, int) {
  side.support = &box_support<S>;
  side.vertex = &box_vertex<S>;
}
template <Scalar S, Scalar Given>
void set_core(Side<S>& side, const Hull<Given>& hull, int k) {
  side.support = &hull_support<S, Given>;
  side.vertex = &hull_vertex<S, Given>;
  side.hull = &hull;
  side.unit = static_cast<S>(std::ldexp(1.0, hull.exponent() - k));
}

// The matrix of a rotation as quickly as its error allows, or as accurately as doubles can hold it.
enum class Turning { quick, accurate };
inline constexpr int kQuickTurn = 19, kAccurateTurn = 5;

template <Scalar S, Scalar Given>
Side<S> make_side(const Body<Given>& body, const Bounds& bounds, int k, Turning turning) {
  Side<S> side;
  std::visit([&](const auto& shape) { set_core(side, shape, k); }, body.shape);
  const double unit = std::ldexp(1.0, -k);
  side.half = (unit * bounds.half).template cast<S>();
  side.middle = (unit * bounds.middle).template cast<S>();
  side.radius = static_cast<S>(unit * bounds.radius);
  const Quaternion<Given>& q = body.orientation;
  // A point's rotation about itself, and so a sphere's, cannot be seen.
  const Vec3<double> off = bounds.half + bounds.middle.cwiseAbs() + bounds.center.cwiseAbs();
  side.rotated = !q.is_identity() && off.maxCoeff() > 0;
  if (side.rotated) {
    const Quaternion<double> turn{double(q.w), double(q.x), double(q.y), double(q.z)};
    const bool accurate = turning == Turning::accurate;
    side.rotation = (accurate ? accurate_rotation_matrix(turn) : rotation_matrix(turn)).template cast<S>();
    side.turn = permutes_axes(turn) ? S(0) : static_cast<S>(accurate ? kAccurateTurn : kQuickTurn);
  }
  return side;
}

}  // namespace detail

// Valid while the two bodies live. Bodies must have passed validate().
template <Scalar S>
class Cso {
 public:
  template <Scalar Given>
  Cso(const Body<Given>& body_a, const Body<Given>& body_b, Given target_distance = 0,
      detail::Turning turning = detail::Turning::quick) {
    const auto bounds_of = [](const auto& shape) { return detail::bounds(shape); };
    const detail::Bounds a = std::visit(bounds_of, body_a.shape), b = std::visit(bounds_of, body_b.shape);
    const Vec3<double> d = detail::accurate_offset(
        body_a.position.template cast<double>(), as_double(body_a.orientation), a.center,
        body_b.position.template cast<double>(), as_double(body_b.orientation), b.center);
    const double size_a = 2 * (a.half.maxCoeff() + a.radius), size_b = 2 * (b.half.maxCoeff() + b.radius);
    const double apart = (d + turn(body_b, b.middle) - turn(body_a, a.middle)).cwiseAbs().maxCoeff();
    const double scale = std::max({size_a, size_b, apart});
    k_ = scale > 0 ? std::ilogb(scale) : 0;
    scale_ = scale > 0 ? static_cast<S>(std::ldexp(scale, -k_)) : S(0);
    a_ = detail::make_side<S>(body_a, a, k_, turning);
    b_ = detail::make_side<S>(body_b, b, k_, turning);
    d_ = (std::ldexp(1.0, -k_) * d).template cast<S>();
    const double target = std::ldexp(static_cast<double>(target_distance), -k_);
    target_ = static_cast<S>(target);
    radius_ = a_.radius + b_.radius + target_;
    const Vec3<double> v =
        body_b.displacement.template cast<double>() - body_a.displacement.template cast<double>();
    const double speed = v.cwiseAbs().maxCoeff();
    j_ = speed > 0 ? std::ilogb(speed) : 0;
    r_ = (std::ldexp(1.0, -j_) * v).template cast<S>();
  }

  // The core's support point along n (any length); the rounded C's, n a unit vector.
  [[nodiscard]] CsoPoint<S> support(const Vec3<S>& n) const {
    CsoPoint<S> out;
    out.vertex_a = a_.support(a_, a_.to_own(n));
    out.vertex_b = b_.support(b_, b_.to_own(-n));
    out.w = core_point(out.vertex_a, out.vertex_b);
    return out;
  }
  [[nodiscard]] CsoPoint<S> rounded_support(const Vec3<S>& unit_n) const {
    CsoPoint<S> out = support(unit_n);
    if (radius_ > 0) {
      out.e = unit_n;
      out.w += radius_ * unit_n;
    }
    return out;
  }

  [[nodiscard]] Vec3<S> core_point(std::uint32_t vertex_a, std::uint32_t vertex_b) const {
    return a_.to_world(a_.vertex(a_, vertex_a)) - (b_.to_world(b_.vertex(b_, vertex_b)) + d_);
  }
  // The middle of the core's bounds: inside C's bounds, and inside C for spheres, boxes and points.
  [[nodiscard]] Vec3<S> middle() const { return a_.to_world(a_.middle) - (b_.to_world(b_.middle) + d_); }

  [[nodiscard]] const Vec3<S>& direction() const { return r_; }  // r; zero if nothing moves
  [[nodiscard]] bool moves() const { return r_ != Vec3<S>::Zero(); }
  [[nodiscard]] S radius() const { return radius_; }
  [[nodiscard]] S target() const { return target_; }
  // In [1, 2) internal units (0 for two coinciding points), and within a factor 3 below the pair's scale: the
  // largest side of either box in its own axes, or the largest coordinate of the distance between their
  // centres.
  [[nodiscard]] S scale() const { return scale_; }
  // See above. `extent` is M, which also bounds |w|.
  [[nodiscard]] S extent() const { return a_.reach() + b_.reach() + d_.norm(); }
  [[nodiscard]] S point_error() const {
    return kUnitRoundoff<S> * (4 * extent() + a_.turn * a_.reach() + b_.turn * b_.reach());
  }
  // How far over |n| the vertices that the scans choose may lie below the greatest.
  [[nodiscard]] S choice_error() const {
    return kUnitRoundoff<S> * ((6 + 2 * a_.turn) * a_.reach() + (6 + 2 * b_.turn) * b_.reach());
  }
  [[nodiscard]] S reach_error() const {
    return S(1.75) * point_error() + 3 * kUnitRoundoff<S> * extent() + choice_error();
  }

  [[nodiscard]] const detail::Side<S>& side_a() const { return a_; }
  [[nodiscard]] const detail::Side<S>& side_b() const { return b_; }

  [[nodiscard]] int length_exponent() const { return k_; }
  [[nodiscard]] int speed_exponent() const { return j_; }
  // t = s 2^(k - j), and back; infinite where t_max is, or where it is out of S's range.
  [[nodiscard]] S to_time(S s) const { return static_cast<S>(std::ldexp(static_cast<double>(s), k_ - j_)); }
  [[nodiscard]] S to_parameter(S t) const {
    return static_cast<S>(std::ldexp(static_cast<double>(t), j_ - k_));
  }
  [[nodiscard]] S to_length(S internal) const {
    return static_cast<S>(std::ldexp(static_cast<double>(internal), k_));
  }

 private:
  template <Scalar Given>
  static Quaternion<double> as_double(const Quaternion<Given>& q) {
    return {double(q.w), double(q.x), double(q.y), double(q.z)};
  }
  template <Scalar Given>
  static Vec3<double> turn(const Body<Given>& body, const Vec3<double>& x) {
    if (body.orientation.is_identity()) return x;
    return detail::rotation_matrix(as_double(body.orientation)) * x;
  }

  detail::Side<S> a_, b_;
  Vec3<S> d_ = Vec3<S>::Zero(), r_ = Vec3<S>::Zero();
  S radius_ = 0, target_ = 0, scale_ = 0;
  int k_ = 0, j_ = 0;
};

}  // namespace graze
