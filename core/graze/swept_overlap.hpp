// swept_overlap(A, B): do the bodies touch at any t in [0, t_max]? Only whether, not when.
//
// Contact at t iff t v in C, so contact at some t iff 0 is in C swept by -v:
//   D = C + segment(0, -t_max v),   h_D(n) = h_C(n) + max(0, -t_max n.v).
// Three ways:
//   gjk           the distance of 0 from D. A support of D is one of C and the choice of the segment's end.
//   mpr           seen along v, D and C project alike: a portal of C holds the line or it does not, and D is
//                 entered before t_max and left after 0 or it is not. That is the MPR sweep without its time.
//   before_after  the lecture's slow version: D as the hull of C at t = 0 and C at t_max. Each support
//                 searches all points of C twice, once where they are before and once where they are after.
//                 Kept as the baseline that the sum is measured against (bench/queries_bench.cpp).
// Units: the caller's; world axes. Guarantee: right wherever clearance or depth exceeds kappa u scale
// (docs/guarantees.md). Touching counts.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

enum class SweptMethod : std::uint8_t { gjk, mpr, before_after };
[[nodiscard]] constexpr std::string_view to_text(SweptMethod method) {
  switch (method) {
    case SweptMethod::gjk:
      return "gjk";
    case SweptMethod::mpr:
      return "mpr";
    case SweptMethod::before_after:
      return "before_after";
  }
  return {};
}

template <Scalar S>
struct SweptOverlapOptions {
  SweptMethod method = SweptMethod::gjk;
  S t_max = 1;               // infinity for a ray
  S target_distance = 0;     // m: contact is when the distance reaches m (length)
  int max_iterations = 256;  // support evaluations
};

template <Scalar S>
struct SweptOverlapResult {
  // hit: contact at some t in [0, t_max], 0 included; miss; not_converged; invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};
  // miss: unit, from A to B, world axes; separates the bodies for all these t.
  Vec3<S> normal = Vec3<S>::Zero();
  Counters counters;
};

template <Scalar S>
SweptOverlapResult<S> swept_overlap(const Body<S>& a, const Body<S>& b,
                                    const SweptOverlapOptions<S>& options = {});
// The verdict of the lecture's slow version.
template <Scalar S>
SweptOverlapResult<S> swept_overlap_before_after(const Body<S>& a, const Body<S>& b,
                                                 SweptOverlapOptions<S> options = {});
// Of the true shapes, decided exactly: see tier exact (cast.hpp). options.method is not read.
template <Scalar S>
SweptOverlapResult<S> swept_overlap_exact(const Body<S>& a, const Body<S>& b,
                                          const SweptOverlapOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/swept_overlap_query.hpp>
#endif
