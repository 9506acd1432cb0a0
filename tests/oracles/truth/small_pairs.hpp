// Small polytope pairs of every dimension, from hulls or from combinators: integer coordinates, so that
// touching, ties and degenerate configurations are common, with integer quaternions for the rotated half.
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
    if (dimension == 3 && random.once_in(2)) {
      const double z = random.integer(1, 3), y = random.integer(1, 3), x = random.integer(1, 3);
      return Box<double>{Vec(x, y, z)};
    }
    return hull(dimension, random.integer(dimension + 1, 6), 3);
  }

  // One draw a statement, so that every compiler draws the same.
  // Points, segments, triangles, tetrahedra and, with `levels` of combinators above them, what these make of
  // them. Few vertices, no radius.
  Shape<double> composed(int levels) {
    if (levels > 0) {
      switch (random.integer(0, 5)) {
        case 0: {
          const Quaternion<double> turn = planar_ ? Quaternion<double>() : quaternion();
          const Vec at = point(2);
          return posed<double>(composed(levels - 1), at, turn);
        }
        case 1:
          return rounded<double>(composed(levels - 1), 0);
        case 2: {
          const Shape<double> second = composed(levels - 1);
          return hull_of<double>(composed(levels - 1), second);
        }
        case 3: {
          const Vec by = point(2);
          return swept<double>(leaf(), by);
        }
        default: {
          const Shape<double> second = composed(levels - 1);
          return sum<double>(leaf(), second);
        }
      }
    }
    return leaf();
  }

  corpus::Case pair() {
    // A quarter of the pairs are flat together: points and segments meet too rarely by chance.
    const int most = random.once_in(4) ? random.integer(0, 1) : 3;
    corpus::Case problem;
    problem.a.shape = shape(random.integer(0, most));
    problem.b.shape = shape(random.integer(0, most));
    set_in_motion(problem, most);
    return problem;
  }

  // A quarter of them lie in the plane z = 0, moved within it as a rule.
  corpus::Case composed_pair() {
    planar_ = random.once_in(4);
    corpus::Case problem;
    problem.a.shape = composed(random.integer(0, 2));
    problem.b.shape = composed(random.integer(0, 1));
    set_in_motion(problem, 3);
    if (random.once_in(3)) problem.b.position = problem.a.position + vector(1);
    if (planar_) {
      problem.a.orientation = problem.b.orientation = {};
      problem.a.position[2] = problem.b.position[2] = 0;
      if (!random.once_in(4)) problem.a.displacement[2] = problem.b.displacement[2];
    }
    planar_ = false;
    return problem;
  }

 private:
  bool planar_ = false;

  Vec point(int reach) {
    Vec p = vector(reach);
    if (planar_) p[2] = 0;
    return p;
  }

  Shape<double> leaf() {
    switch (random.integer(0, 4)) {
      case 0:
        return Point<double>{};
      case 1:
      case 2:
        return Segment<double>{point(2), point(2)};
      case 3:
        return Triangle<double>{point(2), point(2), point(2)};
      default:
        return Hull<double>{point(2), point(2), point(2), point(2)};
    }
  }

  void set_in_motion(corpus::Case& problem, int most) {
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
  }
};

}  // namespace graze::oracle
