// Declared, with what it promises, in graze/line.hpp.
#pragma once

#include <graze/detail/search/robust/mpr.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/line.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// One end of the line's part in C, z = s |r| in the view (mirrored at the far end).
template <Scalar S>
struct LineEnd {
  using State = typename PortalSearch<S>::State;
  State state = State::exhausted;  // entered, missed, or exhausted with the bracket so far
  S lower = -kInfinity<S>, upper = kInfinity<S>;
  Vec3<S> n = Vec3<S>::Zero();  // unit: proves lower, or the miss
  Simplex<S> contact;  // where upper is finite: points of C and their weights, the combination at upper
};

// mirror is 1 for the entry of the line and -1 for its exit. decided_at: a z that no tolerance leaves inside the
// bracket.
template <Scalar S>
LineEnd<S> line_end(const Cso<S>& cso, const Frame<S>& frame, S mirror, const SweepLimits<S>& limits,
                    Counters& counters, S decided_at = -kInfinity<S>) {
  using State = typename PortalSearch<S>::State;
  const detail::PortalView<S> view{cso, frame, mirror, counters};
  PortalSearch<S> search = find_portal(view, limits.budget);
  if (search.state == State::entered) {
    const PortalLimits<S> stop{-kInfinity<S>, kInfinity<S>, limits.noise / 2, limits.target / 2, decided_at};
    refine_portal(view, search, stop, limits.budget);
  }
  LineEnd<S> out;
  out.state = search.state;
  out.n = search.n;
  if (search.state == State::missed) return out;
  out.upper = search.upper;
  out.lower = std::min(search.lower, search.upper);
  if (search.state != State::entered) {
    if (search.portal.size > 0) search.lambda = detail::portal_weights(search.portal);
    out.contact = contact_of(search);
    return out;
  }
  out.contact = contact_of(search);
  // A portal whose plane lies almost along the line: where exactly the plane meets it is the plane's rounding
  // over n_z, while the portal's own point is no deeper in C than the gap (mpr.hpp).
  const S width = out.upper - out.lower;
  const bool beside = out.lower > decided_at + 2 * limits.noise || out.upper + 2 * limits.noise < decided_at;
  if (width > limits.target || (width > limits.noise && !beside)) {
    out.lower = out.upper;
    out.n = search.facing;
  }
  return out;
}

template <Scalar S>
void fill_line(LineResult<S>& out, const Cso<S>& cso, const Frame<S>& frame, const LineEnd<S>& in,
               const LineEnd<S>& leave, Request request) {
  S in_lower = in.lower, in_upper = in.upper, out_lower = -leave.upper, out_upper = -leave.lower;
  if (in_upper > out_lower && out.outcome == Outcome::hit) {
    // A graze: both ends are points of C, in an order that is rounding.
    std::swap(in_upper, out_lower);
    in_lower = std::min(in_lower, in_upper);
    out_upper = std::max(out_upper, out_lower);
  }
  // A time too large for S lies between its largest number and infinity, of either sign.
  constexpr S largest = std::numeric_limits<S>::max();
  out.in_lower = std::min(cso.to_time(in_lower / frame.length), largest);
  out.in_upper = std::max(cso.to_time(in_upper / frame.length), -largest);
  out.out_lower = std::min(cso.to_time(out_lower / frame.length), largest);
  out.out_upper = std::max(cso.to_time(out_upper / frame.length), -largest);
  if (out.outcome == Outcome::hit && asks_for(request, Request::normal)) {
    out.normal_in = in.n;
    out.normal_out = leave.n;
  }
}

}  // namespace detail

template <Scalar S>
LineResult<S> line(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options) {
  using State = typename detail::PortalSearch<S>::State;
  LineResult<S> out;
  CastOptions<S> checked;
  checked.tolerance = options.tolerance;
  checked.max_iterations = options.max_iterations;
  checked.target_distance = options.target_distance;
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked)) return out;
  const detail::Cso<S> cso(a, b, options.target_distance);
  const detail::SweepLimits<S> limits = detail::sweep_limits(cso, checked);
  if (!cso.moves()) {
    const detail::Sweep<S> rest = detail::mpr_overlap(cso, limits, out.counters);
    out.outcome = rest.outcome == Outcome::initially_overlapping ? Outcome::hit : rest.outcome;
    if (out.outcome == Outcome::miss) out.normal_in = rest.n;
    if (out.outcome == Outcome::hit) {
      out.in_upper = -kInfinity<S>;
      out.out_lower = kInfinity<S>;
    }
    return out;
  }
  const detail::Frame<S> frame(cso.direction());
  const detail::LineEnd<S> in = detail::line_end(cso, frame, S(1), limits, out.counters);
  detail::LineEnd<S> leave;
  if (in.state != State::missed) leave = detail::line_end(cso, frame, S(-1), limits, out.counters);
  out.counters.iterations = out.counters.portal_steps;
  if (in.state == State::missed || leave.state == State::missed) {
    out.outcome = Outcome::miss;
    out.normal_in = in.state == State::missed ? in.n : leave.n;
    return out;
  }
  const bool found = in.state == State::entered && leave.state == State::entered;
  out.outcome = found ? Outcome::hit : Outcome::not_converged;
  detail::fill_line(out, cso, frame, in, leave, options.request);
  return out;
}

}}  // namespace graze::GRAZE_LINKAGE
