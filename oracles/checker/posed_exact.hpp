// Posed bodies over any of the checker's arithmetics, free of division.
//
//   world point = position + M x / w,   M = the matrix of x -> q x conj(q),   w = |q|^2,
// Everything about A - B is computed for (wA wB)(a - b). This is one positive factor for all points of a
// case, so no comparison changes. q is given scaled by a power of two (its rotation is the same) so that its
// largest component lies in [1, 2).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <graze/body.hpp>
#include <graze/proof.hpp>
#include <span>

#include "oracles/arithmetic/filtered.hpp"
#include "oracles/arithmetic/number.hpp"

namespace graze::oracle {

// A core of finitely many vertices: a box by its half extents, else a list, a view of the hull's or its own.
// Empty for a point or a sphere at the origin.
struct Polytope {
  std::span<const Vec3<double>> given = {};
  std::array<Vec3<double>, 3> own;  // the first own_count, if that is not 0
  std::size_t own_count = 0;
  const Vec3<double>* half_extents = nullptr;
  Vec3<double> reach = Vec3<double>::Zero();  // max |x_i| over the list

  [[nodiscard]] std::span<const Vec3<double>> list() const {
    return own_count > 0 ? std::span<const Vec3<double>>(own.data(), own_count) : given;
  }
  [[nodiscard]] bool is_origin() const { return half_extents == nullptr && own_count == 0 && given.empty(); }
  [[nodiscard]] std::size_t count() const {
    return half_extents != nullptr ? 8 : is_origin() ? 1 : list().size();
  }
  [[nodiscard]] Vec3<double> vertex(std::size_t k) const {
    if (half_extents != nullptr) {
      const Vec3<double>& h = *half_extents;
      return {(k & 1) != 0 ? h.x() : -h.x(), (k & 2) != 0 ? h.y() : -h.y(), (k & 4) != 0 ? h.z() : -h.z()};
    }
    return is_origin() ? Vec3<double>::Zero() : list()[k];
  }
};

// A polytope plus a ball, of radius 0 without one.
struct Leaf {
  Polytope core;
  double radius = 0;
  bool has_ball = false;
};

// The data that the checker reads of a body whose shape is such a leaf.
struct Solid : Leaf {
  bool rotated = false;
  Quaternion<double> q = {};  // scaled, unused unless rotated
  const Vec3<double>* position = nullptr;
  const Vec3<double>* displacement = nullptr;
};

// The same rotation by a q whose largest component lies in [1, 2).
[[nodiscard]] inline Quaternion<double> scaled_to_one(const Quaternion<double>& q) {
  const double largest =
      std::max(std::max(std::abs(q.w), std::abs(q.x)), std::max(std::abs(q.y), std::abs(q.z)));
  const double scale = std::scalbn(1.0, -std::ilogb(largest));
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

// M by rows, and w. For a body that is not rotated w = 1 and M = 1, and neither is used.
template <class N>
struct Frame {
  bool rotated = false;
  N weight = N(1);
  Triple<N> row_x, row_y, row_z;

  Frame(bool is_rotated, const Quaternion<double>& q) : rotated(is_rotated) {
    if (!rotated) return;
    const N w(q.w), x(q.x), y(q.y), z(q.z);
    const N ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    const N x2 = x + x, y2 = y + y, z2 = z + z;
    const N xy = x2 * y, xz = x2 * z, yz = y2 * z, wx = w * x2, wy = w * y2, wz = w * z2;
    const N wx_sum = ww + xx, yz_sum = yy + zz, wx_diff = ww - xx, yz_diff = yy - zz;
    weight = wx_sum + yz_sum;
    row_x = {wx_sum - yz_sum, xy - wz, xz + wy};
    row_y = {xy + wz, wx_diff + yz_diff, yz - wx};
    row_z = {xz - wy, yz + wx, wx_diff - yz_diff};
  }

  // M x
  [[nodiscard]] Triple<N> apply(const Vec3<double>& x) const {
    if (!rotated) return triple<N>(x);
    return {dot(row_x, x), dot(row_y, x), dot(row_z, x)};
  }
  [[nodiscard]] Triple<N> apply(const Triple<N>& x) const {
    if (!rotated) return x;
    return {dot(row_x, x), dot(row_y, x), dot(row_z, x)};
  }
  // M^T n: n . (M x) = (M^T n) . x
  [[nodiscard]] Triple<N> into_body(const Triple<N>& n) const {
    if (!rotated) return n;
    return {row_x.x * n.x + row_y.x * n.y + row_z.x * n.z, row_x.y * n.x + row_y.y * n.y + row_z.y * n.z,
            row_x.z * n.x + row_y.z * n.y + row_z.z * n.z};
  }
};

// The two bodies of a case at t = 0, and v.
template <class N>
struct Pair {
  Frame<N> a, b;
  bool weighted;       // wA wB differs from 1
  N weight;            // wA wB
  Triple<N> offset;    // position_A - position_B
  Triple<N> velocity;  // displacement_B - displacement_A

  Pair(const Solid& solid_a, const Solid& solid_b)
      : a(solid_a.rotated, solid_a.q),
        b(solid_b.rotated, solid_b.q),
        weighted(a.rotated || b.rotated),
        weight(!weighted ? N(1) : a.weight * b.weight),
        offset(difference<N>(*solid_a.position, *solid_b.position)),
        velocity(difference<N>(*solid_b.displacement, *solid_a.displacement)) {}

  // wA wB s
  [[nodiscard]] N weigh(const N& s) const { return weighted ? weight * s : s; }
  [[nodiscard]] Triple<N> weigh(const Triple<N>& s) const { return weighted ? scaled(weight, s) : s; }
};

// A comparison of a hull's vertices along a direction, found in double. Open comparisons remain for the finer
// arithmetics.
struct Scan {
  Vec3<double> direction = Vec3<double>::Zero();
  // Every vertex that may be a maximum has direction.x >= threshold, however that product is rounded.
  double threshold = -kInfinity<double>;
};

[[nodiscard]] inline double scan_value(const Vec3<double>& d, const Vec3<double>& x) {
  return d.x() * x.x() + d.y() * x.y() + d.z() * x.z();
}

// max over the core's vertices x of n.x, n in the body's frame, first pass: fills `scan`.
//
// d_i the computed n_i, |n_i - d_i| <= e_i, X_i = max |x_i|. Every fl(d.x), fused or not, is within
//   3.01 u sum |d_i| X_i + sum e_i X_i + 2^-1072
// of n.x, so within `error` = 8 u sum |d_i| X_i + sum e_i X_i + 2^-1000, rounded up. The excess covers the
// rounding of the threshold, best - 2 error. Best is within `error` of the maximum.
[[nodiscard]] inline Filtered support(const Polytope& core, const Triple<Filtered>& n, Scan& scan) {
  if (core.half_extents != nullptr) {
    const Vec3<double>& h = *core.half_extents;
    return abs(n.x) * h.x() + abs(n.y) * h.y() + abs(n.z) * h.z();
  }
  if (core.is_origin()) return Filtered(0);
  scan.direction = {n.x.value(), n.y.value(), n.z.value()};
  const double bulk = std::abs(scan.direction.x()) * core.reach.x() +
                      std::abs(scan.direction.y()) * core.reach.y() +
                      std::abs(scan.direction.z()) * core.reach.z();
  const double inherited =
      n.x.error() * core.reach.x() + n.y.error() * core.reach.y() + n.z.error() * core.reach.z();
  if (!(bulk < 0x1p1000)) {  // overflow is near: every vertex stays a candidate
    scan.threshold = -kInfinity<double>;
    return {0, kInfinity<double>};
  }
  const double error = (8 * kUnitRoundoff<double> * bulk + inherited + 0x1p-1000) * Filtered::kUp;
  double best = -kInfinity<double>;
  for (const Vec3<double>& x : core.list()) {
    const double value = scan_value(scan.direction, x);
    best = value > best ? value : best;
  }
  scan.threshold = best - 2 * error;
  return {best, error};
}

// The same among the candidates that a scan left.
template <class N>
[[nodiscard]] N support(const Polytope& core, const Triple<N>& n, const Scan& scan) {
  if (core.half_extents != nullptr) {
    const Vec3<double>& h = *core.half_extents;
    return abs(n.x) * h.x() + abs(n.y) * h.y() + abs(n.z) * h.z();
  }
  if (core.is_origin()) return N(0);
  N best(0);
  bool found = false;
  for (const Vec3<double>& x : core.list()) {
    if (scan_value(scan.direction, x) < scan.threshold) continue;
    const N value = dot(n, x);
    best = found ? max(best, value) : value;
    found = true;
  }
  return best;
}

// (wA wB)(a - b) for a support pair.
template <class N>
[[nodiscard]] Triple<N> difference_point(const Pair<N>& pair, const Solid& a, const Solid& b,
                                         const Feature& fa, const Feature& fb) {
  Triple<N> at = pair.offset;
  if (a.has_ball) at = at + triple<N>(fa.offset);
  if (b.has_ball) at = at - triple<N>(fb.offset);
  at = pair.weigh(at);
  if (!a.core.is_origin()) {
    const Triple<N> x = pair.a.apply(a.core.vertex(fa.vertex));
    at = at + (pair.b.rotated ? scaled(pair.b.weight, x) : x);
  }
  if (!b.core.is_origin()) {
    const Triple<N> x = pair.b.apply(b.core.vertex(fb.vertex));
    at = at - (pair.a.rotated ? scaled(pair.a.weight, x) : x);
  }
  return at;
}

}  // namespace graze::oracle
