// Tier exact: the first contact of two moving polytopes, correctly rounded.
//
//   toi_lower = the largest S not above the exact TOI of the true shapes, toi_upper = the least not below it;
//   the verdict is exact, touching included. For every valid input: point, segment, triangle, box, hull,
//   posed and summed (so swept), any orientation; no target distance. It never stalls.
//
// The proof of every answer is accepted to the last bit: its axis is symbolic, its times are the double
// bracket (for S = float the closer one). queries/exact_queries.hpp has the other questions.
#pragma once

#include <graze/cast.hpp>
#include <graze/detail/casts/exact_answer_cast.hpp>
#include <graze/detail/rays/exact_ray.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  CastResult<S> out;
  out.method = Method::exact_portal;
  out.invalid = exact::refusal(a, b, options);
  if (exact::refused(out, a, b, options) || detail::ray_exact(a, b, options, out)) return out;
  exact::PassageSearch<S> cast(a, b, out.counters);
  const exact::Answer answer = cast.pass(static_cast<double>(options.t_max));
  exact::answer_cast(cast, answer, options, out);
  return out;
}

}}  // namespace graze::GRAZE_LINKAGE
