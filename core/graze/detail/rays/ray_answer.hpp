// Converts a clip's result to the caller's scalar: outcome, times, and the point on the body.
#pragma once

#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/rays/ray_clip_any.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct RayTimes {
  bool known = false;
  Outcome outcome = Outcome::not_converged;
  S lower = 0, upper = 0;
};

// Not known: a clip that is open, and times that have no normal number.
template <Scalar S>
[[nodiscard, gnu::always_inline]] inline RayTimes<S> times_of(const RayHit& hit,
                                                              const CastOptions<S>& options) {
  switch (hit.kind) {
    case RayHit::Kind::open:
      break;
    case RayHit::Kind::start:
      // pass_over is about contact without the target distance, which the clip does not know.
      return {options.start_policy == StartPolicy::report || !(options.target_distance > 0),
              Outcome::initially_overlapping};
    case RayHit::Kind::miss:
      return {true, Outcome::miss, kInfinity<S>, kInfinity<S>};
    case RayHit::Kind::hit: {
      const S lower = round_down<S>(hit.t), upper = std::min(round_up<S>(hit.t), options.t_max);
      return {lower >= std::numeric_limits<S>::min() && lower <= upper && upper < kInfinity<S>, Outcome::hit,
              lower, upper};
    }
  }
  return {};
}

// For a hit at time t. The clip's surface is the target distance away from the body.
template <Scalar S>
[[nodiscard]] Triple point_on_body(const RayTarget<S>& target, const RayPath<S>& path, const RayHit& hit,
                                   double t) {
  const double m = path.target_distance;
  return target.placed(hit.x - m * hit.n, t);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
