// The cast of a point in tier standard, by the direct clips. False where they leave it open.
#pragma once

#include <graze/detail/proving/prove.hpp>
#include <graze/detail/rays/ray_answer.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
[[nodiscard]] bool has_clip(const Shape<S>& shape) {
  return std::holds_alternative<Triangle<S>>(shape) || std::holds_alternative<Sphere<S>>(shape) ||
         std::holds_alternative<Capsule<S>>(shape) || std::holds_alternative<Box<S>>(shape) ||
         std::holds_alternative<Ellipsoid<S>>(shape) || std::holds_alternative<Cylinder<S>>(shape) ||
         std::holds_alternative<Cone<S>>(shape);
}
// A point against a shape that has a clip.
template <Scalar S>
[[nodiscard]] bool is_ray(const Body<S>& a, const Body<S>& b) {
  return (std::holds_alternative<Point<S>>(b.shape) && has_clip(a.shape)) ||
         (std::holds_alternative<Point<S>>(a.shape) && has_clip(b.shape));
}

template <Scalar S>
[[nodiscard]] RayPath<S> path_of(const Body<S>& point, const CastOptions<S>& options) {
  return {point.position, point.displacement, double(options.t_max), double(options.target_distance)};
}

// A hit's normal and witnesses at `lower`, the caller's time.
template <Scalar S>
[[gnu::always_inline]] inline void fill_ray_contact(const RayTarget<S>& target, const RayPath<S>& path,
                                                    const RayHit& hit, bool point_is_b, S lower,
                                                    const CastOptions<S>& options, CastResult<S>& out) {
  if (asks_for(options.request, Request::normal | Request::proof))
    out.normal = target.to_world((point_is_b ? 1.0 : -1.0) * hit.n).vector().template cast<S>();
  if (!asks_for(options.request, Request::witnesses)) return;
  const double t = double(lower);
  (point_is_b ? out.point_a : out.point_b) = point_on_body(target, path, hit, t).vector().template cast<S>();
  (point_is_b ? out.point_b : out.point_a) =
      (triple(path.origin) + t * triple(path.displacement)).vector().template cast<S>();
}

// False: nothing is claimed, and `out` has not changed. The bodies have passed validate().
template <Scalar S>
[[nodiscard, gnu::noinline]] bool clip_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                            CastResult<S>& out) {
  const bool point_is_b = std::holds_alternative<Point<S>>(b.shape);
  const RayTarget<S> target(point_is_b ? a : b);
  const RayPath<S> path = path_of(point_is_b ? b : a, options);
  RayHit hit;
  clip_any(target, path, hit);
  const RayTimes<S> times = times_of<S>(hit, options);
  if (!times.known) return false;
  out.outcome = times.outcome;
  out.toi_lower = times.lower;
  out.toi_upper = times.upper;
  if (times.outcome == Outcome::hit) {
    if constexpr (!std::same_as<S, double>) {
      const Triple w = triple(path.displacement) - triple(target.body().displacement);
      out.distance = round_up<S>((double(times.upper) - double(times.lower)) * square_root(dot(w, w)));
    }
    fill_ray_contact(target, path, hit, point_is_b, times.lower, options, out);
  }
  if (asks_for(options.request, Request::proof)) {
    out.proof = prove(a, b, options, out.outcome, out.toi_upper, out.normal, out.counters);
    if (!asks_for(options.request, Request::normal)) out.normal.setZero();
  }
  return true;
}

template <Scalar S>
bool ray_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  return is_ray(a, b) && clip_cast(a, b, options, out);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
