// Proves contact of two placed bodies by pairs of support points that hold the origin between them.
//
// Lengths: internal. e bounds the distance of a support point from the point of the true CSO that its feature names,
// R is the sum of the radii and the target distance. Contact holds in either of two cases:
//   - |sum l_i w_i| + e <= R: the closest point of the cores is near enough.
//   - the ball of radius e about the origin lies inside the tetrahedron of four support points. Then h(n) > e
//     for every unit n, and moving each point by up to e leaves h > 0. One of the four may be the mean of several,
//     if no four hold the origin: below the tip of an octahedron every four have it on their border.
#pragma once

#include <bit>
#include <graze/detail/proving/prove.hpp>
#include <graze/detail/rotating/moving_pair.hpp>
#include <graze/detail/search/robust/gjk.hpp>
#include <graze/detail/search/robust/refine_axis.hpp>
#include <graze/detail/search/robust/sweep.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct Contact {
  bool proved = false;
  Simplex<double> pairs;   // weighted, except for a crossing
  bool unweighed = false;  // four that hold the origin, before weigh()
  // The last of four points is the mean of these, if there are any.
  std::array<CsoPoint<double>, 3> mean_of;
  std::size_t means = 0;
  bool crossing = false;  // crossing.hpp: between `from` and the time of the contact
  double from = 0;
};

// Error bound of a named support point.
inline double contact_error(const MovingPair& pair) {
  const Cso<double>& cso = pair.cso();
  constexpr double u = kUnitRoundoff<double>;
  return 2 * cso.point_error() + (cso.curved() ? 2 * kInsideTree * u * cso.extent() : 0.0) +
         fl(8 * u * (pair.radius() + norm(cso.offset()))) + pair.offset_error();
}

// det(a, b, c), within u of itself and 2^-96 |a| |b| |c|.
template <bool kFused>
[[gnu::flatten]] double determinant_in_pairs(const Vec3<double>& a, const Vec3<double>& b,
                                             const Vec3<double>& c) {
  TwoDoubles sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum = sum +
          multiplied<kFused>({a[i], 0}, two_product<kFused>(b[j], c[k]) + -two_product<kFused>(b[k], c[j]));
  }
  return sum.hi + sum.lo;
}
inline double determinant(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  return fuses() ? determinant_in_pairs<true>(a, b, c) : determinant_in_pairs<false>(a, b, c);
}

// The least distance of the origin from the faces of a tetrahedron that holds it, less its rounding. Negative if it
// does not hold the origin, or if that cannot be decided. It is |det(a, b, c)| / |m| for the face a b c with the
// normal m. Only the length of m is used, and the result is within 8 u longest^2 / |m| of itself.
inline double depth_inside(const std::array<Vec3<double>, 4>& w) {
  constexpr double u = kUnitRoundoff<double>;
  double least = kInfinity<double>, side = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double>&a = w[(i + 1) % 4], &b = w[(i + 2) % 4], &c = w[(i + 3) % 4];
    const double area = norm(face_normal(a, b, c));
    const double longest = std::max({squared_norm(a - b), squared_norm(b - c), squared_norm(c - a)});
    if (!(area > 64 * u * longest)) return -1;
    const double volume = (i % 2 == 0 ? 1 : -1) * determinant(a, b, c);
    if (!(volume * side >= 0)) return -1;
    side = volume;
    const double known = std::abs(volume) - fl(0x1p-90 * norm(a) * norm(b) * norm(c));
    least = std::min(least, known / (area + fl(8 * u * longest)) * (1 - 16 * u));
  }
  return least;
}

// A tetrahedron of support points that holds the origin, made deeper: the support beyond the face that the
// origin is nearest to takes the place of the corner for which it holds deepest. Until the depth exceeds e, C
// is no deeper there, or no corner's place is better. Gives the depth. `beyond`: the last support.
inline double deepen(const Cso<double>& cso, Simplex<double>& four, double e, Counters& counters,
                     CsoPoint<double>& beyond) {
  constexpr int kSteps = 24;
  const auto depth_of = [](const Simplex<double>& s) {
    return depth_inside({s.point[0].w, s.point[1].w, s.point[2].w, s.point[3].w});
  };
  double best = depth_of(four);
  for (int step = 0; step < kSteps && !(best > e); ++step) {
    Vec3<double> out = Vec3<double>::Zero();
    double least = kInfinity<double>;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3<double>&a = four.point[(i + 1) % 4].w, &b = four.point[(i + 2) % 4].w,
            &c = four.point[(i + 3) % 4].w;
      const Vec3<double> m = face_normal(a, b, c);
      const double area = norm(m), height = std::abs(determinant(a, b, c)) / area;
      if (!(height < least)) continue;
      least = height;
      out = (dot(m, four.point[i].w - a) > 0 ? -1 : 1) / area * m;
    }
    if (out == Vec3<double>::Zero()) return best;
    ++counters.supports;
    beyond = cso.support(out);
    if (!(dot(out, beyond.w) > e)) return best;
    const Simplex<double> before = four;
    const double depth = best;
    for (std::size_t i = 0; i < 4; ++i) {
      Simplex<double> tried = before;
      tried.point[i] = beyond;
      if (const double d = depth_of(tried); d > best) {
        best = d;
        four = tried;
      }
    }
    if (!(best > depth)) return best;
  }
  return best;
}

