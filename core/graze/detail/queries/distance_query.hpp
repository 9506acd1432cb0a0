// Declared, with what it promises, in graze/distance.hpp.
#pragma once

#include <graze/detail/pairs/prepared_body.hpp>
#include <graze/detail/proving/witness.hpp>
#include <graze/detail/search/fast/fast_gjk.hpp>
#include <graze/detail/search/robust/refine_axis.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/distance.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// Answers for two polytopes. False: nothing is claimed, and of `out` only the counters have changed.
template <Scalar S>
[[nodiscard]] bool fast_distance(const PreparedPair<S>& pair, const DistanceOptions<S>& options,
                                 DistanceResult<S>& out) {
  PairSupport<S> support(pair, out.counters);
  FastGjk<S> gjk(support, out.counters);
  const FastState state =
      gjk.run(options.start, pair.tolerated(double(options.tolerance)), false, options.max_iterations);
  out.counters.iterations = out.counters.gjk_iterations;
  if (state == FastState::open) return false;
  const int k = pair.length_exponent();
  const bool apart = state == FastState::apart && gjk.upper() > support.fine() &&
                     (gjk.upper() > support.noise() || gjk.lower() > support.fine());
  if (!apart) {
    out.lower = out.upper = 0;
    out.warm = gjk.warm();
    return true;
  }
  out.upper = static_cast<S>(gjk.upper() * power_of_two(k));
  out.lower = std::min(static_cast<S>(gjk.lower() * power_of_two(k)), out.upper);
  if (!(out.lower > 0)) return false;
  out.warm = gjk.warm();
  if (asks_for(options.request, Request::normal)) out.normal = gjk.axis().vector().template cast<S>();
  if (asks_for(options.request, Request::witnesses)) {
    out.point_a = pair_witness<S>(pair.a(), gjk.vertices(true), gjk.lambda(), gjk.size(), k);
    out.point_b = pair_witness<S>(pair.b(), gjk.vertices(false), gjk.lambda(), gjk.size(), k);
  }
  return true;
}

template <Scalar S>
CastOptions<S> checked(const DistanceOptions<S>& options) {
  CastOptions<S> out;
  out.tolerance = options.tolerance;
  out.max_iterations = options.max_iterations;
  return out;
}

// For every pair of shapes, validated.
template <Scalar S>
DistanceResult<S>& robust_distance(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options,
                                   const CastOptions<S>& checked, DistanceResult<S>& out) {
  const Cso<S> cso(a, b);
  const SweepLimits<S> limits = sweep_limits(cso, checked);
  const S R = cso.radius();
  Simplex<S> simplex;
  const Vec3<S> begin =
      options.start.has_axis() ? Vec3<S>(options.start.axis.template cast<S>()) : Vec3<S>(-cso.middle());
  Distance<S> d = gjk_distance([&cso](const Vec3<S>& n) { return cso.support(n); }, Vec3<S>(Vec3<S>::Zero()),
                               begin, simplex, limits.fine(), R + limits.fine(), options.max_iterations,
                               out.counters, options.tolerance > 0 ? limits.target : S(0));
  out.counters.iterations = out.counters.gjk_iterations;
  const S enough = d.lower > R + limits.fine() ? limits.target : limits.noise;
  if (d.stalled && d.upper - d.lower > enough) steady_axis(d, cso, simplex, limits, out.counters);
  const S apart = d.upper - R;
  // Nearer than rounding can tell is contact.
  if (apart <= limits.fine() || (apart <= limits.noise && !(d.lower - R > limits.fine()))) {
    out.lower = out.upper = 0;
    return out;
  }
  // A search that ended inside C without a tetrahedron around x gives neither, but MPR does.
  if (!(d.lower - R > 0) &&
      mpr_overlap(cso, limits, out.counters).outcome == Outcome::initially_overlapping) {
    out.lower = out.upper = 0;
    return out;
  }
  out.upper = cso.to_length(apart);
  // A lower bound above the upper one is rounding.
  out.lower = std::min(std::max(cso.to_length(d.lower - R), S(0)), out.upper);
  out.stalled = d.stalled && !(apart - (d.lower - R) <= limits.target);
  if (!(out.lower > 0)) return out;
  out.warm.axis = d.n.template cast<double>();
  if (asks_for(options.request, Request::normal)) out.normal = d.n;
  if (asks_for(options.request, Request::witnesses)) {
    // The radii lie along what joins the cores' points. If the distance is small beside them, the axis is
    // known to the root of the rounding only, and a tolerance leaves it as far off.
    const Vec3<S> n = R > 0 ? unit(Vec3<S>(-combination(simplex))) : d.n;
    out.point_a = witness(a, cso.side_a(), cso, simplex, n, true, S(0));
    out.point_b = witness(b, cso.side_b(), cso, simplex, n, false, S(0));
  }
  return out;
}

}  // namespace detail

template <Scalar S>
DistanceResult<S> distance(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options) {
  DistanceResult<S> out;
  const CastOptions<S> checked = detail::checked(options);
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked)) return out;
  if (detail::has_fast_search(a.shape) && detail::has_fast_search(b.shape) &&
      detail::fast_distance(detail::PreparedPair<S>(a, b), options, out))
    return out;
  return detail::robust_distance(a, b, options, checked, out);
}

template <Scalar S>
DistanceResult<S> distance(const Prepared<S>& a, const Prepared<S>& b, const DistanceOptions<S>& options) {
  DistanceResult<S> out;
  const CastOptions<S> checked = detail::checked(options);
  out.invalid = detail::validate_prepared(a, b, checked);
  if (detail::refused(out, a.body(), b.body(), checked)) return out;
  if (detail::both_prepared(a, b) &&
      detail::fast_distance(detail::PreparedPair<S>(*a.inner().core, *b.inner().core), options, out))
    return out;
  return detail::robust_distance(a.body(), b.body(), options, checked, out);
}

}}  // namespace graze::GRAZE_LINKAGE
