// coaxial: round bodies about one axis, such as a peg in a hole, nested cylinders, a ball in a cone, or a
// point on an axis. Hardness: k, the axes are 10^-k of a size of 4 apart. From 17 on they coincide.
//
// The shapes are cylinders, cones, capsules, ellipsoids of revolution, balls, and a segment or a point on the
// axis. The second shape is about the same axis, upside down, or about an axis across it. C = A - B is then a
// body of revolution too, and the origin is on its axis: a whole circle of its points is equally near. The
// bodies are concentric, or one stands higher up the axis, or moves along it, in and out again, or across.
//
// This breaks a polytope that grows by one face at a time toward a circle of equally near points, however
// large its storage is. It also breaks a normal that may be any of a circle.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"

namespace graze::corpus {
namespace {

// A shape about z with extents up to `reach`.
Shape<double> about_z(Draw& draw, double reach) {
  const double radius = draw.positive_on_grid(reach), half_height = draw.positive_on_grid(reach);
  switch (draw.random.below(9)) {
    case 0:
    case 1:
    case 2:
      return Cylinder<double>{radius, half_height};
    case 3:
      return Cone<double>{radius, half_height};
    case 4:
      return Capsule<double>{radius, half_height};
    case 5:
      return Ellipsoid<double>{Vec3<double>(radius, radius, half_height)};
    case 6:
      return Sphere<double>{radius};
    case 7:
      return Segment<double>{Vec3<double>(0, 0, -half_height), Vec3<double>(0, 0, half_height)};
    default:
      return Point<double>{};
  }
}

void fill_coaxial(Draw& draw, double hardness, Case& problem) {
  constexpr int kLastOffset = 16;
  Random& random = draw.random;
  const int k = static_cast<int>(hardness);
  const double off = k > kLastOffset ? 0 : draw.real(4 * power_of_ten(-k));
  do {
    problem.a.shape = about_z(draw, 4);
  } while (std::holds_alternative<Point<double>>(problem.a.shape) ||
           std::holds_alternative<Segment<double>>(problem.a.shape));
  switch (random.below(6)) {
    case 0:
      problem.b.shape = problem.a.shape;
      break;
    case 1:
      problem.b.shape = stretched(problem.a.shape, std::scalbn(1.0, -random.integer(1, 6)));
      break;
    default:
      problem.b.shape = about_z(draw, random.once_in(2) ? 1 : 4);
      break;
  }
  // The other way up, or its axis across.
  if (random.once_in(4)) problem.b.orientation = random.once_in(2) ? kUpsideDown : kLaidDown;

  Vec3<double> meeting = Vec3<double>::Zero();
  for (int i = 0; i < 2; ++i) meeting[i] = 0 + off * random.integer(-1, 1);
  if (random.once_in(2)) meeting[2] = draw.on_grid(2);
  Vec3<double> v(0, 0, random.once_in(2) ? 32 : -32);
  if (random.once_in(4)) v = Vec3<double>(random.once_in(2) ? 32 : -32, 0, 0);
  // The body starts there, comes to it at a half, has left it, or never comes there.
  double t0 = 0.5;
  switch (random.below(8)) {
    case 0:
      v = Vec3<double>::Zero();
      break;
    case 1:
      t0 = 0;
      break;
    case 2:
      t0 = -0.5;
      break;
    case 3:
      meeting[1] += 16;
      break;
    default:
      break;
  }
  for (int i = 0; i < 3; ++i) problem.b.position[i] = draw.real(0 + (meeting[i] - t0 * v[i]));
  set_motion(draw, problem, v);
  if (random.once_in(4)) problem.start_policy = StartPolicy::pass_over;
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  turn_either_way(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kCoaxialLevels[] = {1, 2, 4, 6, 8, 10, 12, 14, 16, 17};  // 17: one axis

}  // namespace

const Family family::coaxial{
    .name = "coaxial",
    .sentence = "Round bodies about one axis: a peg in a hole, nested cylinders, a point on an axis.",
    .hardness_meaning = "k: the axes are 10^-k of a size of 4 apart; 17 is one axis",
    .levels = kCoaxialLevels,
    .fill = fill_coaxial,
    .picture = {1, 2},
};

}  // namespace graze::corpus
