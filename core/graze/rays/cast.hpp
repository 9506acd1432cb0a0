// The cast of a point in tier standard, by the direct clips. False where they leave it open.
#pragma once

#include <graze/numeric/rounding.hpp>
#include <graze/rays/clip_any.hpp>
#include <graze/standard/prove.hpp>

namespace graze::inline GRAZE_LINKAGE::detail {

// One body, and no more, is a point.
template <Scalar S>
[[nodiscard]] bool is_ray(const Body<S>& a, const Body<S>& b) {
  return std::holds_alternative<Point<S>>(a.shape) != std::holds_alternative<Point<S>>(b.shape);
}

template <Scalar S>
[[nodiscard]] RayPath<S> path_of(const Body<S>& point, const CastOptions<S>& options) {
  return {point.position, point.displacement, double(options.t_max), double(options.target_distance)};
}

// Of a hit: normal and witnesses at `lower`, the caller's time. n: own axes, from the body to the point.
template <Scalar S>
[[gnu::always_inline]] inline void fill_ray_contact(const RayTarget<S>& target, const Body<S>& point, const RayHit& hit, bool point_is_b, S lower,
                      const CastOptions<S>& options, CastResult<S>& out) {
  if (asks_for(options.request, Request::normal | Request::proof)) {
    const Triple n = target.to_world(point_is_b ? hit.n : -hit.n);
    out.normal = n.vector().template cast<S>();
  }
  if (!asks_for(options.request, Request::witnesses)) return;
  const double t = double(lower), m = double(options.target_distance);
  // The surface is m from the body.
  const Triple on_body = m > 0 ? hit.x - m * hit.n : hit.x;
  (point_is_b ? out.point_a : out.point_b) = target.placed(on_body, t).vector().template cast<S>();
  (point_is_b ? out.point_b : out.point_a) =
      (triple(point.position) + t * triple(point.displacement)).vector().template cast<S>();
}

// What the clip says, as a cast's answer; false if nothing is claimed. `target` is of the body that is no point.
template <Scalar S>
[[nodiscard, gnu::always_inline]] inline bool ray_answer(const RayTarget<S>& target, const Body<S>& point, bool point_is_b,
                              const CastOptions<S>& options, CastResult<S>& out) {
  const RayHit hit = clip_any(target, path_of(point, options));
  switch (hit.kind) {
    case RayHit::Kind::open:
      return false;
    case RayHit::Kind::start:
      // A start that is deeper than the target distance is one under pass_over, too. Less is not known here.
      if (options.start_policy == StartPolicy::pass_over && options.target_distance > 0) return false;
      out.outcome = Outcome::initially_overlapping;
      out.toi_lower = out.toi_upper = 0;
      return true;
    case RayHit::Kind::miss:
      out.outcome = Outcome::miss;
      out.toi_lower = out.toi_upper = kInfinity<S>;
      return true;
    case RayHit::Kind::hit:
      break;
  }
  const S lower = exact::round_down<S>(hit.t), upper = std::min(exact::round_up<S>(hit.t), options.t_max);
  if (!(lower >= std::numeric_limits<S>::min() && lower <= upper && upper < kInfinity<S>)) return false;
  out.outcome = Outcome::hit;
  out.toi_lower = lower;
  out.toi_upper = upper;
  if constexpr (!std::same_as<S, double>) {
    const Triple w = triple(point.displacement) - triple(target.body().displacement);
    out.distance = exact::round_up<S>((double(upper) - double(lower)) * std::sqrt(dot(w, w)));
  }
  fill_ray_contact(target, point, hit, point_is_b, lower, options, out);
  return true;
}

// False: nothing is claimed, and `out` has not changed. The bodies have passed validate().
template <Scalar S>
[[nodiscard, gnu::noinline]] bool clip_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  const bool point_is_b = std::holds_alternative<Point<S>>(b.shape);
  const RayTarget<S> target(point_is_b ? a : b);
  if (!ray_answer(target, point_is_b ? b : a, point_is_b, options, out)) return false;
  if (asks_for(options.request, Request::proof)) {
    out.proof = prove(a, b, options, out.outcome, out.toi_upper, out.normal, out.counters);
    if (!asks_for(options.request, Request::normal)) out.normal.setZero();
  }
  return true;
}

template <Scalar S>
[[nodiscard]] bool ray_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  return is_ray(a, b) && clip_cast(a, b, options, out);
}

}  // namespace graze::inline GRAZE_LINKAGE::detail
