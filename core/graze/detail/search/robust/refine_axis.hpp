// Completes a GJK search (gjk.hpp) that did not converge: axes that prove more, and nearer points.
//
// GJK knows |v| to u of itself, but the direction of v only to the root of u. If the foot of the origin on an
// edge or a face cannot be told from a smaller feature, it ends there, with a tilted axis that proves little.
// If an edge is long beside |v|, a rotation that |v| does not show decides which vertex is the support point, and
// so whether a nearer one is found. Let e be the angle of an edge of length L to the plane across v at its
// end. The edge makes |v| shorter by e^2 |v| / 2 at most, and rotates it by e. A vertex at the other end of
// the face that it bounds may lie e L before that plane. |v| does not show an e up to the root of u.
#pragma once

#include <graze/detail/search/robust/mpr.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The closest of the features that hold the newest point.
template <Scalar S>
Closest<S> closest_with_newest(const Simplex<S>& simplex) {
  const auto& p = simplex.point;
  const Points4<S> y = {p[0].w, p[1].w, p[2].w, p[3].w};
  const int newest = simplex.size - 1;
  Closest<S> best = closest_vertex(y, newest);
  for (int i = 0; i < newest; ++i) {
    keep_nearer(best, closest_edge(y, i, newest));
    for (int j = i + 1; j < newest; ++j) keep_nearer(best, closest_face(y, std::array<int, 3>{i, j, newest}));
  }
  return best;
}

// Continues GJK from where it did not converge, about the origin. A support point before the plane across v
// brings v nearer by some feature that holds the point. If |v| does not show which, the closest of those is
// the next, as near as v within the noise. `contact`: as of turn_axis.
template <Scalar S, class Support>
void go_on(Distance<S>& d, const Support& support, Simplex<S>& contact, S noise, Counters& counters) {
  // Prisms take 1 to 5. Rims that are nearly aligned take more than 32 in places, by corners ever nearer. If
  // more are needed, the axes below are used.
  constexpr int kRounds = 64;
  const Vec3<S> origin = Vec3<S>::Zero();
  Simplex<S> simplex = contact;
  Closest<S> closest = closest_to_origin(simplex, origin);
  for (int round = 0; round < kRounds && closest.n != origin && simplex.size < 4; ++round) {
    const CsoPoint<S> next = support(closest.n);
    ++counters.supports;
    const S upper = square_root(closest.dist_sq), lower = -dot(closest.n, next.w);
    const bool proves_more = lower > d.lower;
    if (upper < d.upper || (proves_more && upper <= d.upper + noise)) contact = simplex;
    d.upper = std::min(d.upper, upper);
    if (proves_more) {
      d.lower = lower;
      d.n = closest.n;
    }
    if (d.upper - d.lower <= noise || simplex.holds(next)) return;
    simplex.add(next);
    closest = closest_to_origin(simplex, origin);
    ++counters.gjk_iterations;
    if (!(square_root(closest.dist_sq) < upper)) closest = closest_with_newest(simplex);
    if (!(square_root(closest.dist_sq) <= d.upper + noise)) return;
    reduce(simplex, closest);
  }
}

// The axes of all features that the simplex and its last support point span, |v| aside: of that which proves
// most, or, where none proves more, of the nearest one with the new point. `support` as the search's, about
// the origin. `contact` is the weighted simplex of v. On return it is that of the axis, if the feature that
// has it is as near as v, so that the witnesses lie one beyond the other along it.
template <Scalar S, class Support>
void turn_axis(Distance<S>& d, const Support& support, Simplex<S>& contact, S noise, Counters& counters) {
  Simplex<S> simplex = contact;
  CsoPoint<S> last;  // of the axis tried last
  // True if n proves more than was known.
  const auto try_axis = [&](const Vec3<S>& n) {
    ++counters.supports;
    last = support(n);
    const S lower = -dot(n, last.w);
    if (!(lower > d.lower)) return false;
    d.lower = lower;
    d.n = n;
    return true;
  };
  constexpr int kRounds = 8;
  try_axis(d.n != Vec3<S>::Zero() ? d.n : Vec3<S>(-unit(combination(contact))));
  for (int round = 0; round < kRounds && simplex.size < 4 && !simplex.holds(last); ++round) {
    simplex.add(last);
    const int newest = simplex.size - 1;
    Points4<S> y;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) y[i] = simplex.point[i].w;
    Closest<S> kept, next;
    CsoPoint<S> kept_last, next_last;
    const auto consider = [&](const Closest<S>& feature, bool is_new) {
      if (feature.size == 0 || feature.n == Vec3<S>::Zero()) return;
      if (try_axis(feature.n)) {
        kept = feature;
        kept_last = last;
      } else if (is_new && feature.dist_sq < next.dist_sq) {
        next = feature;
        next_last = last;
      }
    };
    for (int i = 0; i < simplex.size; ++i) {
      for (int j = i + 1; j < simplex.size; ++j) {
        consider(closest_edge(y, i, j), j == newest);
        for (int k = j + 1; k < simplex.size; ++k)
          consider(closest_face(y, std::array<int, 3>{i, j, k}), k == newest);
      }
    }
    const bool proves_more = kept.size > 0;
    if (!proves_more) {
      if (next.size == 0) break;
      kept = next;
      kept_last = next_last;
    }
    reduce(simplex, kept);
    const S upper = square_root(kept.dist_sq);
    if (upper < d.upper || (proves_more && upper <= d.upper + noise)) contact = simplex;
    d.upper = std::min(d.upper, upper);
    if (d.upper - d.lower <= noise) break;
    last = kept_last;
  }
}

// And the normal of the portal by which the line from the origin to v enters C.
template <Scalar S>
void steady_axis(Distance<S>& d, const Cso<S>& cso, Simplex<S>& contact, const SweepLimits<S>& limits,
                 Counters& counters) {
  if (!(d.upper < kInfinity<S>)) return;  // where the bodies are is beyond the doubles
  const auto support = [&cso](const Vec3<S>& n) { return cso.support(n); };
  const auto steady = [&] { return d.upper - d.lower <= limits.noise; };
  go_on(d, support, contact, limits.noise, counters);
  const Vec3<S> v = combination(contact);
  if (!steady()) turn_axis(d, support, contact, limits.noise, counters);
  if (!steady() && v != Vec3<S>::Zero()) {
    const PortalSearch<S> entry =
        enter_line(cso, Frame<S>(v), kInfinity<S>, limits.fine(), limits.budget, counters);
    for (const Vec3<S>& n : {entry.n, entry.facing}) {
      if (n == Vec3<S>::Zero()) continue;
      ++counters.supports;
      if (const S lower = -dot(n, cso.support(n).w); lower > d.lower) {
        d.lower = lower;
        d.n = n;
      }
    }
  }
  d.stalled = !steady();
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
