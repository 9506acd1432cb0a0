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

// -g and the ways to the planes, in the axes of the solid about its centre, times W = |q|^2 and W^2.
struct TrueDepths {
  Ball inside[3];
  int size = 1;
};
TrueDepths true_depths(const Ray& ray) {
  const Quaternion<double> q = ray.solid.orientation.is_identity()
                                   ? Quaternion<double>{}
                                   : detail::exact::scaled_to_one(ray.solid.orientation);
  const Ball w(q.w), weight = w * w + Ball(q.x) * Ball(q.x) + Ball(q.y) * Ball(q.y) + Ball(q.z) * Ball(q.z);
  const BallVec u(-Vec3<double>(q.x, q.y, q.z));
  const Ball t(ray.t);
  const BallVec way = BallVec(ray.point.displacement) - BallVec(ray.solid.displacement);
  const BallVec d = (BallVec(ray.point.position) - BallVec(ray.solid.position)) + t * way;
  // conj(q) d q = (w^2 - u.u) d + 2 (u.d) u + 2 w u x d, with the reversed u.
  const BallVec x = ((w * w - dot(u, u)) * d + (Ball(2) * dot(u, d)) * u) + (Ball(2) * w) * cross(u, d);
  TrueDepths out;
  if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&ray.solid.shape)) {
    const Ball a(ellipsoid->radii[0]), b(ellipsoid->radii[1]), c(ellipsoid->radii[2]);
    const Ball p = x.x * b * c, r = x.y * a * c, s = x.z * a * b, all = a * b * c * weight;
    out.inside[0] = all * all - (p * p + r * r + s * s);
    return out;
  }
  out.size = 3;
  Ball half;
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&ray.solid.shape)) {
    const Ball r = Ball(cylinder->radius) * weight;
    half = Ball(cylinder->half_height) * weight;
    out.inside[0] = r * r - (x.x * x.x + x.y * x.y);
  } else {
    const auto& cone = std::get<Cone<double>>(ray.solid.shape);
    half = Ball(cone.half_height) * weight;
    const Ball below = Ball(cone.radius) * (half - x.z), two = Ball(2) * Ball(cone.half_height);
    out.inside[0] = below * below - (two * two) * (x.x * x.x + x.y * x.y);
  }
  out.inside[1] = x.z + half;
  out.inside[2] = half - x.z;
  return out;
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
    const TrueDepths truth = true_depths(ray);
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

}  // namespace
}  // namespace graze::test
