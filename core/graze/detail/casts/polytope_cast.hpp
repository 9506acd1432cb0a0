// The fast searches of polytopes as rungs: the fast walk (MPR) and the fast ray (GJK).
//
// When a fast search gives up, the exact walk decides. The robust search answers the rest.
#pragma once

#include <graze/detail/casts/exact_answer_cast.hpp>
#include <graze/detail/casts/fast_answer.hpp>
#include <graze/detail/search/fast/fast_ray.hpp>
#include <graze/detail/search/fast/fast_walk.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

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

// By `Search`, one of FastWalk and FastRay. If it gives up, or there is no path to search, otherwise(pair, search)
// answers, search being null in the latter case. If it returns false, nothing is proved and only the counters of
// `out` have changed. The bodies have passed validate().
template <template <Scalar> class Search, Scalar S, class Otherwise>
[[nodiscard]] bool fast_cast_by(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                CastResult<S>& out, const Otherwise& otherwise) {
  const PreparedPair<S> pair(a, b);
  if (!pair.moves() || !(options.t_max > 0)) return otherwise(pair, static_cast<const Search<S>*>(nullptr));
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  Search<S> search(pair, double(options.t_max) * power_of_two(j - k), double(options.tolerance),
                   options.max_iterations, out.counters);
  const FastSweep& found = search.run();
  if (!fill_times(pair, found, options, out)) return otherwise(pair, &search);
  const bool hit = found.outcome == Outcome::hit, has_axis = hit || found.outcome == Outcome::miss;
  Vec3<double> n = Vec3<double>::Zero();
  if (has_axis && asks_for(options.request, hit ? Request::normal | Request::proof : Request::proof))
    n = unit(found.n.vector());
  if (hit && asks_for(options.request, Request::normal)) out.normal = n.template cast<S>();
  if (hit && asks_for(options.request, Request::witnesses)) {
    out.point_a = fast_witness(a, pair.a(), search, found, true, k, double(out.toi_lower));
    out.point_b = fast_witness(b, pair.b(), search, found, false, k, double(out.toi_lower));
  }
  fill_proof(a, b, options, n, out);
  return true;
}

// A fast search gives up where rounding decides: near the start, near the end of the path and where it grazes. The exact
// walk continues from the portal of the fast one. Two cases are left to the robust search: whether a start in contact
// leaves, which is a matter of the noise (leaving.hpp), and a budget smaller than a fast walk may take.
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
