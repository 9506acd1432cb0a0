#include "corpus/families/standing.hpp"

#include <algorithm>
#include <cmath>

namespace graze::corpus {
namespace {

// On its side: a generator of the cone of radius 15 w and height 20 w lies in z = 0. (1, 0, 2, 0) turns about
// y by an angle of cosine -3/5 and sine 4/5, which brings the apex and the foot of that generator to -6 w.
Topped cone_on_its_side(Draw& draw, double reach) {
  const double w = draw.positive_on_grid(std::max(reach / 15, draw.grid_step()));
  return {Cone<double>{15 * w, 10 * w}, {1, 0, 2, 0}, Vec3<double>(0, 0, 6 * w)};
}

}  // namespace

Topped standing_smooth(Draw& draw, double reach) {
  Random& random = draw.random;
  const double radius = draw.positive_on_grid(reach), half_height = draw.positive_on_grid(reach);
  const auto at = [](double z) { return Vec3<double>(0, 0, z); };
  switch (random.below(10)) {
    case 0:
    case 1:
      return {Sphere<double>{radius}, {}, at(radius)};
    case 2:
      return {Capsule<double>{radius, half_height}, {}, at(radius + half_height)};
    case 3:
      return {Capsule<double>{radius, half_height}, kLaidDown, at(radius)};
    case 4:
      return {Cylinder<double>{radius, half_height}, {}, at(half_height)};
    case 5:
      return {Cylinder<double>{radius, half_height}, kLaidDown, at(radius)};
    case 6:
      return {Cone<double>{radius, half_height}, {}, at(half_height)};
    case 7:
      return {Cone<double>{radius, half_height}, kUpsideDown, at(half_height)};
    case 8:
      return cone_on_its_side(draw, reach);
    default: {
      const double other = draw.positive_on_grid(reach);
      return {Ellipsoid<double>{Vec3<double>(radius, other, half_height)}, {}, at(half_height)};
    }
  }
}

Topped standing(Draw& draw, double reach) {
  if (!draw.random.once_in(3)) return standing_smooth(draw, reach);
  Topped body = mirrored(topped_any(draw, reach));
  if (draw.random.once_in(2)) return body;
  const double radius = draw.positive_on_grid(reach);
  body.shape = rounded<double>(std::move(body.shape), radius);
  body.position[2] += radius;
  return body;
}

Shape<double> stretched(const Shape<double>& shape, double factor) {
  const auto times = [&](const Vec3<double>& x) { return Vec3<double>(factor * x); };
  return std::visit(
      [&]<class T>(const T& one) -> Shape<double> {
        if constexpr (std::same_as<T, Segment<double>>) {
          return Segment<double>{times(one.a), times(one.b)};
        } else if constexpr (std::same_as<T, Triangle<double>>) {
          return Triangle<double>{times(one.a), times(one.b), times(one.c)};
        } else if constexpr (std::same_as<T, Sphere<double>>) {
          return Sphere<double>{factor * one.radius};
        } else if constexpr (std::same_as<T, Box<double>>) {
          return Box<double>{times(one.half_extents)};
        } else if constexpr (std::same_as<T, Ellipsoid<double>>) {
          return Ellipsoid<double>{times(one.radii)};
        } else if constexpr (std::same_as<T, Capsule<double>> || std::same_as<T, Cylinder<double>> ||
                             std::same_as<T, Cone<double>>) {
          return T{factor * one.radius, factor * one.half_height};
        } else if constexpr (std::same_as<T, Hull<double>>) {
          std::vector<Vec3<double>> list;
          for (const Vec3<double>& x : one.vertices()) list.push_back(times(x));
          return Hull<double>(std::span<const Vec3<double>>(list));
        } else if constexpr (std::same_as<T, Rounded<double>>) {
          return rounded<double>(stretched(one.shape->shape, factor), factor * one.radius);
        } else if constexpr (std::same_as<T, Posed<double>>) {
          return posed<double>(stretched(one.shape->shape, factor), times(one.position), one.orientation);
        } else {
          return one;  // a point (the other combinators are not drawn here)
        }
      },
      shape);
}

void turn_stretched(Draw& draw, Case& problem) {
  const Quaternion<double> q = draw.turned_pose();
  const double n = ((q.w * q.w + q.x * q.x) + q.y * q.y) + q.z * q.z;
  // rotate() divides a sum of integers times n x by n: exactly, where that sum is.
  const auto turned = [&](const Vec3<double>& x) { return rotate(q, Vec3<double>(n * x)); };
  for (Body<double>* body : {&problem.a, &problem.b}) {
    body->shape = stretched(body->shape, n);
    body->orientation = multiply(q, body->orientation);
    body->position = turned(body->position);
    body->displacement = turned(body->displacement);
  }
}

double moved_by_units(const Draw& draw, double x, int units) {
  if (units == 0 || x == 0) return x;
  const int digits = draw.coordinates == Coordinates::floats ? 23 : 52;
  return x + std::scalbn(static_cast<double>(units), std::ilogb(x) - digits);
}

std::vector<Point2> regular_polygon(int first, int doublings) {
  // Cosine and sine of the step.
  double c = 0, s = 1;
  if (first == 3) {
    c = -0.5;
    s = std::sqrt(0.75);
  } else if (first == 5) {
    c = (std::sqrt(5.0) - 1) / 4;
    s = std::sqrt(1 - c * c);
  }
  std::vector<Point2> corners = {{1, 0}};
  const auto turned = [&](const Point2& x) { return Point2{x[0] * c - x[1] * s, x[0] * s + x[1] * c}; };
  for (int i = 1; i < first; ++i) corners.push_back(turned(corners.back()));
  // A corner between each two, half a step on: no error grows beyond a few roundings a doubling.
  for (int d = 0; d < doublings; ++d) {
    const double half = std::sqrt((1 + c) / 2);
    s = s / (2 * half);
    c = half;
    std::vector<Point2> twice;
    for (const Point2& x : corners) {
      twice.push_back(x);
      twice.push_back(turned(x));
    }
    corners = std::move(twice);
  }
  return corners;
}

std::vector<Vec3<double>> sphere_points(int count) {
  // Cosine and sine of the golden angle, pi (3 - sqrt 5).
  constexpr double kCos = -0.7373688780783197, kSin = 0.6754902942615238;
  std::vector<Vec3<double>> points;
  double x = 1, y = 0;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    points.emplace_back(r * x, r * y, z);
    const double next_x = x * kCos - y * kSin, next_y = x * kSin + y * kCos;
    const double length = std::sqrt(next_x * next_x + next_y * next_y);
    x = next_x / length;
    y = next_y / length;
  }
  return points;
}

}  // namespace graze::corpus
