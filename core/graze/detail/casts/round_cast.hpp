// The round walk as a rung, for spheres, capsules and polytopes at a distance.
#pragma once

#include <graze/detail/casts/fast_answer.hpp>
#include <graze/detail/search/fast/round_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// A hit's normal, of length 1, and its witnesses at `lower`, the caller's time. They belong to the closest features
// then, their axis and feature.
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
  if (!fill_times(pair, found, options, out)) return false;
  const bool hit = found.outcome == Outcome::hit;
  if (hit) fill_round_contact(a, b, options, pair, walk, found.normal, found, double(out.toi_lower), out);
  fill_proof(a, b, options, hit ? found.normal.vector() : unit_axis(found.n, found.length), out);
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
