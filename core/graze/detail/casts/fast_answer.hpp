// Shared by the fast walks: converts their answer into the cast's result with times, distance and proof.
#pragma once

#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/numeric/triple.hpp>
#include <graze/detail/proving/prove.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Outcome, times and distance, in the caller's units. Returns false and sets nothing in three cases. The walk gave
// up. It found a start in contact that the policy passes over. Or a hit is so near the start or the end that its
// times have no normal number.
template <Scalar S, class Pair, class Found>
[[nodiscard]] bool fill_times(const Pair& pair, const Found& found, const CastOptions<S>& options,
                              CastResult<S>& out) {
  const bool hit = found.outcome == Outcome::hit;
  if (found.outcome == Outcome::not_converged) return false;
  if (found.outcome == Outcome::initially_overlapping && options.start_policy == StartPolicy::pass_over)
    return false;
  S lower = 0, upper = 0;
  if (hit) {
    const int k = pair.length_exponent(), j = pair.speed_exponent();
    lower = round_down<S>(found.lower * power_of_two(k - j));
    upper = std::min(round_up<S>(found.upper * power_of_two(k - j)), options.t_max);
    if (!(lower > 0 && lower <= upper)) return false;
    const Triple& r = pair.direction();
    out.distance = static_cast<S>((found.upper - found.lower) * square_root(dot(r, r)) * power_of_two(k));
  } else if (found.outcome == Outcome::miss) {
    lower = upper = kInfinity<S>;
  }
  out.outcome = found.outcome;
  out.toi_lower = lower;
  out.toi_upper = upper;
  return true;
}

// n: the unit axis of a hit or a miss.
template <Scalar S>
void fill_proof(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, const Vec3<double>& n,
                CastResult<S>& out) {
  if (!asks_for(options.request, Request::proof)) return;
  out.proof = prove(a, b, options, out.outcome, out.toi_upper, Vec3<S>(n.template cast<S>()), out.counters);
}

// The unit vector along n, zero for zero.
[[nodiscard]] inline Vec3<double> unit_axis(const Triple& n, double length) {
  return length > 0 ? Vec3<double>(((1 / length) * n).vector()) : Vec3<double>(Vec3<double>::Zero());
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
