// From an answer to a proof: only what holds without condition for the true shapes.     Frame: world.
//
// Everything is done in double whatever scalar found the answer, on the CSO of the very same bodies. Each
// claim is moved outward by the rounding of what it rests on, so the checker, which is exact, accepts it;
// where a claim cannot be made after that (a graze below the rounding), it is decided exactly where that is
// cheap, or left out.
//
// Notation   h = h(n) + R |n|;   delta_h, delta_r, ... bounds on the rounding of h, n.r, ... ;   s = t 2^(j -
// k).
#pragma once

#include <graze/exact/portal_sign.hpp>
#include <graze/sweep.hpp>

namespace graze {

namespace detail {

// The radii of the rounded support points of a proof are shortened by this factor, so that |offset| <= radius
// holds exactly: e is a unit vector within 4 u, and the product rounds once more.
inline constexpr double kInside = 1 - 8 * kUnitRoundoff<double>;

struct ProofContext {
  const Cso<double>& cso;
  Vec3<double> r;
  double s_max;  // of the path; infinite for a ray
  // |fl(n.r) - n.r| <= 5 u sum |n_i r_i|: r's own rounding, three products, two sums.
  [[nodiscard]] double delta_r(const Vec3<double>& n) const {
    return 6 * kUnitRoundoff<double> * n.cwiseProduct(r).cwiseAbs().sum();
  }
  // An upper bound of h(n) + R |n|.
  [[nodiscard]] double reach(const Vec3<double>& n, Counters& counters) const {
    ++counters.supports;
    const double size = n.norm();
    const double h = n.dot(cso.support(n).w) + cso.radius() * size;
    // R is a sum of three rounded terms, |n| is within 3 u, their product and the last sum round once each.
    return h + size * (cso.reach_error() + 8 * kUnitRoundoff<double> * (cso.radius() + cso.extent())) *
                   (1 + 8 * kUnitRoundoff<double>);
  }
};

// The lower half, from n as it stands. Returns false if n proves nothing.
inline bool prove_lower(const ProofContext& c, const Vec3<double>& n, bool miss, Proof& proof,
                        Counters& counters) {
  if (!(n.cwiseAbs().maxCoeff() > 0)) return false;
  const double h = c.reach(n, counters);
  if (!(h < 0)) return false;
  const double rate = n.dot(c.r) - c.delta_r(n);  // at most n.r
  if (miss) {
    // h < min(0, s_max n.r)
    if (!(rate >= 0) && !(h < c.s_max * (1 + 4 * kUnitRoundoff<double>)*rate)) return false;
    proof.toi_lower = kInfinity<double>;
  } else {
    if (!(n.dot(c.r) + c.delta_r(n) < 0)) return false;
    const double t = c.cso.to_time(h / rate * (1 - 8 * kUnitRoundoff<double>));
    if (!(t > proof.toi_lower)) return false;
    proof.toi_lower = t;
  }
  proof.has_axis = true;
  proof.axis = n;
  return true;
}

// n turned until n.r >= 0: for a path without end only such an axis proves a miss. What it costs is h(r)
// times the turn, which is nothing where C is left behind.
inline Vec3<double> level(const ProofContext& c, const Vec3<double>& n) {
  const double excess = -(n.dot(c.r) - 2 * c.delta_r(n)), length_sq = c.r.squaredNorm();
  return excess > 0 && length_sq > 0 ? Vec3<double>(n + c.r * (excess / length_sq * (1 + 1e-15))) : n;
}

// An axis for a miss, by the distance of C from the whole path: GJK on C swept along -r.
inline void prove_miss(const ProofContext& c, const Vec3<double>& hint, Proof& proof, Counters& counters) {
  const bool ray = !(c.s_max < kInfinity<double>);
  if (prove_lower(c, hint, true, proof, counters)) return;
  if (ray && prove_lower(c, level(c, hint), true, proof, counters)) return;
  double s_end = c.s_max;
  if (const double length_sq = c.r.squaredNorm(); length_sq > 0) {
    // No contact is later: s r.r <= h(r) + R |r|.
    s_end = std::min(s_end, std::max(c.reach(c.r, counters), 0.0) / length_sq);
  }
  const auto swept = [&](const Vec3<double>& n) {
    CsoPoint<double> p = c.cso.support(n);
    if (n.dot(c.r) < 0) {
      p.w -= s_end * c.r;
      p.e = Vec3<double>::UnitX();  // tells the two ends of a sweep apart
    }
    return p;
  };
  Simplex<double> simplex;
  const Vec3<double> start = -(c.cso.middle() - (s_end / 2) * c.r);
  const Distance<double> d = gjk_distance(swept, Vec3<double>(Vec3<double>::Zero()), start, simplex, 0.0,
                                          c.cso.radius(), 256, counters);
  if (prove_lower(c, d.n, true, proof, counters)) return;
  prove_lower(c, level(c, d.n), true, proof, counters);
}

template <Scalar S>
double radius_of(const Body<S>& body) {
  return std::visit([](const auto& shape) { return bounds(shape).radius; }, body.shape);
}

inline SupportPair pair_of(const CsoPoint<double>& p, double radius_a, double radius_b) {
  SupportPair out;
  out.a.vertex = p.vertex_a;
  out.b.vertex = p.vertex_b;
  out.a.offset = p.e * (radius_a * kInside);
  out.b.offset = p.e * (-radius_b * kInside);
  return out;
}

// Is the line's point in the portal beyond all rounding, and at which t at the latest? Infinite if neither
// can be said.
//
// The projection of each corner is known within `e` per coordinate = its own error, 8 u of its length for the
// product, the frame and r, and 8 u R that kInside takes; cross(q_i, q_j) then within 2 e (|q_i| + |q_j|) + 4
// e^2: that decides whether 0 is inside. The height of the plane at 0: with weights l and slope g, moving
// corner i by d moves it by l_i (d_z - g.d_xy), to first order, so by at most e (1 + |g|_1) in all, however
// thin the triangle. While e is below 1/64 of the least altitude, the second order is less than a sixteenth
// of that. What the rounded weights leave, rho = sum l q, is taken back by g.rho.
inline double filtered_upper(const ProofContext& c, const Portal<double>& portal, double length,
                             double z_max) {
  constexpr double u = kUnitRoundoff<double>;
  const double extent = c.cso.extent() + c.cso.radius();
  const double e = c.cso.point_error() + 8 * u * extent + 8 * u * c.cso.radius();
  double area = 0, side = 0;
  std::array<double, 3> l;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double>&a = portal.p[(i + 1) % 3].q, &b = portal.p[(i + 2) % 3].q;
    const double across = std::abs(a[0]) + std::abs(a[1]) + std::abs(b[0]) + std::abs(b[1]);
    l[i] = cross2(a, b);
    if (!(l[i] > 2 * e * across + 4 * e * e)) return kInfinity<double>;
    area += l[i];
    side = std::max(side, std::hypot(a[0] - b[0], a[1] - b[1]));
  }
  if (!(64 * e * side < area)) return kInfinity<double>;
  const Vec3<double> n = face_normal(portal.p[0].q, portal.p[1].q, portal.p[2].q);
  const double gx = -n[0] / n[2], gy = -n[1] / n[2];
  double z = 0, rho_x = 0, rho_y = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double>& q = portal.p[i].q;
    z += l[i] / area * q[2];
    rho_x += l[i] / area * q[0];
    rho_y += l[i] / area * q[1];
  }
  z -= gx * rho_x + gy * rho_y;
  const double z_error = (1.25 * e + 4 * u * extent) * (1 + std::abs(gx) + std::abs(gy));
  if (!(z - z_error >= 0 && z + z_error <= z_max * (1 - 4 * u))) return kInfinity<double>;
  return c.cso.to_time((z + z_error) / length * (1 + 8 * u));
}

