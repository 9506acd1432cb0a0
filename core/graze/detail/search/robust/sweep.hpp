// The result of a linear search, and the clip of its path to C's bounds.
//
// The path is s r, s in [0, s_max], in the internal units of cso.hpp. Contact is where s r in C + ball(R).
#pragma once

#include <graze/detail/pairs/sweep_limits.hpp>
#include <graze/detail/search/robust/gjk.hpp>
#include <graze/detail/search/robust/portal.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct Sweep {
  Outcome outcome = Outcome::not_converged;
  S lower = 0, upper = kInfinity<S>;  // of s, unset for a miss
  S apart = kInfinity<S>;             // hit, not_converged: a bound of the distance at lower, internal length
  Vec3<S> n = Vec3<S>::Zero();  // unit axis that proves lower, or the miss (zero if lower is 0 by default)
  // hit: points of C and their weights, the combination at the contact. A point that has no direction e of its own
  // uses n.
  Simplex<S> contact;
};

template <Scalar S>
struct Clip {
  bool missed = false;
  S enter = 0, leave = kInfinity<S>;
  Vec3<S> n = Vec3<S>::Zero();  // proves enter (if > 0), or the miss
};

// The part of the path inside C's bounding box: three slabs. It narrows the interval, it never moves the
// origin.
template <Scalar S>
Clip<S> clip_to_bounds(const Cso<S>& cso, S s_max, Counters& counters) {
  Clip<S> out;
  out.leave = s_max;
  const Vec3<S>& r = cso.direction();
  Vec3<S> n_leave =
      Vec3<S>::Zero();  // n.r = 1 for both: their sum has n.r = 0 and proves a miss where leave < enter
  Vec3<S> n_enter = Vec3<S>::Zero();
  for (int i = 0; i < 3; ++i) {
    for (const S sign : {S(1), S(-1)}) {
      const Vec3<S> n = sign * Vec3<S>::Unit(i);
      const S h = dot(n, cso.support(n).w) + cso.radius(), speed = dot(n, r);
      ++counters.supports;
      if (speed == 0) {
        if (h < 0) {
          out.missed = true;
          out.n = n;
          return out;
        }
      } else if (speed < 0) {
        if (const S enter = h / speed; enter > out.enter) {
          out.enter = enter;
          n_enter = n / -speed;
        }
      } else if (const S leave = h / speed; leave < out.leave) {
        out.leave = leave;
        n_leave = n / speed;
      }
    }
  }
  // Outward by the rounding of h: the clip must never lose a contact.
  const S slack = cso.reach_error() + 4 * kUnitRoundoff<S> * cso.radius();
  const S slack_s = fl(slack * (norm_1(n_enter) + norm_1(n_leave))) + 4 * kUnitRoundoff<S> * out.enter;
  if (out.leave + slack_s < out.enter) {
    out.missed = true;
    out.n = unit(Vec3<S>(n_enter + n_leave));
    return out;
  }
  out.enter = std::max(out.enter - slack_s, S(0));
  out.leave = std::min(out.leave + slack_s, s_max);
  out.n = unit(n_enter);
  return out;
}

// Entry of the line into C, as a bracket of z = s |r|, closed to `gap`, or to `loose_gap` if that leaves no verdict
// open. `accepted`: it is at `early` or before. Where exactly was not asked.
template <Scalar S>
PortalSearch<S> enter_line(const Cso<S>& cso, const Frame<S>& frame, S z_max, S gap, int budget,
                           Counters& counters, S loose_gap = 0, S early = -kInfinity<S>) {
  const PortalView<S> view{cso, frame, S(1), counters};
  PortalSearch<S> search = find_portal(view, budget);
  if (search.state == PortalSearch<S>::State::entered) {
    refine_portal(view, search, PortalLimits<S>{early, z_max, gap, loose_gap, S(0)}, budget);
  }
  return search;
}

// Decides whether the line is still in C at z = 0, or beyond. `accepted`: yes. `rejected` or `missed`: no, and n
// proves it. `entered`: the exit is at 0 to the precision of rounding.
template <Scalar S>
PortalSearch<S> leave_line(const Cso<S>& cso, const Frame<S>& frame, S gap, int budget, Counters& counters) {
  const PortalView<S> view{cso, frame, S(-1), counters};
  PortalSearch<S> search = find_portal(view, budget);
  if (search.state == PortalSearch<S>::State::entered) {
    refine_portal(view, search, PortalLimits<S>{0, 0, gap}, budget);
  }
  return search;
}

// Portal points and weights as the contact of a sweep.
template <Scalar S>
Simplex<S> contact_of(const PortalSearch<S>& search) {
  Simplex<S> out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(search.portal.size); ++i) {
    out.add(search.portal.p[i].c);
    out.lambda[i] = search.lambda[i];
  }
  return out;
}

// Decides whether the origin is in C if a refinement closed its gap before that was known (state entered). The portal
// then lies nearly along the line, so neither its height nor its plane shows on which side of the origin the line
// enters. By the plane the origin is no deeper in C than the gap, and C is as near as the portal.
template <Scalar S>
bool holds_origin(const PortalSearch<S>& search, S noise) {
  return norm(closest_to_origin(contact_of(search), Vec3<S>(Vec3<S>::Zero())).v) <= noise;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
