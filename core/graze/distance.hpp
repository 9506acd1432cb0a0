// distance(A, B) = min |a - b| at t = 0, with the closest points and a separating axis: GJK.
//
// Units: the caller's length, world axes. Guarantee: lower <= distance <= upper up to kappa u scale
// (docs/guarantees.md); where the bodies are apart by more than that, the normal proves lower: both lie on
// its sides. 0, 0 in contact. [Gilbert, Johnson, Keerthi 1988; van den Bergen 2003]. The stopping rule is the
// duality gap upper - lower.
#pragma once

#include <graze/mpr.hpp>
#include <graze/validate.hpp>
#include <graze/witness.hpp>

namespace graze {

template <Scalar S>
struct DistanceOptions {
  Request request = Request::normal | Request::witnesses;
  S tolerance = 0;           // of the gap, over scale; 0: the rounding bound
  int max_iterations = 256;  // support evaluations
};

template <Scalar S>
struct DistanceResult {
  Invalid invalid = Invalid::none;  // other than none: nothing else is valid
  S lower = 0, upper = kInfinity<S>;
  bool stalled = false;  // the gap asked for was not reached; the bracket is what is known
  // Where lower > 0, when asked for: unit, from A to B, and the closest points, in world coordinates.
  Vec3<S> normal = Vec3<S>::Zero();
  Vec3<S> point_a = Vec3<S>::Zero(), point_b = Vec3<S>::Zero();
  Counters counters;
};

namespace detail {

// |v| is known to u of itself, its direction only to the root of that: where the foot of the origin on an
// edge or a face is as near as rounding can tell to a smaller feature, GJK ends there, with a tilted axis
// that proves little. Two cures, for a search that stalled: the axes of all features that the simplex and its
// last support point span, |v| aside, while one proves more; and the normal of the portal by which the line
// from the origin to v enters C. `contact`: the simplex of v, weighted; on return that of the axis, where the
// feature that has it is as near as v, so that the witnesses lie one beyond the other along it.
template <Scalar S>
void steady_axis(Distance<S>& d, const Cso<S>& cso, Simplex<S>& contact, const SweepLimits<S>& limits,
                 Counters& counters) {
  Simplex<S> simplex = contact;
  Vec3<S> v = Vec3<S>::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) {
    v += simplex.lambda[i] * simplex.point[i].w;
  }
  CsoPoint<S> last;  // of the axis tried last
  // True if n proves more than was known.
  const auto try_axis = [&](const Vec3<S>& n) {
    if (n == Vec3<S>::Zero()) return false;
    ++counters.supports;
    last = cso.support(n);
    const S lower = -n.dot(last.w);
    if (!(lower > d.lower)) return false;
    d.lower = lower;
    d.n = n;
    return true;
  };
  const auto steady = [&] { return d.upper - d.lower <= limits.noise; };
  constexpr int kRounds = 8;
  try_axis(d.n);
  for (int round = 0; round < kRounds && simplex.size < 4 && !simplex.holds(last); ++round) {
    simplex.add(last);
    Points4<S> y;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) y[i] = simplex.point[i].w;
    Closest<S> kept;
    CsoPoint<S> kept_last;
    const auto consider = [&](const Closest<S>& feature) {
      if (feature.size == 0 || !try_axis(feature.n)) return;
      kept = feature;
      kept_last = last;
    };
    for (int i = 0; i < simplex.size; ++i) {
      for (int j = i + 1; j < simplex.size; ++j) {
        consider(closest_edge(y, i, j));
        for (int k = j + 1; k < simplex.size; ++k) consider(closest_face(y, std::array<int, 3>{i, j, k}));
      }
    }
    if (kept.size == 0) break;
    reduce(simplex, kept);
    if (std::sqrt(kept.dist_sq) <= d.upper + limits.noise) contact = simplex;
    if (steady()) break;
    last = kept_last;
  }
  if (!steady() && v != Vec3<S>::Zero()) {
    const PortalSearch<S> entry =
        enter_line(cso, Frame<S>(v), kInfinity<S>, limits.fine(), limits.budget, counters);
    try_axis(entry.n);
    try_axis(entry.facing);
  }
  d.stalled = !steady();
}

}  // namespace detail

template <Scalar S>
DistanceResult<S> distance(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options = {}) {
  DistanceResult<S> out;
  CastOptions<S> checked;
  checked.tolerance = options.tolerance;
  checked.max_iterations = options.max_iterations;
  out.invalid = validate(a, b, checked);
  if (out.invalid != Invalid::none) return out;
  const Cso<S> cso(a, b);
  const SweepLimits<S> limits = sweep_limits(cso, checked);
  const S R = cso.radius();
  Simplex<S> simplex;
  Distance<S> d = gjk_distance(cso, Vec3<S>(Vec3<S>::Zero()), simplex,
                               options.tolerance > 0 ? limits.target : limits.fine(), R + limits.fine(),
                               options.max_iterations, out.counters);
  out.counters.iterations = out.counters.gjk_iterations;
  const S apart = d.upper - R;
  if (d.stalled && d.upper - d.lower > limits.noise)
    detail::steady_axis(d, cso, simplex, limits, out.counters);
  // Nearer than rounding can tell is contact.
  if (apart <= limits.fine() || (apart <= limits.noise && !(d.lower - R > limits.fine()))) {
    out.lower = out.upper = 0;
    return out;
  }
  // A search that ended inside C without a tetrahedron around x knows neither: MPR does.
  if (!(d.lower - R > 0) &&
      mpr_overlap(cso, limits, out.counters).outcome == Outcome::initially_overlapping) {
    out.lower = out.upper = 0;
    return out;
  }
  out.upper = cso.to_length(apart);
  // A lower bound above the upper one is rounding.
  out.lower = std::min(std::max(cso.to_length(d.lower - R), S(0)), out.upper);
  out.stalled = d.stalled && !(apart - (d.lower - R) <= limits.noise);
  if (!(out.lower > 0)) return out;
  if (asks_for(options.request, Request::normal)) out.normal = d.n;
  if (asks_for(options.request, Request::witnesses)) {
    out.point_a = detail::witness(a, cso.side_a(), cso, simplex, d.n, true, S(0));
    out.point_b = detail::witness(b, cso.side_b(), cso, simplex, d.n, false, S(0));
  }
  return out;
}

}  // namespace graze
