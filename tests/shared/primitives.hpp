// Random primitives of sizes near 1, for tests and benchmarks.
#pragma once

#include <graze/shape.hpp>

#include "tests/shared/generate.hpp"

namespace graze::test {

inline constexpr int kPrimitives = 6, kBoxPrimitive = 2;

// Sphere, capsule, box, ellipsoid, cylinder, cone.
inline Shape<double> primitive(int kind, Draw& draw) {
  const auto size = [&] { return draw.between(0.3, 1); };
  switch (kind) {
    case 0:
      return Sphere<double>{size()};
    case 1:
      return Capsule<double>{draw.between(0.2, 0.6), size()};
    case kBoxPrimitive:
      return Box<double>{{size(), size(), size()}};
    case 3:
      return Ellipsoid<double>{{size(), size(), size()}};
    case 4:
      return Cylinder<double>{size(), size()};
    default:
      return Cone<double>{size(), size()};
  }
}

}  // namespace graze::test
