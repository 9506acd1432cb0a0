#include "properties/generate/round_tie.hpp"

#include <cmath>

#include "corpus/families/draw.hpp"
#include "properties/generate/meeting.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;

namespace {

// A point of the surface, and the normal there, of any length.
struct Flank {
  Vec3<double> at, normal;
};
// On the line from the end below to that above, whose distances from the axis are these.
Flank flank_of(Random& random, double below, double above, double half_height) {
  // A unit vector without a cosine: the same on every machine.
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), length = std::sqrt(x * x + y * y);
  const Vec3<double> out = length > 0 ? Vec3<double>(x / length, y / length, 0) : Vec3<double>::UnitX();
  const double share = random.uniform(0.1, 0.9);
  Flank flank;
  flank.at = (below + share * (above - below)) * out;
  flank.at[2] = half_height * (2 * share - 1);
  flank.normal = 2 * half_height * out;
  flank.normal[2] = below - above;
  return flank;
}

}  // namespace

Case draw_round_tie(Random& random) {
  Case problem;
  problem.family = "round ties";
  const double radius = random.uniform(0.25, 2), half_height = random.uniform(0.25, 4);
  const bool is_cone = random.once_in(2);
  const Shape<double> part = is_cone ? Shape<double>(Cone<double>{radius, half_height})
                                     : Shape<double>(Cylinder<double>{radius, half_height});
  const Flank flank = flank_of(random, radius, is_cone ? 0 : radius, half_height);
  const Quaternion<double> inner = draw_orientation(random), outer = draw_orientation(random);
  const Vec3<double> inside = draw_vector(random, 4);
  problem.a.shape = posed<double>(part, inside, inner);
  problem.a.position = draw_vector(random, 8);
  problem.a.orientation = outer;
  const auto to_world = [&](const Vec3<double>& x) {
    return corpus::rotate(outer, corpus::rotate(inner, x));
  };
  const Vec3<double> n = to_world(flank.normal).normalized();
  const double ball = random.once_in(2) ? random.uniform(0.1, 1) : 0;
  if (ball > 0) problem.b.shape = Sphere<double>{ball};
  Vec3<double> v = draw_vector(random, 4);
  if (v.dot(n) > 0) v = -v;
  problem.b.displacement = v;
  const double t = random.uniform(0.25, 0.75);
  problem.b.position =
      problem.a.position + corpus::rotate(outer, inside) + to_world(flank.at) + ball * n - t * v;
  return problem;
}

}  // namespace graze::law
