// Turns an answer into a proof, with only those claims that hold unconditionally for the true shapes.     Frame:
// world.
//
// The proof is computed in double for any scalar of the answer, on the CSO of the very same bodies. Each claim is
// moved outward by the rounding of the quantities it depends on, so the checker, which is exact, accepts it. If a
// claim cannot be made after that (a graze below the rounding), it is decided exactly if that is cheap, or omitted.
//
// Notation   h = h(n) + R |n|.   delta_h, delta_r, ... bounds on the rounding of h, n.r, ... .   s = t 2^(j - k).
#pragma once

#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/proving/pierce.hpp>
#include <graze/detail/search/robust/advancement.hpp>
#include <graze/detail/search/robust/refine_axis.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The radii of the rounded support points of a proof are shortened by kInside (tree.hpp), so that |offset| <= radius
// holds exactly: e is a unit vector within 4 u, and the product rounds once more. On a combinator the radius and the
// part's extent beyond it round as well, once each.
inline constexpr int kInsideTree = 16;  // u
template <Scalar S>
double inside_slack(const Body<S>& body) {
  return (exact::is_plain(body.shape) ? 8 : kInsideTree) * kUnitRoundoff<double>;
}

template <Scalar S>
struct ProofContext {
  const Body<S>&a, &b;
  const Cso<double>& cso;
  Vec3<double> r;
  double s_max, t_max;  // of the path, infinite for a ray
  double radius;        // r_A + r_B + m, world length
  bool plain;           // both cores are polytopes whose vertices have known exact coordinates

  double radius_a, radius_b;

  [[nodiscard]] double slack() const { return std::max(inside_slack(a), inside_slack(b)); }
  // n.(R x) for the vertex x of a body, as a sum of two doubles: within 2^-95 of |n| times the lengths in it.
  [[nodiscard]] static TwoDoubles along(const Vec3<double>& n, const Body<S>& body, std::uint32_t vertex) {
    const Vec3<double> x = exact::given_vertex(body, vertex);
    const Quaternion<S>& q = body.orientation;
    TwoDoubles3 turned = {TwoDoubles{x[0], 0}, TwoDoubles{x[1], 0}, TwoDoubles{x[2], 0}};
    if (!q.is_identity()) turned = rotate_accurately({double(q.w), double(q.x), double(q.y), double(q.z)}, x);
    TwoDoubles sum;
    for (int i = 0; i < 3; ++i) sum = sum + turned[static_cast<std::size_t>(i)] * TwoDoubles{n[i], 0};
    return sum;
  }
  // n.(p_A - p_B): the difference is exact, so a common offset costs nothing.
  [[nodiscard]] TwoDoubles apart(const Vec3<double>& n) const {
    TwoDoubles sum;
    for (int i = 0; i < 3; ++i) {
      sum = sum + two_sum(double(a.position[i]), -double(b.position[i])) * TwoDoubles{n[i], 0};
    }
    return sum;
  }
  // n.v, between two doubles. Both are 0 if every product is 0.
  struct Rate {
    double low, high;
  };
  [[nodiscard]] Rate rate(const Vec3<double>& n) const {
    TwoDoubles sum;
    double size = 0;
    for (int i = 0; i < 3; ++i) {
      const TwoDoubles term =
          two_sum(double(b.displacement[i]), -double(a.displacement[i])) * TwoDoubles{n[i], 0};
      sum = sum + term;
      size += std::abs(term.hi);
    }
    // The sums err by 2^-98 of their summands. A rounding of the result is 2^-53 of it.
    const double n_v = sum.hi + sum.lo,
                 predicate_error = 0x1p-90 * size + 2 * kUnitRoundoff<double> * std::abs(n_v);
    return {n_v - predicate_error, n_v + predicate_error};
  }
  // An upper bound of h(n) + R |n|, world length. It evaluates the vertices that the scan chose to the last bit, and
  // adds a bound for better ones that it may have missed (cso.hpp: n rotated, products compared, at both vertices).
  // On curved cores and combinators, it uses the support point and its error.
  [[nodiscard]] double reach(const Vec3<double>& n, Counters& counters) const {
    constexpr double u = kUnitRoundoff<double>;
    ++counters.supports;
    const CsoPoint<double> p = cso.support(n);
    if (!plain) {
      const double ball = cso.radius() * (1 + fl(2 * kInsideTree * u));
      return cso.to_length(dot(n, p.w) + fl(norm(n) * (1 + 8 * u) * (cso.reach_error() + ball)));
    }
    const TwoDoubles h = (along(n, a, p.vertex_a) + -along(n, b, p.vertex_b)) + apart(n);
    const double passed_over = cso.choice_error() + fl(4 * u * cso.radius()) + 0x1p-90 * lengths();
    const double rounded = norm(n) * (1 + 4 * u);
    return h.hi + fl((std::abs(h.lo) + fl(rounded * (cso.to_length(passed_over) + radius))) * (1 + 8 * u)) +
           fl(2 * u * std::abs(h.hi));
  }