// The upper half, and what the search for it tells of the lower: a portal of three points, every sign of it
// beyond its rounding, or, where there is a tie, exact.
template <Scalar S>
void prove_upper(const ProofContext& c, const Body<S>& a, const Body<S>& b, double t_max, Proof& proof,
                 Counters& counters) {
  if (!(c.s_max > 0)) return;
  const Frame<double> frame(c.r);
  const double z_max = c.s_max * frame.length;
  const double gap = 4 * kUnitRoundoff<double> * c.cso.scale();
  const PortalSearch<double> search = enter_line(c.cso, frame, z_max, gap, 256, counters);
  // Its normals are as good as the method's own, or better.
  prove_lower(c, search.n, false, proof, counters);
  prove_lower(c, search.facing, false, proof, counters);
  if (search.portal.size != 3) return;
  double t = filtered_upper(c, search.portal, frame.length, z_max);
  const double radius_a = radius_of(a), radius_b = radius_of(b);
  for (std::size_t i = 0; i < 3; ++i) proof.portal[i] = pair_of(search.portal.p[i].c, radius_a, radius_b);
  if (!(t < kInfinity<double>)&&!(c.cso.radius() > 0)) {
    const exact::Pierced pierced =
        exact::pierce(a, b, proof.portal, t_max, c.cso.length_exponent(), c.cso.speed_exponent());
    if (pierced.pierced) t = pierced.t_upper;
  }
  if (!(t < kInfinity<double>)) return;
  proof.toi_upper = t;
  proof.portal_size = 3;
}

