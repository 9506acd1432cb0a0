// Small polytope pairs of every dimension: integer coordinates, so that touching, ties and degenerate
// configurations are common, with integer quaternions for the rotated half.
#pragma once

#include <vector>

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::oracle {

using Vec = Vec3<double>;

class SmallPairs {
 public:
  explicit SmallPairs(std::uint64_t seed) : random(seed) {}

  corpus::Random random;

  double small(int reach) { return random.integer(-reach, reach); }
  Vec vector(int reach) { return {small(reach), small(reach), small(reach)}; }

  // A hull of `count` points on a lattice of the given dimension about the origin: 0 a point, 1 a line, 2 a
  // plane.
  Hull<double> hull(int dimension, int count, int reach) {
    const Vec first = vector(2), second = vector(2);
    std::vector<Vec> points;
    for (int i = 0; i < count; ++i) {
      if (dimension == 0) points.push_back(Vec::Zero());
      if (dimension == 1) points.push_back(small(reach) * first);
      if (dimension == 2) points.push_back(small(reach) * first + small(reach) * second);
      if (dimension == 3) points.push_back(vector(reach));
    }
    return Hull<double>(points);
  }

  Quaternion<double> quaternion() {
    Quaternion<double> q{small(3), small(3), small(3), small(3)};
    if (q.w == 0 && q.is_identity()) q.w = 1;
    return q;
  }

  Shape<double> shape(int dimension) {
    if (dimension == 0 && random.once_in(2)) return Point<double>{};
    if (dimension == 3 && random.once_in(2))
      return Box<double>{Vec(random.integer(1, 3), random.integer(1, 3), random.integer(1, 3))};
    return hull(dimension, random.integer(dimension + 1, 6), 3);
  }

  corpus::Case pair() {
    corpus::Case problem;
    // A quarter of the pairs are flat together: points and segments meet too rarely by chance.
    const int most = random.once_in(4) ? random.integer(0, 1) : 3;
    problem.a.shape = shape(random.integer(0, most));
    problem.b.shape = shape(random.integer(0, most));
    problem.a.position = vector(2);
    problem.b.position =
        most < 3 && random.once_in(3) ? problem.a.position : vector(random.once_in(2) ? 3 : 8);
    if (random.once_in(2)) {
      problem.a.orientation = quaternion();
      problem.b.orientation = quaternion();
    }
    problem.a.displacement = vector(2);
    // Most paths lead near A's centre at t = 1/2, and for thin pairs often through it.
    const Vec towards = 2 * (problem.a.position - problem.b.position);
    problem.b.displacement = random.once_in(4) ? vector(8) : Vec(towards + vector(1));
    if (most < 3 && random.once_in(2)) problem.b.displacement = problem.a.displacement + towards;
    if (random.once_in(16)) problem.b.displacement = problem.a.displacement;
    if (random.once_in(4)) problem.t_max = kInfinity<double>;
    if (random.once_in(16)) problem.t_max = 0.25;
    return problem;
  }
};

}  // namespace graze::oracle
