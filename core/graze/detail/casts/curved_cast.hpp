// The curved walk's answer as a cast's: times, normal, witnesses, in the caller's units.
//
// Cylinders, cones and ellipsoids beside each other, spheres, capsules, points, segments, triangles, boxes and hulls;
// the robust search answers the rest, and whatever the walk gives up on.
#pragma once

#include <graze/detail/casts/polytope_cast.hpp>
#include <graze/detail/search/fast/curved_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
[[nodiscard]] bool is_curved_pair(const Body<S>& a, const Body<S>& b) {
  return (is_curved_leaf(a.shape) || is_curved_leaf(b.shape)) && is_curved_or_round(a.shape) &&
         is_curved_or_round(b.shape);
}

// Normal and witnesses of a hit at `lower`, the caller's time.
template <Scalar S>
void fill_curved_contact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                         const CurvedPair<S>& pair, const CurvedSweep& found, double lower,
                         CastResult<S>& out) {
  const Triple n = (1 / std::sqrt(dot(found.n, found.n))) * found.n;
  if (asks_for(options.request, Request::normal)) out.normal = n.vector().template cast<S>();
  if (!asks_for(options.request, Request::witnesses)) return;
  const auto witness = [&](const Body<S>& body, const PreparedCurved<S>& core,
                           const std::array<Triple, 3>& point, double radius) -> Vec3<S> {
    Triple own{0, 0, 0};
    for (std::size_t i = 0; i < std::size_t(found.size); ++i) own = own + found.lambda[i] * point[i];
    const Triple turned = core.core().to_world(power_of_two(pair.length_exponent()) * own);
    return (core.core().placed_center() + (lower * triple(body.displacement) + (turned + radius * n)))
        .vector()
        .template cast<S>();
  };
  out.point_a = witness(a, pair.a(), found.own_a, pair.radius_a());
  out.point_b = witness(b, pair.b(), found.own_b, -pair.radius_b());
}

// False: nothing is claimed, and of `out` only the counters have changed. The bodies have passed validate().
template <Scalar S>
[[nodiscard]] bool curved_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                               CastResult<S>& out) {
  if (!is_curved_pair(a, b) || !(options.t_max > 0)) return false;
  const CurvedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves()) return false;
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  CurvedWalk<S> walk(pair, double(options.t_max) * power_of_two(j - k), double(options.tolerance),
                     options.max_iterations, out.counters);
  const CurvedSweep& found = walk.run();
  if (found.outcome == Outcome::not_converged) return false;
  if (found.outcome == Outcome::initially_overlapping && options.start_policy == StartPolicy::pass_over)
    return false;
  S lower = 0, upper = 0;
  if (found.outcome == Outcome::hit) {
    lower = rounded_toward<S>(found.lower * power_of_two(k - j), false);
    upper = std::min(rounded_toward<S>(found.upper * power_of_two(k - j), true), options.t_max);
    if (!(lower > 0 && lower <= upper)) return false;
    const Triple& r = pair.direction();
    out.distance = static_cast<S>((found.upper - found.lower) * std::sqrt(dot(r, r)) * power_of_two(k));
    fill_curved_contact(a, b, options, pair, found, double(lower), out);
  } else if (found.outcome == Outcome::miss) {
    lower = upper = kInfinity<S>;
  }
  out.outcome = found.outcome;
  out.toi_lower = lower;
  out.toi_upper = upper;
  if (asks_for(options.request, Request::proof)) {
    const double length = std::sqrt(dot(found.n, found.n));
    const Triple n = length > 0 ? (1 / length) * found.n : Triple{0, 0, 0};
    out.proof =
        prove(a, b, options, out.outcome, upper, Vec3<S>(n.vector().template cast<S>()), out.counters);
  }
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
