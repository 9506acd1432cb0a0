// Declared, with what it promises, in graze/overlap.hpp.
#pragma once

#include <graze/detail/pairs/prepared_body.hpp>
#include <graze/detail/search/fast/fast_gjk.hpp>
#include <graze/detail/search/fast/fast_overlap.hpp>
#include <graze/detail/search/robust/mpr.hpp>
#include <graze/distance.hpp>
#include <graze/overlap.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// The overlap of two polytopes, by MPR. If it returns false, nothing is proved and only the counters of `out`
// have changed.
template <Scalar S>
[[nodiscard]] bool fast_overlap_mpr(const PreparedPair<S>& pair, const WarmStart& start,
                                    OverlapResult<S>& out) {
  FastOverlap<S> search(pair, out.counters);
  const Outcome outcome = search.run(start);
  out.counters.iterations = out.counters.portal_steps;
  if (outcome == Outcome::not_converged) return false;
  out.outcome = outcome;
  if (outcome == Outcome::miss) out.normal = unit(search.axis().vector()).template cast<S>();
  out.warm = search.warm(outcome);
  return true;
}
// By GJK.
template <Scalar S>
[[nodiscard]] bool fast_overlap_gjk(const PreparedPair<S>& pair, const WarmStart& start,
                                    OverlapResult<S>& out) {
  PairSupport<S> support(pair, out.counters);
  FastGjk<S> gjk(support, out.counters);
  const FastState state = gjk.run(start, 0, true, CastOptions<S>{}.max_iterations);
  out.counters.iterations = out.counters.gjk_iterations;
  // For bodies that nearly touch the bracket decides, which is not computed here.
  if (state == FastState::open || (state == FastState::apart && !gjk.separated())) return false;
  out.outcome = state == FastState::apart ? Outcome::miss : Outcome::initially_overlapping;
  if (state == FastState::apart) out.normal = unit(gjk.axis().vector()).template cast<S>();
  out.warm = gjk.warm();
  return true;
}

// For every pair of shapes, validated.
template <Scalar S>
OverlapResult<S>& robust_overlap_mpr(const Body<S>& a, const Body<S>& b, OverlapResult<S>& out) {
  const Cso<S> cso(a, b);
  const Sweep<S> sweep = mpr_overlap(cso, sweep_limits(cso, CastOptions<S>{}), out.counters);
  out.outcome = sweep.outcome;
  if (sweep.outcome == Outcome::miss) out.normal = sweep.n;
  return out;
}
template <Scalar S>
OverlapResult<S>& robust_overlap_gjk(const Body<S>& a, const Body<S>& b, const WarmStart& start,
                                     OverlapResult<S>& out) {
  DistanceOptions<S> options;
  options.request = Request::normal;
  options.start = start;
  const DistanceResult<S> d = distance(a, b, options);
  out.counters += d.counters;
  out.normal = d.normal;
  out.warm = d.warm;
  out.outcome = d.lower > 0    ? Outcome::miss
                : d.upper == 0 ? Outcome::initially_overlapping
                               : Outcome::not_converged;
  return out;
}

}  // namespace detail

template <Scalar S>
OverlapResult<S> overlap_mpr(const Body<S>& a, const Body<S>& b, const WarmStart& start) {
  OverlapResult<S> out;
  const CastOptions<S> options;
  out.invalid = validate(a, b, options);
  if (detail::refused(out, a, b, options)) return out;
  if (detail::has_fast_search(a.shape) && detail::has_fast_search(b.shape) &&
      detail::fast_overlap_mpr(detail::PreparedPair<S>(a, b), start, out))
    return out;
  return detail::robust_overlap_mpr(a, b, out);
}
template <Scalar S>
OverlapResult<S> overlap_mpr(const Prepared<S>& a, const Prepared<S>& b, const WarmStart& start) {
  OverlapResult<S> out;
  const CastOptions<S> options;
  out.invalid = detail::validate_prepared(a, b, options);
  if (detail::refused(out, a.body(), b.body(), options)) return out;
  if (detail::both_prepared(a, b) &&
      detail::fast_overlap_mpr(detail::PreparedPair<S>(*a.inner().core, *b.inner().core), start, out))
    return out;
  return detail::robust_overlap_mpr(a.body(), b.body(), out);
}

template <Scalar S>
OverlapResult<S> overlap_gjk(const Body<S>& a, const Body<S>& b, const WarmStart& start) {
  OverlapResult<S> out;
  const CastOptions<S> checked;
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked)) return out;
  if (detail::has_fast_search(a.shape) && detail::has_fast_search(b.shape) &&
      detail::fast_overlap_gjk(detail::PreparedPair<S>(a, b), start, out))
    return out;
  return detail::robust_overlap_gjk(a, b, start, out);
}
template <Scalar S>
OverlapResult<S> overlap_gjk(const Prepared<S>& a, const Prepared<S>& b, const WarmStart& start) {
  OverlapResult<S> out;
  const CastOptions<S> checked;
  out.invalid = detail::validate_prepared(a, b, checked);
  if (detail::refused(out, a.body(), b.body(), checked)) return out;
  if (detail::both_prepared(a, b) &&
      detail::fast_overlap_gjk(detail::PreparedPair<S>(*a.inner().core, *b.inner().core), start, out))
    return out;
  return detail::robust_overlap_gjk(a.body(), b.body(), start, out);
}

}}  // namespace graze::GRAZE_LINKAGE
