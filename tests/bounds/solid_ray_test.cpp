// The pairs of doubles that bracket a ray's entry into an ellipsoid, a cylinder or a cone (search/exact/solid_ray_bracket.hpp):
// how far a point of the ray is inside of each bound, beside the same polynomials in balls of 4,096 bits.
#include <gtest/gtest.h>

#include <graze/cast.hpp>
#include <graze/detail/search/exact/solid_ray_bracket.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"

namespace graze::test {
namespace {

using oracle::WorkingPrecision;

struct Ray {
  Body<double> solid, point;
  double t = 0;
};

// A point of the ray in the axes of the solid about its centre, times W = |q|^2.
struct TruePoint {
  BallVec x;
  Ball weight;
};
TruePoint true_point(const Ray& ray, const Ball& t) {
  const Quaternion<double> q = ray.solid.orientation.is_identity()
                                   ? Quaternion<double>{}
                                   : detail::exact::scaled_to_one(ray.solid.orientation);
  const Ball w(q.w);
  const BallVec u(-Vec3<double>(q.x, q.y, q.z));
  const BallVec way = BallVec(ray.point.displacement) - BallVec(ray.solid.displacement);
  const BallVec d = (BallVec(ray.point.position) - BallVec(ray.solid.position)) + t * way;
  // conj(q) d q = (w^2 - u.u) d + 2 (u.d) u + 2 w u x d, with the reversed u.
  return {((w * w - dot(u, u)) * d + (Ball(2) * dot(u, d)) * u) + (Ball(2) * w) * cross(u, d),
          w * w + dot(u, u)};
}

// -g and the ways to the planes, times W^2 and W, and minus half of the gradient of -g.
struct TrueDepths {
  Ball inside[3];
  int size = 1;
  BallVec gradient;
};
TrueDepths true_depths(const Ray& ray, const Ball& t) {
  const auto [x, weight] = true_point(ray, t);
  TrueDepths out;
  if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&ray.solid.shape)) {
    const Ball a(ellipsoid->radii[0]), b(ellipsoid->radii[1]), c(ellipsoid->radii[2]);
    const Ball p = x.x * b * c, r = x.y * a * c, s = x.z * a * b, all = a * b * c * weight;
    out.inside[0] = all * all - (p * p + r * r + s * s);
    out.gradient = {p * b * c, r * a * c, s * a * b};
    return out;
  }
  out.size = 3;
  Ball half;
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&ray.solid.shape)) {
    const Ball r = Ball(cylinder->radius) * weight;
    half = Ball(cylinder->half_height) * weight;
    out.inside[0] = r * r - (x.x * x.x + x.y * x.y);
    out.gradient = {x.x, x.y, Ball(0)};
  } else {
    const auto& cone = std::get<Cone<double>>(ray.solid.shape);
    half = Ball(cone.half_height) * weight;
    const Ball below = Ball(cone.radius) * (half - x.z), two = Ball(2) * Ball(cone.half_height);
    out.inside[0] = below * below - (two * two) * (x.x * x.x + x.y * x.y);
    out.gradient = {two * two * x.x, two * two * x.y, Ball(cone.radius) * below};
  }
  out.inside[1] = x.z + half;
  out.inside[2] = half - x.z;
  return out;
}

// The quadric's outward normal, in world axes, where the path enters it after `from`.
BallVec true_normal(const Ray& ray, double from) {
  // inside is a + b s + c s^2 at from + s, so three values give it.
  const Ball at(from), a = true_depths(ray, at).inside[0], up = true_depths(ray, at + Ball(1)).inside[0],
                       down = true_depths(ray, at - Ball(1)).inside[0];
  const Ball b = (up - down) / Ball(2), c = (up + down) / Ball(2) - a;
  const Ball step = -(Ball(2) * a) / (b + sqrt(b * b - Ball(4) * a * c));
  const BallVec n = true_depths(ray, at + step).gradient;
  return unit_of(BallRotation(ray.solid.orientation).apply(n));
}

