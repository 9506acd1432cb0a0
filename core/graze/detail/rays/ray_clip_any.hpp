// A ray against a body of any shape that has a direct answer: box, triangle, sphere, capsule, cylinder, cone, ellipsoid.
//
// Another shape, a target distance beside anything but a sphere or a capsule, and a shape without roundness where it
// should have some, are left open.
#pragma once

#include <graze/detail/rays/ray_box.hpp>
#include <graze/detail/rays/ray_capsule.hpp>
#include <graze/detail/rays/ray_cone.hpp>
#include <graze/detail/rays/ray_cylinder.hpp>
#include <graze/detail/rays/ray_ellipsoid.hpp>
#include <graze/detail/rays/ray_triangle.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The path of a point.
template <Scalar S>
struct RayPath {
  const Vec3<S>&origin, &displacement;
  double t_max, target_distance;
};

// answer(solid, ray), if the shape is a solid of rays/ray_clip.hpp. Otherwise the value of `otherwise`.
template <Scalar S, class Result, class Go>
[[gnu::always_inline]] inline Result with_solid(const RayTarget<S>& target, const RayPath<S>& path,
                                                Result otherwise, const Go& go) {
  const Shape<S>& shape = target.body().shape;
  const auto answer = [&](const auto& solid) {
    return go(solid, target.ray(path.origin, path.displacement, solid.reach(), path.t_max));
  };
  const double m = path.target_distance;
  if (const auto* sphere = std::get_if<Sphere<S>>(&shape))
    return sphere->radius > 0 ? answer(RayCapsule{double(sphere->radius) + m, 0}) : otherwise;
  if (const auto* capsule = std::get_if<Capsule<S>>(&shape))
    return capsule->radius > 0 ? answer(RayCapsule{double(capsule->radius) + m, double(capsule->half_height)})
                               : otherwise;
  if (m > 0) return otherwise;
  if (const auto* cylinder = std::get_if<Cylinder<S>>(&shape))
    return cylinder->radius > 0 ? answer(RayCylinder{double(cylinder->radius), double(cylinder->half_height)})
                                : otherwise;
  if (const auto* cone = std::get_if<Cone<S>>(&shape))
    return cone->radius > 0 && cone->half_height > 0
               ? answer(RayCone(double(cone->radius), double(cone->half_height)))
               : otherwise;
  if (const auto* ellipsoid = std::get_if<Ellipsoid<S>>(&shape))
    return ellipsoid->radii.minCoeff() > 0 ? answer(RayEllipsoid(triple(ellipsoid->radii))) : otherwise;
  return otherwise;
}

// Box and triangle: every answer but `open` is that of the true shapes. out: open.
template <Scalar S>
[[gnu::always_inline]] inline void clip_polytope(const RayTarget<S>& target, const RayPath<S>& path,
                                                 RayHit& out) {
  if (path.target_distance > 0) return;
  if (const auto* box = std::get_if<Box<S>>(&target.body().shape)) {
    const Triple h = triple(box->half_extents);
    clip_box(h, target.ray(path.origin, path.displacement, sum(h), path.t_max), target.turned(), out);
  } else if (const auto* triangle = std::get_if<Triangle<S>>(&target.body().shape)) {
    const std::array<Triple, 3> own = {triple(triangle->a), triple(triangle->b), triple(triangle->c)};
    const auto length = [](const Triple& x) { return sum(magnitude(x)); };
    const double reach = greater(greater(length(own[0]), length(own[1])), length(own[2]));
    if (reach <= 4 * greater(length(own[1] - own[0]), length(own[2] - own[0])))
      clip_triangle(own, target.ray(path.origin, path.displacement, reach, path.t_max), out);
  }
}

template <Scalar S>
[[gnu::noinline]] void clip_solid(const RayTarget<S>& target, const RayPath<S>& path, RayHit& out) {
  with_solid(target, path, 0, [&](const auto& solid, const Ray& ray) {
    SolidClip(solid, ray).run(out);
    return 0;
  });
}

// For tier standard. Triangles are left to the walk: the time at a sliver would round by more than the guarantee allows.
template <Scalar S>
[[gnu::always_inline]] inline void clip_any(const RayTarget<S>& target, const RayPath<S>& path, RayHit& out) {
  if (!std::holds_alternative<Triangle<S>>(target.body().shape)) clip_polytope(target, path, out);
  if (out.kind == RayHit::Kind::open) clip_solid(target, path, out);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
