// A quick search's answer as a cast's: times, normal, witnesses, in the caller's units.
//
// Point, segment, triangle, box and hull, without a target distance. What a quick search gives up on the exact walk
// decides. The robust search answers the rest.
#pragma once

#include <graze/detail/casts/exact_answer_cast.hpp>
#include <graze/detail/proving/prove.hpp>
#include <graze/detail/proving/witness.hpp>
#include <graze/detail/search/fast/fast_ray.hpp>
#include <graze/detail/search/fast/fast_walk.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The largest S not above x > 0 (`up`: the least not below), by the next number of a positive one.
template <Scalar S>
[[nodiscard]] S rounded_toward(double x, bool up) {
  const S near = static_cast<S>(x);
  if constexpr (std::same_as<S, double>) {
    return near;
  } else {
    if (up ? !(double(near) < x) : !(double(near) > x)) return near;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(near) + (up ? 1u : ~0u));
  }
}

// sum lambda_i x_i of the body at time t, world coordinates.
template <Scalar S, class Search>
[[nodiscard]] Vec3<S> fast_witness(const Body<S>& body, const PreparedCore<S>& core, const Search& search,
                                   const FastSweep& found, bool of_a, int k, double t) {
  Triple own{0, 0, 0};
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.size); ++i) {
    const auto& corner = search.corner(i);
    own = own + found.lambda[i] * core.own(of_a ? corner.vertex_a : corner.vertex_b);
  }
  const Triple turned = core.to_world(power_of_two(k) * own);
  return (core.placed_center() + (t * triple(body.displacement) + turned)).vector().template cast<S>();
}

// By `Search`, one of FastWalk and FastRay. Where it gives up, or there is no path to search, otherwise(pair, search)
// answers, search being null in the latter case. False: nothing is claimed, and of `out` only the counters have changed.
// The bodies have passed validate().
template <template <Scalar> class Search, Scalar S, class Otherwise>
[[nodiscard]] bool fast_cast_by(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                CastResult<S>& out, const Otherwise& otherwise) {
  if (options.target_distance > 0 || !has_fast_search(a.shape) || !has_fast_search(b.shape)) return false;
  const PreparedPair<S> pair(a, b);
  if (!pair.moves() || !(options.t_max > 0)) return otherwise(pair, static_cast<const Search<S>*>(nullptr));
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  Search<S> search(pair, double(options.t_max) * power_of_two(j - k), double(options.tolerance),
                   options.max_iterations, out.counters);
  const FastSweep& found = search.run();
  if (found.outcome == Outcome::not_converged) return otherwise(pair, &search);
  if (found.outcome == Outcome::initially_overlapping && options.start_policy == StartPolicy::pass_over)
    return false;

  S lower = 0, upper = 0;
  if (found.outcome == Outcome::hit) {
    lower = rounded_toward<S>(found.lower * power_of_two(k - j), false);
    upper = std::min(rounded_toward<S>(found.upper * power_of_two(k - j), true), options.t_max);
    if (!(lower > 0 && lower <= upper)) return otherwise(pair, &search);
  } else if (found.outcome == Outcome::miss) {
    lower = upper = kInfinity<S>;
  }
  out.outcome = found.outcome;
  out.toi_lower = lower;
  out.toi_upper = upper;
  const bool hit = found.outcome == Outcome::hit, proof = asks_for(options.request, Request::proof);
  Vec3<double> n = Vec3<double>::Zero();
  if (hit) {
    const Triple& r = pair.direction();
    out.distance = static_cast<S>((found.upper - found.lower) * std::sqrt(dot(r, r)) * power_of_two(k));
  }
  if ((hit && asks_for(options.request, Request::normal)) || (proof && found.outcome == Outcome::miss) ||
      (proof && hit)) {
    n = unit(found.n.vector());
  }
  if (hit && asks_for(options.request, Request::normal)) out.normal = n.template cast<S>();
  if (hit && asks_for(options.request, Request::witnesses)) {
    out.point_a = fast_witness(a, pair.a(), search, found, true, k, double(lower));
    out.point_b = fast_witness(b, pair.b(), search, found, false, k, double(lower));
  }
  if (proof) {
    out.proof = prove(a, b, options, out.outcome, upper, Vec3<S>(n.template cast<S>()), out.counters);
  }
  return true;
}

// A quick search gives up where rounding decides: near the start, near the end of the path and where it grazes. The exact
// walk goes on from the walk's portal in hand. Whether a start in contact leaves
// is a matter of the noise, though (leaving.hpp); and a budget that the caller made smaller than a quick walk may take
// ends the search.
template <Scalar S>
[[nodiscard, gnu::noinline]] bool cast_exactly_from(const PreparedPair<S>& pair, const FastWalk<S>* walk,
                                                    const CastOptions<S>& options, CastResult<S>& out) {
  if (options.start_policy != StartPolicy::report || options.max_iterations < kFastSteps) return false;
  exact::PassageSearch<S> search(pair, out.counters);
  const exact::Answer answer = search.pass(walk ? exact::seeds_of(*walk) : exact::Seeds{});
  const Method method = out.method;
  exact::answer_cast(search, answer, options, out);
  if (search.scene().valid()) return true;
  out = {};
  out.method = method;
  return false;
}

template <Scalar S>
using AnsweringWalk = FastWalk<S>;

template <Scalar S>
[[nodiscard]] bool fast_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                             CastResult<S>& out) {
  const bool answered = fast_cast_by<AnsweringWalk>(
      a, b, options, out, [&](const PreparedPair<S>& pair, const FastWalk<S>* walk) {
        return cast_exactly_from(pair, walk, options, out);
      });
  out.counters.iterations = out.counters.portal_steps;
  return answered;
}
template <Scalar S>
[[nodiscard]] bool fast_ray_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                 CastResult<S>& out) {
  const bool answered =
      fast_cast_by<FastRay>(a, b, options, out, [&](const PreparedPair<S>& pair, const FastRay<S>*) {
        return cast_exactly_from(pair, static_cast<const FastWalk<S>*>(nullptr), options, out);
      });
  out.counters.iterations = out.counters.gjk_iterations;
  return answered;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