 private:
  // The lengths that cancelled, internal units.
  [[nodiscard]] double lengths() const {
    const Vec3<double> between = a.position.template cast<double>() - b.position.template cast<double>();
    return std::ldexp(between.cwiseAbs().maxCoeff() + cso.side_a().center.cwiseAbs().maxCoeff() +
                          cso.side_b().center.cwiseAbs().maxCoeff(),
                      -cso.length_exponent()) +
           cso.extent();
  }
};

// cso: the CSO of the same bodies and target distance, with accurate rotations.
template <Scalar S>
ProofContext<S> proof_context(const Body<S>& a, const Body<S>& b, const Cso<double>& cso, double t_max,
                              double target_distance) {
  const double radius_a = common_radius(a.shape), radius_b = common_radius(b.shape);
  return {a,
          b,
          cso,
          cso.direction(),
          cso.moves() ? cso.to_parameter(t_max) : 0.0,
          t_max,
          radius_a + radius_b + target_distance,
          exact::is_plain(a.shape) && exact::is_plain(b.shape),
          radius_a,
          radius_b};
}

// The lower half, from n as it stands. Returns false if n proves nothing.
template <Scalar S>
bool prove_lower(const ProofContext<S>& c, const Vec3<double>& n, bool miss, Proof& proof,
                 Counters& counters) {
  constexpr double u = kUnitRoundoff<double>;
  if (!(n.cwiseAbs().maxCoeff() > 0)) return false;
  const double h = c.reach(n, counters);
  if (!(h < 0)) return false;
  const auto rate = c.rate(n);
  if (miss) {
    // h < min(0, T n.v)
    if (!(rate.low >= 0) && !(h < c.t_max * rate.low * (1 + 4 * u))) return false;
    proof.toi_lower = kInfinity<double>;
  } else {
    if (!(rate.high < 0)) return false;
    const double t = h / rate.low * (1 - 4 * u);
    if (!(t > proof.toi_lower && t < kInfinity<double>)) return false;
    proof.toi_lower = t;
  }
  proof.has_axis = true;
  proof.axis = n;
  return true;
}

// Rotates n until n.r >= 0: for a path without end only such an axis proves a miss. The loss is h(r) times the angle.
// It is 0 if C is left behind.
template <Scalar S>
Vec3<double> level(const ProofContext<S>& c, const Vec3<double>& n) {
  // |fl(n.r) - n.r| <= 6 u sum |n_i r_i|: r's own rounding, three products, two sums. It is doubled for the rounding
  // of the rotation.
  const double predicate_error = fl(12 * kUnitRoundoff<double> * norm_1(scaled_by_axis(n, c.r)));
  const double excess = -(dot(n, c.r) - predicate_error), length_sq = squared_norm(c.r);
  return excess > 0 && length_sq > 0 ? Vec3<double>(n + c.r * (excess / length_sq * (1 + 1e-15))) : n;
}

