// Tier exact: the first contact of two moving polytopes, rounded ones and a target distance included, correctly rounded.
//
//   toi_lower is the largest S not above the exact TOI of the true shapes, and toi_upper is the least S not below it.
//   The verdict is exact, touching included. For every valid input: point, segment, triangle, box, hull, posed and
//   summed (so swept), any orientation. It always converges. casts/exact_round_answer.hpp covers spheres, capsules,
//   roundings, and polytopes at a target distance.
//
// The proof of every answer is accepted to the last bit: its axis is symbolic, its times are the double bracket (for S =
// float the closer one). queries/exact_queries.hpp has the other questions.
#pragma once

#include <graze/detail/casts/exact_answer_cast.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The exact walk as a rung, for shapes that exact::is_exact() takes. It always answers, or refuses what outgrows its room.
template <Scalar S>
bool exact_walk(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  out.method = Method::exact_portal;
  exact::PassageSearch<S> cast(a, b, out.counters);
  const exact::Answer answer = cast.pass(static_cast<double>(options.t_max));
  exact::answer_cast(cast, answer, options, out);
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
