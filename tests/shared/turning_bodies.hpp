// Random rotating bodies of every shape, for the tests of rotating casts.
#pragma once

#include <graze/rotating_body.hpp>

#include "tests/shared/generate.hpp"

namespace graze::test {

inline constexpr int kTurningShapes = 12;

// Kinds 0 to 8 are solid, 9 to 11 flat.
inline Shape<double> any_shape(Draw& draw, int kind) {
  const auto size = [&] { return draw.between(0.1, 1); };
  switch (kind) {
    case 0:
      return Sphere<double>{size()};
    case 1:
      return Box<double>{{size(), size(), size()}};
    case 2:
      return Capsule<double>{size(), size()};
    case 3:
      return Cylinder<double>{size(), size()};
    case 4:
      return Cone<double>{size(), size()};
    case 5:
      return Ellipsoid<double>{{size(), size(), size()}};
    case 6: {
      std::vector<Vec3<double>> points;
      for (int i = 0; i < 12; ++i) points.push_back(draw.vector<double>(1));
      return Hull<double>(points);
    }
    case 7:
      return rounded<double>(Box<double>{{size(), size(), size()}}, size() / 4);
    case 8:
      return hull_of<double>(Sphere<double>{size()},
                             translated<double>(Sphere<double>{size()}, draw.vector<double>(1)));
    case 9:
      return Segment<double>{draw.vector<double>(1), draw.vector<double>(1)};
    case 10:
      return Triangle<double>{draw.vector<double>(1), draw.vector<double>(1), draw.vector<double>(1)};
    default:
      return Point<double>{};
  }
}

inline RotatingBody<double> turning_body(Draw& draw) {
  RotatingBody<double> out;
  out.body.shape = any_shape(draw, static_cast<int>(draw.between(0, 9)));
  out.body.position = draw.vector<double>(3);
  const Vec3<double> q = draw.vector<double>(1);
  out.body.orientation = {draw.between(-1, 1), q[0], q[1], q[2]};
  out.body.displacement = draw.vector<double>(2);
  out.rotation = draw.vector<double>(4);
  out.pivot = draw.vector<double>(0.5);
  return out;
}

}  // namespace graze::test