// Contact at t = 0: four points around the origin, every volume beyond its rounding.
inline void prove_start(const ProofContext& c, double radius_a, double radius_b, Proof& proof,
                        Counters& counters) {
  Simplex<double> simplex;
  const auto rounded = [&](const Vec3<double>& n) { return c.cso.rounded_support(unit(n)); };
  const Vec3<double> start = -c.cso.middle();
  gjk_distance(rounded, Vec3<double>(Vec3<double>::Zero()), start, simplex, 0.0, 0.0, 256, counters);
  if (simplex.size != 4) return;
  double longest = 0;
  for (const auto& p : simplex.point) longest = std::max(longest, p.w.cwiseAbs().sum());
  const double e = c.cso.point_error() + 16 * kUnitRoundoff<double> * (longest + c.cso.radius());
  // det(a, b, c) of three points within e each: |error| <= 3 e (2 longest)^2, and 8 u of the product itself.
  const double error = 16 * e * longest * longest;
  double side = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double>&a = simplex.point[(i + 1) % 4].w, &b = simplex.point[(i + 2) % 4].w,
          &d = simplex.point[(i + 3) % 4].w;
    const double volume = (i % 2 == 0 ? 1 : -1) * a.dot(b.cross(d));
    if (!(std::abs(volume) > error) || side * volume < 0) return;
    side = volume;
  }
  proof.toi_upper = 0;
  proof.portal_size = 4;
  for (std::size_t i = 0; i < 4; ++i) proof.portal[i] = pair_of(simplex.point[i], radius_a, radius_b);
}

}  // namespace detail

// n: the axis that the method found (world axes, from A to B), or zero.
template <Scalar S>
Proof prove(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, Outcome outcome,
            const Vec3<S>& n, Counters& counters) {
  const Cso<double> cso(a, b, options.target_distance);
  const detail::ProofContext context{
      cso, cso.direction(), cso.moves() ? cso.to_parameter(static_cast<double>(options.t_max)) : 0.0};
  const auto axis = n.template cast<double>().eval();
  Proof proof;
  if (outcome == Outcome::miss) {
    detail::prove_miss(context, axis, proof, counters);
  } else if (outcome == Outcome::initially_overlapping) {
    detail::prove_start(context, detail::radius_of(a), detail::radius_of(b), proof, counters);
  } else if (outcome == Outcome::hit || outcome == Outcome::not_converged) {
    detail::prove_lower(context, axis, false, proof, counters);
    detail::prove_upper(context, a, b, static_cast<double>(options.t_max), proof, counters);
  }
  return proof;
}

}  // namespace graze