// An axis for a miss, by the distance of C from the whole path: GJK on C swept along -r.
template <Scalar S>
void prove_miss(const ProofContext<S>& c, const Vec3<double>& hint, Proof& proof, Counters& counters) {
  const bool ray = !(c.s_max < kInfinity<double>);
  if (prove_lower(c, hint, true, proof, counters)) return;
  if (ray && prove_lower(c, level(c, hint), true, proof, counters)) return;
  double s_end = c.s_max;
  if (const double length_sq = squared_norm(c.r); length_sq > 0) {
    // No contact is later: s r.r <= h(r) + R |r|.
    s_end = std::min(s_end, std::max(dot(c.cso.support(c.r).w, c.r) + fl(c.cso.radius() * norm(c.r)), 0.0) /
                                length_sq * (1 + 1e-12));
  }
  const auto swept = [&](const Vec3<double>& n) {
    CsoPoint<double> p = c.cso.support(n);
    if (dot(n, c.r) < 0) {
      p.w -= s_end * c.r;
      p.e = Vec3<double>::UnitX();  // distinguishes the two ends of a sweep
    }
    return p;
  };
  Simplex<double> simplex;
  const Vec3<double> start = -(c.cso.middle() - (s_end / 2) * c.r);
  Distance<double> d = gjk_distance(swept, Vec3<double>(Vec3<double>::Zero()), start, simplex, 0.0,
                                    c.cso.radius(), 256, counters);
  const auto is_proved = [&] {
    return prove_lower(c, d.n, true, proof, counters) || prove_lower(c, level(c, d.n), true, proof, counters);
  };
  if (is_proved() || simplex.size == 4) return;
  turn_axis(d, swept, simplex, 0.0, counters);
  is_proved();
}

// The exact name of a side's part in a support point along n, e = n / |n|. False if it has none: too many
// curved parts.
template <Scalar S>
bool name_feature(const Body<S>& body, const Side<double>& side, std::uint32_t vertex, const Vec3<double>& n,
                  const Vec3<double>& e, double radius, Feature& out) {
  out.vertex = vertex;
  if (!side.curved) {
    out.offset = e * (radius * (1 - inside_slack(body)));
    return true;
  }
  // Rotated and scaled bit for bit as the side did it. If two points of a part tie, as at the rims of a cylinder seen
  // from its side, another rounding of n returns the other point.
  const Vec3<double> own = side.to_own(n);
  TreeWalk<S> walk(side.is_curved_tree() ? walked_along(own) : own, &out);
  const TreePoint p = walk(body.shape, Placement{side.turning}, &vertex);
  out.offset = unit(n) * ((radius + p.excess.hi) * (1 - inside_slack(body)));
  return walk.curved_parts() <= kCurvedParts;
}

template <Scalar S>
bool name_pair(const ProofContext<S>& c, const CsoPoint<double>& p, SupportPair& out) {
  return name_feature(c.a, c.cso.side_a(), p.vertex_a, p.n, p.e, c.radius_a, out.a) &&
         name_feature(c.b, c.cso.side_b(), p.vertex_b, Vec3<double>(-p.n), Vec3<double>(-p.e), c.radius_b,
                      out.b);
}

// Is the line's point in the portal beyond all rounding, and what is its latest t? Infinite if neither can be
// decided.
//
// The projection of each corner is known within `e` per coordinate. This is its own error, 8 u of its length for the
// product, the frame and r, and the error of the features' names. The last is `slack` of R. On a curved core it is
// also `slack` of its own extent, once more for the point that they name. The product cross(q_i, q_j) is then within
// 2 e (|q_i| + |q_j|) + 4 e^2, which decides whether 0 is inside.
//
// The height of the plane at 0: with weights l and slope g, moving corner i by d moves it by l_i (d_z - g.d_xy), to
// first order. So it moves by at most e (1 + |g|_1) in all, however thin the triangle. While e is below 1/64 of the
// least altitude, the second order is less than a sixteenth of that. The remainder of the rounded weights, rho = sum
// l q, is corrected by g.rho.
//
// The slope g rounds, too. L is the longest edge, l its projection's length, h the least altitude, G = 1 + |g|_1. The
// function face_normal() leaves 6 u |n| along the longest edge and 2 u L^2 across it. For g, that is 6 u G L / l and
// 2 u G L^2 / (l h). The remainder rho is within 6 u l^2 / h along and, 0 being inside, 6 u l across. The product is
// 48 u^2 G L^2 / h in all. As L <= 2 extent and h > 64 e >= 512 u extent, it is less than u extent G / 2.
//
// `q`: the corners as seen along the line, third the height along it, each within e per coordinate and none farther
// out than `extent`. `sure`: 0 is inside, and the plane's height there is within `error` of z.
struct HeightAtLine {
  bool sure = false;
  double z = 0, error = 0;
};
inline HeightAtLine height_at_line(const std::array<Vec3<double>, 3>& q, double e, double extent) {
  constexpr double u = kUnitRoundoff<double>;
  HeightAtLine out;
  double area = 0, side = 0;
  std::array<double, 3> l;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double>&a = q[(i + 1) % 3], &b = q[(i + 2) % 3];
    const double across = std::abs(a[0]) + std::abs(a[1]) + std::abs(b[0]) + std::abs(b[1]);
    l[i] = cross2(a, b);
    if (!(l[i] > fl(2 * e * across) + fl(4 * e * e))) return out;
    area += l[i];
    side = std::max(side, hypotenuse(a[0] - b[0], a[1] - b[1]));
  }
  if (!(64 * e * side < area)) return out;
  const Vec3<double> n = face_normal(q[0], q[1], q[2]);
  const double gx = -n[0] / n[2], gy = -n[1] / n[2];
  double z = 0, rho_x = 0, rho_y = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    z += fl(l[i] / area * q[i][2]);
    rho_x += fl(l[i] / area * q[i][0]);
    rho_y += fl(l[i] / area * q[i][1]);
  }
  out.z = z - (fl(gx * rho_x) + fl(gy * rho_y));
  out.error = (fl(1.25 * e) + fl(5 * u * extent)) * (1 + std::abs(gx) + std::abs(gy));
  out.sure = true;
  return out;
}

