#include "properties/generate/near_ball.hpp"

#include <cmath>
#include <vector>

#include "corpus/families/draw.hpp"
#include "properties/generate/meeting.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;

namespace {

// Makes a hull with three corners within 2^-23 of each other, and returns the first.
Vec3<double> take_near_corners(Random& random, Shape<double>& shape) {
  Vec3<double> corner = draw_vector(random, 1);
  std::vector<Vec3<double>> points = {corner, corner + draw_vector(random, 0x1p-23),
                                      corner + draw_vector(random, 0x1p-23)};
  const int others = random.integer(1, 5);
  for (int i = 0; i < others; ++i)
    points.push_back(-random.uniform(0.25, 1) * corner + draw_vector(random, 0.25));
  shape = Hull<double>(points);
  return corner;
}

// Makes a triangle or a flat box, and returns a point of its inside.
Vec3<double> take_flat(Random& random, Shape<double>& shape) {
  if (random.once_in(2)) {
    const Vec3<double> a = draw_vector(random, 4), b = draw_vector(random, 4), c = draw_vector(random, 4);
    shape = Triangle<double>{a, b, c};
    return 0.25 * a + 0.25 * b + 0.5 * c;
  }
  Vec3<double> half(random.uniform(0.5, 4), random.uniform(0.5, 4), random.uniform(0.5, 4));
  const int flat = random.integer(0, 2);
  half[flat] = 0;
  shape = Box<double>{half};
  return random.uniform(-0.5, 0.5) * half;
}

}  // namespace

Case draw_near_ball(Random& random) {
  Case problem;
  problem.family = "balls on near ties";
  Vec3<double> target;
  double radius, beside = 0;
  if (random.once_in(2)) {
    target = take_near_corners(random, problem.a.shape);
    radius = random.uniform(0.05, 0.5);
    beside = radius / 2;
  } else {
    target = take_flat(random, problem.a.shape);
    radius = std::ldexp(1.0, -random.integer(44, 60));
  }
  if (random.once_in(2)) problem.a.orientation = draw_orientation(random);
  problem.a.position = draw_vector(random, 2);
  problem.b.shape = Sphere<double>{radius};
  problem.b.displacement = draw_vector(random, 4);
  problem.b.position = problem.a.position + corpus::rotate(problem.a.orientation, target) +
                       draw_vector(random, beside) - problem.b.displacement / 2;
  return problem;
}

}  // namespace graze::law
