// Moving bodies of any shape for tests of bounds: leaves of every kind, with extents of 0 and equal radii
// among them, alone, posed, rounded, summed, in a hull, and these in each other.
#pragma once

#include <vector>

#include "tests/oracles/truth/curved_pairs.hpp"

namespace graze::oracle {

struct MovingBody {
  Body<double> body;
  corpus::Spin spin;
};

class AnyBody {
 public:
  explicit AnyBody(std::uint64_t seed) : make(seed) {}

  CurvedPairs make;

  Shape<double> leaf() {
    make.lattice = make.random.once_in(3);
    const double r = extent(), h = extent();
    switch (make.random.integer(0, 5)) {
      case 0:
        return Ellipsoid<double>{{r, r, r}};
      case 1:
        return Ellipsoid<double>{{r, h, r}};
      case 2:
        return Capsule<double>{r, h};
      case 3:
        return Cylinder<double>{r, h};
      case 4:
        return Cone<double>{r, h};
      default:
        return make.shape(static_cast<Kind>(make.random.integer(0, kKinds - 1)));
    }
  }

  Shape<double> shape(int depth) {
    if (depth == 0 || make.random.once_in(3)) return leaf();
    switch (make.random.integer(0, 3)) {
      case 0:
        return posed<double>(shape(depth - 1), make.vector(3), make.quaternion());
      case 1:
        return rounded<double>(shape(depth - 1), extent());
      case 2:
        return sum<double>(shape(depth - 1), shape(depth - 1));
      default:
        return hull_of<double>(shape(depth - 1), shape(depth - 1));
    }
  }

  MovingBody body(int depth) {
    MovingBody moving;
    moving.body.shape = shape(depth);
    make.lattice = false;
    moving.body.position = make.vector(3);
    moving.body.orientation = make.quaternion();
    moving.body.displacement = make.vector(2);
    moving.spin = {make.vector(5), make.vector(make.random.once_in(4) ? 1000 : 2)};
    return moving;
  }

 private:
  double extent() { return make.random.once_in(4) ? 0 : make.extent(); }
};

}  // namespace graze::oracle
