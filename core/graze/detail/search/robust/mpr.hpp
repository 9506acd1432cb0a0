// MPR: overlap, and the linear sweep.
//
// The sweep follows the lecture's four steps, in the order in which they are cheapest. The line {s r} enters
// C at s_in and leaves it at s_out. Contact is in [0, s_max] iff s_in <= s_max and s_out >= 0.
//   steps 2, 3   a portal that the line passes, refined to the surface of C: s_in
//   step 4       the weights of the portal's corners give the contact point
//   step 1       "do the swept shapes collide?": no, if the line misses C or s_in > s_max. If s_in <= 0,
//                a portal on the far side of C decides whether s_out >= 0.
// The lecture's t = 1 - d / |v| is s_in measured from the end of the path. Here s is measured from its
// beginning, so that nothing cancels. [Snethen, XenoCollide, in Game Programming Gems 7, 2008]
#pragma once

#include <graze/detail/search/robust/sweep.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Does C + ball(R) hold the origin? The ray from a point of C's inside through the origin: it leaves C beyond
// the origin, or not. n proves a miss.
template <Scalar S>
Sweep<S> mpr_overlap(const Cso<S>& cso, const SweepLimits<S>& limits, Counters& counters) {
  using State = typename PortalSearch<S>::State;
  Sweep<S> out;
  out.upper = 0;
  // The mean of six of its points: inside C, or on its surface.
  Vec3<S> inside = Vec3<S>::Zero();
  for (int i = 0; i < 3; ++i) {
    inside += cso.support(Vec3<S>::Unit(i)).w / 6 + cso.support(-Vec3<S>::Unit(i)).w / 6;
    counters.supports += 2;
  }
  if (!(inside.cwiseAbs().maxCoeff() > 0)) {
    out.outcome = Outcome::initially_overlapping;
    return out;
  }
  const Frame<S> frame(-inside);
  const PortalSearch<S> search = leave_line(cso, frame, limits.noise, limits.budget, counters);
  counters.iterations = counters.portal_steps;
  switch (search.state) {
    case State::accepted:
    case State::entered:
      out.outcome = Outcome::initially_overlapping;
      out.contact = contact_of(search);
      if (search.state == State::entered && !holds_origin(search, limits.noise)) {
        out.outcome = Outcome::miss;
        out.n = search.facing;
      }
      break;
    case State::rejected:
    case State::missed:
      out.outcome = Outcome::miss;
      out.n = search.n;
      break;
    case State::exhausted:
      out.upper = kInfinity<S>;
      break;
  }
  return out;
}

template <Scalar S>
Sweep<S> mpr_sweep(const Cso<S>& cso, const SweepLimits<S>& limits, Counters& counters) {
  using State = typename PortalSearch<S>::State;
  if (!(limits.s_max > 0)) return mpr_overlap(cso, limits, counters);
  Sweep<S> out;
  const Frame<S> frame(cso.direction());
  const S z_max = limits.s_max * frame.length;
  const PortalSearch<S> in = enter_line(cso, frame, z_max, limits.noise / 2, limits.budget, counters,
                                        limits.target / 2, -2 * limits.noise);
  counters.iterations = counters.portal_steps;
  out.n = in.n;
  if (in.state == State::missed || in.state == State::rejected) {
    out.outcome = Outcome::miss;
    return out;
  }
  // A lower bound above the upper one is rounding.
  out.upper = std::max(in.upper, S(0)) / frame.length;
  out.lower = std::min(std::max(in.lower, S(0)) / frame.length, out.upper);
  if (in.upper > z_max && in.state == State::entered) out.upper = limits.s_max;
  // The portal is at the surface to the precision of rounding, but its plane lies almost along the line:
  // where exactly it begins is the plane's rounding over n_z. The portal's own point is no deeper in C than
  // the gap.
  const S width = in.upper - in.lower;
  const bool within = in.lower > 2 * limits.noise && in.upper + limits.noise < z_max;
  const bool along = in.state == State::entered && width > limits.noise && (width > limits.target || !within);
  if (along) {
    out.lower = out.upper;
    out.n = in.facing;
    if (in.upper > z_max + limits.noise) {
      out.outcome = Outcome::miss;
      return out;
    }
  }
  out.contact = contact_of(in);
  if (in.state == State::exhausted) {
    // The line's contact is the path's only between its ends.
    if (!(in.upper > 0 && in.upper <= z_max)) out.upper = kInfinity<S>;
    return out;
  }
  if ((in.lower > 0 || along) && in.upper > limits.noise) {
    out.outcome = Outcome::hit;
    return out;
  }
  // The line is in C before the path begins, or enters as it begins.
  const PortalSearch<S> leave = leave_line(cso, frame, limits.noise, limits.budget, counters);
  counters.iterations = counters.portal_steps;
  out.lower = 0;
  if (leave.state == State::missed || leave.state == State::rejected) {
    out.outcome = Outcome::miss;
    out.n = leave.n;
  } else if (leave.state == State::entered && in.upper <= limits.noise &&
             !holds_origin(leave, limits.noise)) {
    out.outcome = Outcome::miss;
    out.n = leave.facing;
  } else if (leave.state == State::exhausted) {
    if (!(in.upper > 0)) out.upper = kInfinity<S>;
  } else {
    out.outcome = in.upper > limits.noise ? Outcome::hit : Outcome::initially_overlapping;
    if (out.outcome == Outcome::initially_overlapping) out.upper = 0;
  }
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