// At t it is at a point inside of the solid's bounds, or near its centre.
Ray draw_ray(HostileDraw& draw) {
  Ray out;
  const double size = 1;
  const auto extent = [&] {
    return size * (draw.chance(0.3) ? draw.power(-15, 0) : draw.plain().between(0.5, 2));
  };
  switch (draw.below(3)) {
    case 0:
      out.solid.shape = Ellipsoid<double>{{extent(), extent(), extent()}};
      break;
    case 1:
      out.solid.shape = Cylinder<double>{extent(), extent()};
      break;
    default:
      out.solid.shape = Cone<double>{extent(), extent()};
      break;
  }
  const auto vector = [&](double length) {
    return Vec3<double>(length * draw.plain().between(-1, 1), length * draw.plain().between(-1, 1),
                        length * draw.plain().between(-1, 1));
  };
  if (draw.chance(0.7)) {
    out.solid.orientation = draw.plain().turn<double>();
    // Largest weights there are: four components of nearly 2.
    Quaternion<double>& q = out.solid.orientation;
    if (draw.chance(0.5))
      for (double* c : {&q.w, &q.x, &q.y, &q.z}) *c = std::copysign(2 - draw.power(-50, -2), *c);
  }
  const double far = draw.chance(0.5) ? size : size * draw.power(0, 40);
  out.solid.position = vector(draw.chance(0.5) ? far : size);
  out.solid.displacement = vector(draw.chance(0.5) ? far : 0);
  out.point.position = out.solid.position + vector(far);
  out.t = draw.power(-20, 20);
  const Vec3<double> aim = out.solid.position + vector(draw.chance(0.7) ? size : size * 0x1p-30);
  out.point.displacement = out.solid.displacement + (aim - out.point.position) / out.t;
  // In the units of the bracket.
  const double unit = power_of_two(-exponent_of(detail::exact::largest_extent(out.solid.shape)));
  std::visit(
      [&]<class T>(T& shape) {
        if constexpr (requires { shape.radii; }) {
          shape.radii *= unit;
        } else if constexpr (requires { shape.half_height; }) {
          shape.radius *= unit;
          shape.half_height *= unit;
        }
      },
      out.solid.shape);
  for (Body<double>* body : {&out.solid, &out.point}) {
    body->position *= unit;
    body->displacement *= unit;
  }
  return out;
}

TEST(SolidRayBounds, DepthsOfAPointOnTheRay) {
  const WorkingPrecision precision(4096);
  HostileDraw draw(211);
  Tally quadric("ray at a solid: how far inside of the quadric"),
      planes("ray at a solid: how far from the planes");
  for (int i = 0; i < rounds(4000); ++i) {
    Ray ray = draw_ray(draw);
    const detail::exact::SolidRayBracket bracket(ray.solid, ray.point);
    // At the contact, where the depth is what is left of terms that cancel, or anywhere.
    const CastResult<double> hit = cast(ray.solid, ray.point, {.t_max = kInfinity<double>});
    if (hit.outcome == Outcome::hit && hit.toi_lower > 0) ray.t = hit.toi_lower;
    const auto depths = bracket.depths_at<false>(ray.t);
    const TrueDepths truth = true_depths(ray, Ball(ray.t));
    const auto with = [&] {
      std::ostringstream out;
      out << std::hexfloat << "  shape " << ray.solid.shape.index() << " t " << ray.t << "\n";
      return out.str();
    };
    const auto bound = [&](std::size_t k) { return depths.error[k] + 0x1p-53 * std::abs(depths.inside[k]); };
    if (depths.error[0] < kInfinity<double>)
      quadric.add(bound(0), abs(Ball(depths.inside[0]) - truth.inside[0]), with);
    for (std::size_t k = 1; k < std::size_t(truth.size); ++k)
      planes.add(bound(k), abs(Ball(depths.inside[k]) - truth.inside[k]), with);
  }
  quadric.finish(1500);
  planes.finish(2000);
}

// Near an apex, a rim, a flat side, or anywhere.
TEST(SolidRayBounds, NormalsOfContacts) {
  const WorkingPrecision precision(4096);
  HostileDraw draw(212);
  Tally normals("ray at a solid: the normal, over 16 u");
  for (int i = 0; i < rounds(4000); ++i) {
    Ray ray = draw_ray(draw);
    if (const auto* cone = std::get_if<Cone<double>>(&ray.solid.shape); cone && draw.chance(0.7)) {
      // At the apex, less a little across it.
      const Mat3<double> turn = detail::rotation_matrix(ray.solid.orientation);
      const Vec3<double> apex = Vec3<double>(turn * Vec3<double>(0, 0, cone->half_height));
      const double off = draw.power(-50, -10);
      const Vec3<double> across(off * draw.plain().between(-1, 1), off * draw.plain().between(-1, 1), 0);
      ray.solid.position = ray.solid.displacement = Vec3<double>::Zero();
      ray.point.position = Vec3<double>(turn * Vec3<double>(0, 0, 16)) + across;
      ray.point.displacement = 2 * (apex + across - ray.point.position);
    }
    const CastResult<double> hit = cast(ray.solid, ray.point, {.t_max = kInfinity<double>});
    if (hit.outcome != Outcome::hit || !(hit.toi_lower > 0)) continue;
    const detail::exact::SolidContact contact =
        detail::exact::SolidRayBracket(ray.solid, ray.point).prove(hit.toi_lower);
    if (!contact.proved) continue;
    // Planes have normals without error.
    const TrueDepths before = true_depths(ray, Ball(contact.toi.lower));
    if (!before.inside[0].is_positive() &&
        (before.size == 1 || (before.inside[1].is_positive() && before.inside[2].is_positive()))) {
      const BallVec truth = true_normal(ray, contact.toi.lower), off = BallVec(contact.normal) - truth;
      normals.add(1, max(abs(off.x), max(abs(off.y), abs(off.z))) * two_to(49), [&] {
        std::ostringstream out;
        out << std::hexfloat << "  shape " << ray.solid.shape.index() << " lower " << contact.toi.lower
            << "\n";
        return out.str();
      });
    }
  }
  normals.finish(1000);
}

}  // namespace
}  // namespace graze::test
