// The round walk's answer as a cast's: times, normal, witnesses, in the caller's units.
//
// Spheres, capsules, and points, segments, triangles, boxes and hulls beside one of them or a target distance;
// the robust search answers the rest, and whatever the walk gives up on.
#pragma once

#include <graze/detail/casts/polytope_cast.hpp>
#include <graze/detail/search/fast/round_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
[[nodiscard]] bool is_round_pair(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  return is_round(a.shape) && is_round(b.shape) &&
         (options.target_distance > 0 || !has_fast_search(a.shape) || !has_fast_search(b.shape));
}

// Of a hit its normal, of length 1, and witnesses at `lower`, the caller's time, with what is nearest then: its axis and
// its feature.
template <Scalar S>
void fill_round_contact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                        const PreparedPair<S>& pair, const RoundWalk<S>& walk, const Triple& normal,
                        const RoundSweep& found, double lower, CastResult<S>& out) {
  if (asks_for(options.request, Request::normal)) out.normal = normal.vector().template cast<S>();
  if (!asks_for(options.request, Request::witnesses)) return;
  const Triple n = (1 / found.length) * found.n;
  const auto witness = [&](const Body<S>& body, const PreparedCore<S>& core, bool of_a) -> Vec3<S> {
    Triple own{0, 0, 0};
    for (int i = 0; i < found.size; ++i) {
      const PairVertex& c = walk.corner(std::size_t(i));
      own = own + found.lambda[std::size_t(i)] * core.own(of_a ? c.vertex_a : c.vertex_b);
    }
    const Triple turned = core.to_world(power_of_two(pair.length_exponent()) * own);
    const double radius = of_a ? pair.radius_a() : -pair.radius_b();
    return (core.placed_center() + (lower * triple(body.displacement) + (turned + radius * n)))
        .vector()
        .template cast<S>();
  };
  out.point_a = witness(a, pair.a(), true);
  out.point_b = witness(b, pair.b(), false);
}

// False: nothing is claimed, and of `out` only the counters have changed. The bodies have passed validate().
template <Scalar S>
[[nodiscard]] bool round_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                              CastResult<S>& out) {
  const PreparedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves() || !(options.t_max > 0) || !(pair.radius() > 0)) return false;
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  RoundWalk<S> walk(pair, double(options.t_max) * power_of_two(j - k), double(options.tolerance),
                    options.max_iterations, out.counters);
  const RoundSweep& found = walk.run();
  out.counters.gjk_iterations = out.counters.iterations;
  if (found.outcome == Outcome::not_converged) return false;
  if (found.outcome == Outcome::initially_overlapping && options.start_policy == StartPolicy::pass_over)
    return false;
  S lower = 0, upper = 0;
  const bool hit = found.outcome == Outcome::hit;
  if (hit) {
    lower = rounded_toward<S>(found.lower * power_of_two(k - j), false);
    upper = std::min(rounded_toward<S>(found.upper * power_of_two(k - j), true), options.t_max);
    if (!(lower > 0 && lower <= upper)) return false;
    const Triple& r = pair.direction();
    out.distance = static_cast<S>((found.upper - found.lower) * std::sqrt(dot(r, r)) * power_of_two(k));
    fill_round_contact(a, b, options, pair, walk, found.normal, found, double(lower), out);
  } else if (found.outcome == Outcome::miss) {
    lower = upper = kInfinity<S>;
  }
  out.outcome = found.outcome;
  out.toi_lower = lower;
  out.toi_upper = upper;
  if (asks_for(options.request, Request::proof)) {
    const Triple n = hit ? found.normal : found.length > 0 ? (1 / found.length) * found.n : Triple{0, 0, 0};
    out.proof =
        prove(a, b, options, out.outcome, upper, Vec3<S>(n.vector().template cast<S>()), out.counters);
  }
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
