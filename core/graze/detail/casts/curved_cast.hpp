// The curved walk as a rung, for cylinders, cones and ellipsoids beside each other, round shapes and polytopes.
#pragma once

#include <graze/detail/casts/fast_answer.hpp>
#include <graze/detail/search/fast/curved_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Normal and witnesses of a hit at `lower`, the caller's time.
template <Scalar S>
void fill_curved_contact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                         const CurvedPair<S>& pair, const CurvedSweep& found, double lower,
                         CastResult<S>& out) {
  const Triple n = (1 / square_root(dot(found.n, found.n))) * found.n;
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
  if (!(options.t_max > 0)) return false;
  const CurvedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves()) return false;
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  CurvedWalk<S> walk(pair, double(options.t_max) * power_of_two(j - k), double(options.tolerance),
                     options.max_iterations, out.counters);
  const CurvedSweep& found = walk.run();
  if (!fill_times(pair, found, options, out)) return false;
  if (found.outcome == Outcome::hit)
    fill_curved_contact(a, b, options, pair, found, double(out.toi_lower), out);
  fill_proof(a, b, options, unit_axis(found.n, square_root(dot(found.n, found.n))), out);
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
