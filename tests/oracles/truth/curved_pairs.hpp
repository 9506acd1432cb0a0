// Pairs of any shapes: half of them of random doubles, half of small integers, where touching, ties and
// degenerate configurations are common.
#pragma once

#include <vector>

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::oracle {

enum class Kind { point, segment, triangle, sphere, capsule, box, ellipsoid, cylinder, cone, hull };
inline constexpr int kKinds = 10;

class CurvedPairs {
 public:
  explicit CurvedPairs(std::uint64_t seed) : random(seed) {}

  corpus::Random random;
  bool lattice = false;

  double number(double reach) {
    return lattice ? random.integer(-static_cast<int>(reach), static_cast<int>(reach))
                   : random.uniform(-reach, reach);
  }
  Vec3<double> vector(double reach) { return {number(reach), number(reach), number(reach)}; }
  double extent() {
    return lattice ? random.integer(random.once_in(8) ? 0 : 1, 3) : random.uniform(0.1, 1.5);
  }
  double positive() { return lattice ? random.integer(1, 3) : random.uniform(0.1, 1.5); }

  Shape<double> shape(Kind kind) {
    switch (kind) {
      case Kind::point:
        return Point<double>{};
      case Kind::segment:
        return Segment<double>{vector(2), vector(2)};
      case Kind::triangle:
        return Triangle<double>{vector(2), vector(2), vector(2)};
      case Kind::sphere:
        return Sphere<double>{extent()};
      case Kind::capsule:
        return Capsule<double>{extent(), extent()};
      case Kind::box:
        return Box<double>{{extent(), extent(), extent()}};
      case Kind::ellipsoid:
        return Ellipsoid<double>{{positive(), positive(), positive()}};
      case Kind::cylinder:
        return Cylinder<double>{extent(), extent()};
      case Kind::cone:
        return Cone<double>{extent(), extent()};
      case Kind::hull:
        break;
    }
    std::vector<Vec3<double>> points;
    for (int i = random.integer(1, 10); i >= 0; --i) points.push_back(vector(2));
    return Hull<double>(points);
  }

  Quaternion<double> quaternion() {
    Quaternion<double> q{number(3), number(3), number(3), number(3)};
    if (q.w == 0 && q.is_identity()) q.w = 1;
    return q;
  }

  corpus::Case pair(Kind a, Kind b) {
    lattice = random.once_in(2);
    corpus::Case problem;
    problem.a.shape = shape(a);
    problem.b.shape = shape(b);
    if (!random.once_in(3)) {
      problem.a.orientation = quaternion();
      problem.b.orientation = quaternion();
    }
    problem.a.position = vector(2);
    problem.b.position = vector(random.once_in(8) ? 3 : 7);
    problem.a.displacement = vector(2);
    // Most paths lead near A's centre at t = 1/2.
    const Vec3<double> towards = 2 * (problem.a.position - problem.b.position);
    problem.b.displacement =
        random.once_in(6) ? vector(8) : Vec3<double>(problem.a.displacement + towards + vector(2));
    if (random.once_in(8)) problem.t_max = kInfinity<double>;
    if (random.once_in(16)) problem.t_max = 0.25;
    if (random.once_in(16)) problem.b.displacement = problem.a.displacement;
    return problem;
  }
};

}  // namespace graze::oracle
