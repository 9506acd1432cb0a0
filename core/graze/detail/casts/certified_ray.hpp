// The cast of a point at a sphere, capsule, cylinder, cone or ellipsoid in tier certified: a bracket around the clip's time.
//
// Let e = predicate_error (ray.hpp), n be the clip's unit normal and t the time that the clip found.
//   lower   n.x = h(n) + 1.25 e there: n.x falls along the ray, so no time before is in contact. e / 4 is for the
//           rounding of lower itself, 4 u t |w| <= 4 u (|o|_1 + reach).
//   upper   The solid holds the ball of radius e about x.
//   width   |x - nearest(x)| at lower, and the depth before upper, h(n) - n.x there, each with e more.
// The clip proves a miss and a start in contact. Tier exact decides what it leaves open at a cylinder, a cone or an
// ellipsoid (exact_ray.hpp).
#pragma once

#include <graze/detail/casts/certified_bracket.hpp>
#include <graze/detail/casts/ray_cast.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Moves the hit to `lower`.
template <class Solid>
[[nodiscard]] CertifiedBracket bracket_ray(const Solid& solid, const Ray& ray, RayHit& hit) {
  CertifiedBracket out;
  const double e = ray.predicate_error, rate = -dot(hit.n, ray.w), h = solid.support(hit.n);
  // No diagonal of bounds is below the reach of any of these solids.
  const double width = kLinearCertifiedWidth * (1 - 0x1p-20) * greater(largest(ray.o), solid.reach());
  if (!(rate > 0)) return out;
  out.lower = hit.t + (dot(hit.n, ray.at(hit.t)) - (h + fl(1.25 * e))) / rate;
  const Triple x = ray.at(out.lower);
  hit.x = solid.nearest(x);
  const Triple off = x - hit.x;
  out.apart = square_root(dot(off, off)) + e;
  for (const double deeper : {4.0, 16.0, 64.0}) {
    out.upper = hit.t + deeper * e / rate;
    const Triple y = ray.at(out.upper);
    if (!solid.contains(y, e)) continue;
    const double depth = h - dot(hit.n, y) + e;
    out.proved = out.lower > 0 && out.upper <= ray.t_max && out.apart <= width && depth <= width;
    break;
  }
  return out;
}

template <Scalar S>
[[nodiscard, gnu::noinline]] bool clip_certified(const Body<S>& a, const Body<S>& b,
                                                 const CastOptions<S>& options, CastResult<S>& out) {
  const bool point_is_b = std::holds_alternative<Point<S>>(b.shape);
  const RayTarget<S> target(point_is_b ? a : b);
  const RayPath<S> path = path_of(point_is_b ? b : a, options);
  return with_solid(target, path, false, [&](const auto& solid, const Ray& ray) {
    RayHit hit;
    SolidClip(solid, ray).run(hit);
    if (hit.kind == RayHit::Kind::open) return false;
    if (hit.kind == RayHit::Kind::hit) {
      const CertifiedBracket bracket = bracket_ray(solid, ray, hit);
      if (!bracket.proved || !fill_bracket(a, b, options, bracket, 0, 0, out)) return false;
      fill_ray_contact(target, path, hit, point_is_b, out.toi_lower, options, out);
      if (!asks_for(options.request, Request::normal)) out.normal.setZero();
      return true;
    }
    const bool starts = hit.kind == RayHit::Kind::start;
    out.outcome = starts ? Outcome::initially_overlapping : Outcome::miss;
    out.toi_lower = out.toi_upper = starts ? S(0) : kInfinity<S>;
    return true;
  });
}

// False: nothing is claimed, and `out` has not changed. The bodies have passed validate().
template <Scalar S>
bool ray_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  return is_ray(a, b) && options.start_policy == StartPolicy::report && clip_certified(a, b, options, out);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