// To a triangle that the origin is in, the support farthest from its plane.
inline void add_above(const Cso<double>& cso, Simplex<double>& three, Counters& counters) {
  const Vec3<double> a = three.point[0].w, m = face_normal(a, three.point[1].w, three.point[2].w);
  if (m == Vec3<double>::Zero()) return;
  const Vec3<double> n = unit(m);
  counters.supports += 2;
  const CsoPoint<double> above = cso.support(n), below = cso.support(Vec3<double>(-n));
  three.add(dot(n, above.w - a) > dot(n, a - below.w) ? above : below);
}

// For two points with the origin between them, as on bodies that meet along a common axis of revolution. Adds
// supports in three directions around them, and keeps the four that hold the origin deepest, if any do.
inline void add_around(const Cso<double>& cso, Simplex<double>& two, Counters& counters) {
  const Vec3<double> along = two.point[1].w - two.point[0].w;
  if (along == Vec3<double>::Zero()) return;
  const Frame<double> about(unit(along));
  constexpr std::array<std::array<double, 2>, 3> kAround = {{{1, 0}, {-0.5, 0.875}, {-0.5, -0.875}}};
  std::array<CsoPoint<double>, 5> all = {two.point[0], two.point[1]};
  for (std::size_t i = 0; i < 3; ++i) {
    ++counters.supports;
    all[2 + i] = cso.support(unit(Vec3<double>(kAround[i][0] * about.e1 + kAround[i][1] * about.e2)));
  }
  double best = 0;
  for (std::size_t skip = 0; skip < all.size(); ++skip) {
    Simplex<double> tried;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i != skip) tried.add(all[i]);
    }
    const auto& p = tried.point;
    const double depth = depth_inside({p[0].w, p[1].w, p[2].w, p[3].w});
    if (!(depth > best)) continue;
    best = depth;
    two = tried;
  }
}

// Weights of the origin in a tetrahedron, by volumes. They are computed in two doubles, as those of a thin
// tetrahedron are small differences.
inline void weigh(Simplex<double>& pairs) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    pairs.lambda[i] = std::abs(
        determinant(pairs.point[(i + 1) % 4].w, pairs.point[(i + 2) % 4].w, pairs.point[(i + 3) % 4].w));
    sum += pairs.lambda[i];
  }
  for (double& l : pairs.lambda) l = sum > 0 ? l / sum : 0.25;
}

// The corners of two portals. A line through the origin enters C by one and leaves by the other.
using CornersAround = std::array<CsoPoint<double>, 6>;

// Selects the four of these that hold the origin deepest. 0: no four hold it.
inline double surround(const CornersAround& all, Simplex<double>& four) {
  double best = 0;
  for (std::size_t skip = 0; skip < 6; ++skip) {
    for (std::size_t also = skip + 1; also < 6; ++also) {
      Simplex<double> tried;
      for (std::size_t i = 0; i < 6; ++i) {
        if (i != skip && i != also) tried.add(all[i]);
      }
      const auto& p = tried.point;
      const double depth = depth_inside({p[0].w, p[1].w, p[2].w, p[3].w});
      if (!(depth > best)) continue;
      best = depth;
      four = tried;
    }
  }
  return best;
}

// Selects three of these and the mean of the others, or of two of the others, that hold the origin deepest. The
// result is reduced by the rounding of the mean. 0: no selection holds it.
inline double surround_by_mean(const CornersAround& all, Contact& found) {
  double best = 0;
  // The others by their places among the three that are left: all, or all but one.
  constexpr std::size_t kNone = 3;
  for (unsigned three = 0; three < 64; ++three) {
    if (std::popcount(three) != 3) continue;
    Simplex<double> tried;
    std::array<const CsoPoint<double>*, 3> left;
    std::size_t others = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      if ((three >> i & 1u) != 0) {
        tried.add(all[i]);
      } else {
        left[others++] = &all[i];
      }
    }
    for (std::size_t skip = 0; skip <= kNone; ++skip) {
      Vec3<double> sum = Vec3<double>::Zero();
      double most = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        if (i == skip) continue;
        sum += left[i]->w;
        most = std::max(most, norm(left[i]->w));
      }
      const std::size_t means = skip == kNone ? 3 : 2;
      const Vec3<double> mean = sum / double(means);
      const auto& p = tried.point;
      // Two sums and a quotient.
      const double depth = depth_inside({p[0].w, p[1].w, p[2].w, mean}) - 4 * kUnitRoundoff<double> * most;
      if (!(depth > best)) continue;
      best = depth;
      found.pairs = tried;
      found.means = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        if (i != skip) found.mean_of[found.means++] = *left[i];
      }
      CsoPoint<double> fourth = *left[skip == 0 ? 1 : 0];
      fourth.w = mean;
      found.pairs.add(fourth);
    }
  }
  return best;
}

