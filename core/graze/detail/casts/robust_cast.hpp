// The robust searches as rungs of the standard tier: they take every shape, and always answer.
//
// A robust search takes a ray, or a path without end, clipped to C's bounds, and keeps a quarter of the budget for the
// start, or to advance from where it stopped. Its result becomes the cast's in `fill`.
#pragma once

#include <graze/detail/proving/prove.hpp>
#include <graze/detail/proving/witness.hpp>
#include <graze/detail/search/robust/advancement.hpp>
#include <graze/detail/search/robust/leaving.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
void fill(CastResult<S>& out, const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
          const Cso<S>& cso, const Sweep<S>& sweep) {
  out.outcome = sweep.outcome;
  if (out.outcome == Outcome::hit || out.outcome == Outcome::not_converged) {
    // Contact is at upper: what is left of the path bounds the distance as well.
    const S path = (sweep.upper - sweep.lower) * norm(cso.direction());
    out.distance = cso.to_length(std::max(std::min(sweep.apart, path), S(0)));
  }
  switch (sweep.outcome) {
    case Outcome::initially_overlapping:
      out.toi_lower = out.toi_upper = 0;
      break;
    case Outcome::miss:
      out.toi_lower = out.toi_upper = kInfinity<S>;
      break;
    default:
      // A time too large for S lies between its largest number and infinity.
      out.toi_lower = std::min({cso.to_time(sweep.lower), options.t_max, std::numeric_limits<S>::max()});
      out.toi_upper =
          sweep.upper < kInfinity<S> ? std::min(cso.to_time(sweep.upper), options.t_max) : kInfinity<S>;
  }
  if (out.outcome == Outcome::hit) {
    GRAZE_ASSERT(0 <= out.toi_lower && out.toi_lower <= out.toi_upper && out.toi_upper <= options.t_max);
    if (asks_for(options.request, Request::normal)) out.normal = sweep.n;
    if (asks_for(options.request, Request::witnesses)) {
      out.point_a = witness(a, cso.side_a(), cso, sweep.contact, sweep.n, true, out.toi_lower);
      out.point_b = witness(b, cso.side_b(), cso, sweep.contact, sweep.n, false, out.toi_lower);
    }
  }
  if (asks_for(options.request, Request::proof)) {
    out.proof = prove(a, b, options, out.outcome, out.toi_upper, sweep.n, out.counters);
  }
}

template <Scalar S, class Search>
[[gnu::noinline]] void search_with(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                   const Search& search, CastResult<S>& out) {
  const Cso<S> cso(a, b, options.target_distance);
  SweepLimits<S> limits = sweep_limits(cso, options);
  // A ray, or a path without end, is first clipped to C's bounds.
  Clip<S> clip;
  const bool ray = std::holds_alternative<Point<S>>(a.shape) || std::holds_alternative<Point<S>>(b.shape);
  if (limits.s_max > 0 && (ray || !(limits.s_max < kInfinity<S>))) {
    clip = clip_to_bounds(cso, limits.s_max, out.counters);
    limits.s_max = clip.leave;
  }
  Sweep<S> sweep;
  if (clip.missed) {
    sweep.outcome = Outcome::miss;
    sweep.n = clip.n;
  } else {
    SweepLimits<S> most = limits;
    most.budget -= limits.budget / 4;  // the rest is kept for the start
    sweep = search(cso, most, clip, out.counters);
  }
  // The search did not get beyond the start. Seen along the path C may be too thin for a portal, and yet hold
  // the origin: the overlap test, which starts from a point inside C, can tell. Beyond the start, a path along C's side
  // stops a ray cast and a portal, and not a distance.
  if (sweep.outcome == Outcome::not_converged) {
    Counters again;
    SweepLimits<S> rest = limits;
    rest.budget = limits.budget / 4;
    const bool got_on = sweep.lower > 0;
    const Sweep<S> last = got_on ? conservative_advancement(cso, rest, sweep.lower, sweep.n, again)
                                 : mpr_overlap(cso, rest, again);
    out.counters += again;
    if (last.outcome == Outcome::initially_overlapping || (got_on && last.outcome != Outcome::not_converged))
      sweep = last;
  }
  // A hit within the noise of the start is a start in contact, too.
  const bool at_start =
      sweep.outcome == Outcome::initially_overlapping ||
      (sweep.outcome == Outcome::hit && sweep.lower * norm(cso.direction()) <= limits.noise);
  if (options.start_policy == StartPolicy::pass_over && at_start) {
    const Start start = start_of(Cso<S>(a, b), limits, out.counters);
    if (start == Start::leaves) {
      out.outcome = Outcome::miss;
      out.toi_lower = out.toi_upper = kInfinity<S>;
      out.passed_over = true;
      return;
    }
    if (start == Start::open) sweep = {};
  }
  fill(out, a, b, options, cso, sweep);
}

template <Scalar S>
bool robust_advancement(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                        CastResult<S>& out) {
  search_with(
      a, b, options,
      [](const Cso<S>& cso, const SweepLimits<S>& limits, const Clip<S>& clip, Counters& counters) {
        return conservative_advancement(cso, limits, clip.enter, clip.n, counters);
      },
      out);
  return true;
}

template <Scalar S>
bool robust_gjk_ray(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  search_with(
      a, b, options,
      [](const Cso<S>& cso, const SweepLimits<S>& limits, const Clip<S>& clip, Counters& counters) {
        return gjk_ray_cast(cso, limits, clip.enter, clip.n, counters);
      },
      out);
  return true;
}

template <Scalar S>
bool robust_mpr_sweep(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  search_with(
      a, b, options,
      [](const Cso<S>& cso, const SweepLimits<S>& limits, const Clip<S>& clip, Counters& counters) {
        SweepLimits<S> part = limits;
        part.budget /= 3;
        Sweep<S> sweep = mpr_sweep(cso, part, counters);
        if (sweep.outcome == Outcome::not_converged) {
          // MPR cycles at the level of rounding, or is slow, as between rims that are nearly aligned: GJK is tried from
          // where it got.
          Counters again;
          part.budget = limits.budget - part.budget;
          const bool got_on = sweep.lower > clip.enter;
          sweep =
              gjk_ray_cast(cso, part, got_on ? sweep.lower : clip.enter, got_on ? sweep.n : clip.n, again);
          counters += again;
        }
        return sweep;
      },
      out);
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
