// apexes: a round body on the tip of a pyramid, with the motion along their axis. Hardness: k, the line of motion passes
// the tip at 10^-k of a size of 4. From 17 on it passes through it.
//
// The pyramids are over regular polygons, single or double. The other body is a ball, an ellipsoid, a cylinder, a cone,
// a capsule or a small rounded box, upright, on its side, or turned so that a diagonal is on the axis. It hangs in the
// pyramid, is just out of the tip, or meets it later. C = A - B then has a curved apex on the line.
//
// This breaks a portal with a corner on the line: each step replaces one of the other two corners, and they orbit.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"

namespace graze::corpus {
namespace {

Hull<double> pyramid(Draw& draw, double height) {
  Random& random = draw.random;
  const double radius = draw.real(random.uniform(1, 4));
  std::vector<Vec3<double>> corners;
  const int doublings = random.integer(0, 2), first = random.integer(3, 5);
  for (const Point2& x : regular_polygon(first, doublings)) {
    corners.emplace_back(draw.real(radius * x[0]), draw.real(radius * x[1]), 0);
  }
  corners.emplace_back(0, 0, height);
  if (random.once_in(2)) corners.emplace_back(0, 0, -height);
  return Hull<double>(std::span<const Vec3<double>>(corners));
}

Shape<double> round_body(Draw& draw) {
  Random& random = draw.random;
  const double radius = draw.real(random.uniform(0.0625, 0.5)),
               half_height = draw.real(random.uniform(0.0625, 0.5));
  switch (random.below(7)) {
    case 0:
    case 1:
      return Sphere<double>{radius};
    case 2:
      return Ellipsoid<double>{Vec3<double>(radius, random.once_in(2) ? radius : 2 * radius, half_height)};
    case 3:
      return Cylinder<double>{radius, half_height};
    case 4:
      return Cone<double>{radius, half_height};
    case 5:
      return Capsule<double>{radius, half_height};
    default:
      return rounded<double>(Box<double>{Vec3<double>(radius, radius, half_height)}, half_height);
  }
}

void fill_apexes(Draw& draw, double hardness, Case& problem) {
  constexpr int kLastOffset = 16;
  Random& random = draw.random;
  const int k = static_cast<int>(hardness);
  const double off = k > kLastOffset ? 0 : draw.real(4 * power_of_ten(-k));
  const double height = draw.real(random.uniform(0.5, 4));
  problem.a.shape = pyramid(draw, height);
  problem.b.shape = round_body(draw);
  switch (random.below(4)) {
    case 0:
      problem.b.orientation = kLaidDown;
      break;
    case 1:
      problem.b.orientation = draw.cube_rotation();
      break;
    case 2:
      problem.b.orientation = draw.pose();
      break;
    default:
      break;
  }
  constexpr double kHeights[] = {0, 0.5, 0.9, 1, 1.25, 3};
  Vec3<double> meeting = Vec3<double>::Zero();
  for (const int i : {1, 0}) meeting[i] = off * random.integer(-1, 1);
  meeting[2] = kHeights[random.below(std::size(kHeights))] * height;
  const Vec3<double> v(0, 0, random.once_in(2) ? 32 : -32);
  // The body starts there, comes to it at a half, has left it, or passes by.
  double t0 = 0.5;
  switch (random.below(8)) {
    case 0:
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
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  turn_either_way(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kApexesLevels[] = {1, 2, 4, 6, 8, 10, 12, 14, 16, 17};  // 17: through the tip

}  // namespace

const Family family::apexes{
    .name = "apexes",
    .sentence = "A round body on the tip of a pyramid moves along the line through it.",
    .hardness_meaning = "k: the line passes the tip at 10^-k of a size of 4; 17 is through it",
    .levels = kApexesLevels,
    .fill = fill_apexes,
    .picture = {2, 1},
};

}  // namespace graze::corpus