// Proves contact by portals. If the line passes under an edge, a tie and the common case on aligned boxes, a tilted
// line does not. `n`: a normal at the contact, so the origin is near the point at which the line enters along -n.
// `depth`: the approximate depth.
inline bool hold_by_portals(const Cso<double>& cso, const Vec3<double>& n, double depth, double e, int budget,
                            Contact& found, Counters& counters) {
  using State = PortalSearch<double>::State;
  const Frame<double> about(n);
  // Corners of the last tilt, and the largest depth at which any tilt holds the origin.
  CornersAround corner;
  double most = 0;
  bool any = false;
  constexpr std::array<std::array<double, 2>, 4> kTilts = {
      {{0, 0}, {0.4375, 0.1875}, {-0.375, 0.3125}, {0.0625, -0.5625}}};
  for (const auto& [x, y] : kTilts) {
    const Frame<double> frame(Vec3<double>(-(n + x * about.e1 + y * about.e2)));
    const PortalSearch<double> in = enter_line(cso, frame, kInfinity<double>, depth / 8, budget, counters);
    if (in.state == State::missed || in.portal.size != 3) continue;
    const PortalSearch<double> out = leave_line(cso, frame, depth / 8, budget, counters);
    if (out.state == State::missed || out.state == State::rejected || out.portal.size != 3) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = in.portal.p[i].c;
      corner[3 + i] = out.portal.p[i].c;
    }
    any = true;
    const double held = surround(corner, found.pairs);
    if (held > e) return true;
    most = std::max(most, held);
  }
  // Below the middle of a box's side, each four corners have a face through the diagonal. The fifth corner is beyond it.
  if (most > 0) {
    CsoPoint<double> beyond;
    if (deepen(cso, found.pairs, e, counters, beyond) > e) return true;
    const auto& p = found.pairs.point;
    corner = {p[0], p[1], p[2], p[3], beyond, beyond};
  }
  // If four points hold it only within the rounding, they hold it better a little later.
  if (any && surround_by_mean(corner, found) > e) return true;
  found.means = 0;
  return false;
}

// A direction out of C, for an origin near its surface if nothing better is known.
inline Vec3<double> away_from_middle(const MovingPair& pair) {
  const Vec3<double> middle = pair.cso().middle();
  return middle == Vec3<double>::Zero() ? Vec3<double>(Vec3<double>::UnitZ()) : Vec3<double>(-unit(middle));
}

// n_hint: a normal at the contact, or zero. depth: the approximate depth of the origin in C. `known`: the final
// simplex of a search at this very time, or empty. Four points that hold the origin are made deeper before any
// search. least: the pairs also hold a ball about the origin of this radius.
inline Contact proved_contact(const MovingPair& pair, const Vec3<double>& n_hint, double depth,
                              const Simplex<double>& known, int budget, Counters& counters,
                              double least = 0) {
  Contact out;
  CsoPoint<double> beyond;
  const Cso<double>& cso = pair.cso();
  const double e = contact_error(pair) + least, R = pair.radius();
  const Vec3<double> zero = Vec3<double>::Zero();
  if (known.size == 4) {
    out.pairs = known;
    out.proved = deepen(cso, out.pairs, e, counters, beyond) > e;
    out.unweighed = true;
    if (out.proved) return out;
    out.unweighed = false;
  }
  Simplex<double> simplex;
  const auto support = [&](const Vec3<double>& n) { return cso.support(n); };
  Distance<double> d = gjk_distance(support, zero, Vec3<double>(-cso.middle()), simplex, 0.0,
                                    std::max(R - 2 * e, 0.0), budget, counters);
  // Beside a rim, GJK does not converge to the closest point: deep contacts would remain unproved.
  if (R > 0 && d.upper + e > R && d.lower - R <= e) go_on(d, support, simplex, e, counters);
  out.pairs = simplex;
  out.proved = R > 0 && d.upper + e <= R;
  if (out.proved || d.lower - R > e) return out;
  if (simplex.size == 3 && d.upper == 0) add_above(cso, out.pairs, counters);
  if (simplex.size == 2 && d.upper == 0) add_around(cso, out.pairs, counters);
  if (out.pairs.size == 4) out.proved = deepen(cso, out.pairs, e, counters, beyond) > e;
  const Vec3<double> n = n_hint == zero ? Vec3<double>(Vec3<double>::UnitZ()) : graze::unit(n_hint);
  if (!out.proved) {
    // Along any axis the origin is no deeper than C reaches.
    ++counters.supports;
    if (!(dot(n, cso.support(n).w) > e)) return out;
    out.proved = hold_by_portals(cso, n, depth, e, budget, out, counters);
  }
  out.unweighed = out.proved;
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