inline double filtered_upper(const Cso<double>& cso, const Portal<double>& portal, double length,
                             double z_max, double slack) {
  constexpr double u = kUnitRoundoff<double>;
  const double extent = cso.extent() + cso.radius();
  const double e =
      cso.point_error() + fl(8 * u * extent) + fl(slack * (cso.curved() ? 2 * extent : cso.radius()));
  const HeightAtLine at = height_at_line({portal.p[0].q, portal.p[1].q, portal.p[2].q}, e, extent);
  if (!at.sure || !(at.z - at.error >= 0 && at.z + at.error <= z_max * (1 - 4 * u))) return kInfinity<double>;
  return cso.to_time((at.z + at.error) / length * (1 + 8 * u));
}

// The upper half, and the lower bound that follows from its search: a portal of three points. Every sign of it is
// beyond its rounding, or, for a tie, exact.
template <Scalar S>
void prove_upper(const ProofContext<S>& c, Proof& proof, Counters& counters) {
  if (!(c.s_max > 0)) return;
  const Frame<double> frame(c.r);
  const double z_max = c.s_max * frame.length;
  const double gap = 4 * kUnitRoundoff<double> * c.cso.scale();
  const PortalSearch<double> search = enter_line(c.cso, frame, z_max, gap, 256, counters);
  // Its normals are as good as the method's own, or better.
  prove_lower(c, search.n, false, proof, counters);
  prove_lower(c, search.facing, false, proof, counters);
  if (search.portal.size != 3) return;
  double t = filtered_upper(c.cso, search.portal, frame.length, z_max, c.slack());
  for (std::size_t i = 0; i < 3; ++i) {
    if (!name_pair(c, search.portal.p[i].c, proof.portal[i])) return;
  }
  if (!(t < kInfinity<double>)&&c.plain && !(c.cso.radius() > 0)) {
    const exact::Pierced pierced =
        exact::pierce(c.a, c.b, proof.portal, c.t_max, c.cso.length_exponent(), c.cso.speed_exponent());
    if (pierced.pierced) t = pierced.t_upper;
  }
  if (!(t < kInfinity<double>)) return;
  proof.toi_upper = t;
  proof.portal_size = 3;
}

