// Tier exact: the first contact of two moving polytopes, rounded ones and a target distance included, correctly rounded.
//
//   toi_lower = the largest S not above the exact TOI of the true shapes, toi_upper = the least not below it;
//   the verdict is exact, touching included. For every valid input: point, segment, triangle, box, hull,
//   posed and summed (so swept), any orientation. It never stalls. Spheres, capsules, roundings, and polytopes at a
//   target distance: exact_round_answer.hpp; these answers have no proof.
//
// The proof of every answer of polytopes is accepted to the last bit: its axis is symbolic, its times are the double
// bracket (for S = float the closer one). queries/exact_queries.hpp has the other questions.
#pragma once

#include <graze/cast.hpp>
#include <graze/detail/casts/exact_answer_cast.hpp>
#include <graze/detail/casts/exact_round_answer.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  CastResult<S> out;
  out.method = Method::exact_portal;
  out.invalid = exact::refusal(a, b, options);
  if (exact::refused(out, a, b, options)) return out;
  if (!exact::is_sharp(a, b, options.target_distance)) {
    exact::answer_round_cast(a, b, options, out);
    return out;
  }
  exact::PassageSearch<S> cast(a, b, out.counters);
  const exact::Answer answer = cast.pass(static_cast<double>(options.t_max));
  exact::answer_cast(cast, answer, options, out);
  return out;
}

}}  // namespace graze::GRAZE_LINKAGE
