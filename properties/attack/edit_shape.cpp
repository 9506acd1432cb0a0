// Shapes exchanged for others that a checker might confuse with them: the same set written otherwise, or
// another set in the same bounding box.
#include <cmath>
#include <graze/hull.hpp>
#include <vector>

#include "corpus/support_value.hpp"
#include "properties/attack/mutant.hpp"

namespace graze::attack {

using corpus::Random;

namespace {

// A ball of that radius, as some shape.
Shape<double> ball(double radius, Random& random) {
  switch (random.below(7)) {
    case 0:
      return Sphere<double>{radius};
    case 1:
    case 2:
      return Ellipsoid<double>{{radius, radius, radius}};
    case 3:
      return Capsule<double>{radius, 0};
    case 4:
      return rounded<double>(Point<double>{}, radius);
    case 5:
      return rounded<double>(Sphere<double>{radius / 2}, radius / 2);
    default:
      return sum<double>(Sphere<double>{radius / 2}, Ellipsoid<double>{Vec3<double>::Constant(radius / 2)});
  }
}

Hull<double> corners(const Vec3<double>& h) {
  std::vector<Vec3<double>> vertices;
  vertices.reserve(8);
  for (int k = 0; k < 8; ++k)
    vertices.push_back(
        {(k & 1) != 0 ? h[0] : -h[0], (k & 2) != 0 ? h[1] : -h[1], (k & 4) != 0 ? h[2] : -h[2]});
  return with_adjacency<double>(vertices);
}

// In the box of these half extents.
Shape<double> boxed(const Vec3<double>& h, Random& random) {
  const double round = std::min(h[0], h[1]), least = std::min(round, h[2]);
  switch (random.below(8)) {
    case 0:
      return Box<double>{h};
    case 1:
      return Ellipsoid<double>{h};
    case 2:
      return Cylinder<double>{round, h[2]};
    case 3:
      return Cone<double>{round, h[2]};
    case 4:
      return corners(h);
    case 5:
      return rounded<double>(Box<double>{h - Vec3<double>::Constant(least / 2)}, least / 2);
    case 6:
      return Capsule<double>{least, h[2] - least};
    default:
      return ball(least, random);
  }
}

}  // namespace

Shape<double> written_otherwise(const Shape<double>& shape, Random& random) {
  if (random.once_in(12)) return posed<double>(shape, Vec3<double>::Zero(), {});
  if (random.once_in(12)) return rounded<double>(shape, 0);
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) return ball(sphere->radius, random);
  if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) {
    const double r = ellipsoid->radii[0];
    const bool is_ball = ellipsoid->radii == Vec3<double>::Constant(r);
    return is_ball && !random.once_in(4) ? ball(r, random) : boxed(ellipsoid->radii, random);
  }
  if (std::holds_alternative<Point<double>>(shape)) {
    if (random.once_in(2)) return ball(std::scalbn(1.0, -random.integer(0, 40)), random);
    return random.once_in(2) ? Shape<double>(Segment<double>{}) : ball(0, random);
  }
  if (const auto* segment = std::get_if<Segment<double>>(&shape)) {
    if (random.once_in(2)) return Segment<double>{segment->b, segment->a};
    return hull_of<double>(translated<double>(Point<double>{}, segment->a),
                           translated<double>(Point<double>{}, segment->b));
  }
  if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) {
    if (capsule->half_height == 0) return ball(capsule->radius, random);
    const Vec3<double> end = capsule->half_height * Vec3<double>::UnitZ();
    if (random.once_in(2)) return rounded<double>(Segment<double>{-end, end}, capsule->radius);
    return Cylinder<double>{capsule->radius, capsule->half_height + capsule->radius};
  }
  // Everything else, in the box about its own origin.
  Vec3<double> h;
  for (int i = 0; i < 3; ++i) {
    h[i] = std::max(corpus::support_value(shape, Vec3<double>::Unit(i)),
                    corpus::support_value(shape, -Vec3<double>::Unit(i)));
  }
  if (!h.allFinite() || h.minCoeff() < 0) return shape;
  return boxed(h, random);
}

}  // namespace graze::attack