// Adds the final axis of the GJK ray cast if the axes so far leave a gap below the answer. Steep axes of MPR do so at
// an edge (their rounding counts by |n| |r| / -n.r). The added axis points from C towards the path. If the path comes
// in along a flat side, over its rim, this axis is the side's normal, which is no better. The rim is found from a
// point of the path before it, somewhere in the gap.
template <Scalar S>
void prove_nearer(const ProofContext<S>& c, double toi_upper, Proof& proof, Counters& counters) {
  constexpr double kGap = 16 * kUnitRoundoff<double>;  // relative to scale: a smaller gap is not worth a
                                                       // second search
  constexpr int kHalvings = 8;
  const double upper = std::min(toi_upper, proof.toi_upper), speed = norm(c.r);
  const auto is_near = [&] {
    return !(c.cso.to_parameter(upper - proof.toi_lower) * speed > kGap * c.cso.scale());
  };
  if (!c.cso.moves() || is_near()) return;
  CastOptions<double> options;
  options.t_max = c.t_max;
  const Sweep<double> sweep =
      gjk_ray_cast(c.cso, sweep_limits(c.cso, options), 0.0, Vec3<double>(Vec3<double>::Zero()), counters);
  prove_lower(c, sweep.n, false, proof, counters);
  const auto distance_at = [&](double t) {
    Simplex<double> simplex;
    return gjk_distance(c.cso, Vec3<double>(c.cso.to_parameter(t) * c.r), simplex, 0.0, 0.0,
                        options.max_iterations, counters);
  };
  const auto is_apart = [&] {
    return distance_at(proof.toi_lower).upper - c.cso.radius() >
           kContact * kUnitRoundoff<double> * c.cso.scale();
  };
  if (is_near() || !(upper < kInfinity<double>) || !is_apart()) return;  // an infinite interval has no middle
  double high = upper;
  for (int i = 0; i < kHalvings && !is_near(); ++i) {
    const double low = proof.toi_lower, middle = low + (high - low) / 2;
    prove_lower(c, distance_at(middle).n, false, proof, counters);
    if (!(proof.toi_lower > low)) high = middle;
  }
}

// Contact at t = 0: four points around the origin, every volume beyond its rounding.
template <Scalar S>
void prove_start(const ProofContext<S>& c, Proof& proof, Counters& counters) {
  Simplex<double> simplex;
  const auto rounded = [&](const Vec3<double>& n) { return c.cso.rounded_support(unit(n)); };
  const Vec3<double> start = -c.cso.middle();
  gjk_distance(rounded, Vec3<double>(Vec3<double>::Zero()), start, simplex, 0.0, 0.0, 256, counters);
  if (simplex.size != 4) return;
  double longest = 0;
  for (const auto& p : simplex.point) longest = std::max(longest, norm_1(p.w));
  const double e = c.cso.point_error() +
                   fl((8 * kUnitRoundoff<double> + c.slack()) * (longest + c.cso.radius())) +
                   (c.cso.curved() ? 2 * c.slack() * c.cso.extent() : 0.0);
  // det(a, b, c) of three points within e each: |error| <= 3 e (2 longest)^2, and 8 u of the product itself.
  const double error = 16 * e * longest * longest;
  double side = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double>&a = simplex.point[(i + 1) % 4].w, &b = simplex.point[(i + 2) % 4].w,
          &d = simplex.point[(i + 3) % 4].w;
    const double volume = (i % 2 == 0 ? 1 : -1) * dot(a, cross(b, d));
    if (!(std::abs(volume) > error) || side * volume < 0) return;
    side = volume;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (!name_pair(c, simplex.point[i], proof.portal[i])) return;
  }
  proof.toi_upper = 0;
  proof.portal_size = 4;
}

// Under pass_over a start in contact that leaves voids every contact, and no proof can express that a start does not
// leave. Without a lower bound above 0 the proof has no upper claim.
[[nodiscard]] inline Proof under_policy(Proof proof, StartPolicy policy) {
  if (policy == StartPolicy::pass_over && !(proof.toi_lower > 0)) {
    proof.toi_upper = kInfinity<double>;
    proof.portal_size = 0;
  }
  return proof;
}

// n: the axis that the method found (world axes, from A to B), or zero. toi_upper: the method's answer. An axis that
// proves more does not replace it: a hit that is a miss by less than the rounding stays one answer.
template <Scalar S>
Proof prove(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, Outcome outcome, S toi_upper,
            const Vec3<S>& n, Counters& counters) {
  const Cso<double> cso(a, b, options.target_distance, Turning::accurate);
  const ProofContext<S> context = proof_context(a, b, cso, static_cast<double>(options.t_max),
                                                static_cast<double>(options.target_distance));
  const auto axis = n.template cast<double>().eval();
  Proof proof;
  if (outcome == Outcome::miss) {
    prove_miss(context, axis, proof, counters);
  } else if (outcome == Outcome::initially_overlapping) {
    prove_start(context, proof, counters);
  } else if (outcome == Outcome::hit || outcome == Outcome::not_converged) {
    prove_lower(context, axis, false, proof, counters);
    prove_upper(context, proof, counters);
    prove_nearer(context, static_cast<double>(toi_upper), proof, counters);
    proof.toi_lower = std::min({proof.toi_lower, static_cast<double>(toi_upper), context.t_max});
  }
  return under_policy(proof, options.start_policy);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
