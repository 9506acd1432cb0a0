// wheels: a wheel spins fast within a rounding of the floor. Hardness: k, it turns by about 2^k radians a unit
// of time.
//
// A prism over a regular polygon, whose corners come by at one height, one after the other, each to the
// rounding of its coordinates. Or a cylinder, about an axis that leaves its own by 2^-j, so that its turn is
// seen. The height above the floor is 0, a few units in the last place, 10^-13 to 10^-7, or once in six
// large, with either sign. The wheel spins where it is, rolls, or slides.
//
// Difficulty: a bound of the motion from the speed of its points is that speed, and the gap is nearly zero,
// so a march takes as many steps as there are.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

constexpr int kMostDoublings = 4;  // 48, 64 or 80 corners

double height_above(Draw& draw) {
  Random& random = draw.random;
  const double unit = draw.coordinates == Coordinates::floats ? 0x1p-23 : 0x1p-52;
  double height = 0;
  switch (random.below(6)) {
    case 0:
      break;
    case 1:
    case 2:
      height = unit * random.integer(1, 16);
      break;
    case 3:
    case 4:
      height = random.integer(1, 9);
      height *= power_of_ten(-random.integer(7, 13));
      break;
    default:
      return draw.real(random.uniform(0.125, 1));
  }
  return draw.real(random.once_in(3) ? 0 - height : height);
}

void fill_wheels(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double radius = draw.positive_on_grid(1), half_width = draw.positive_on_grid(0.5 + draw.grid_step());
  const bool round = random.once_in(4);
  if (round) {
    problem.b.shape = Cylinder<double>{radius, half_width};
  } else {
    std::vector<Vec3<double>> corners;
    const int first = random.integer(3, 5);
    for (const Point2& x : regular_polygon(first, random.integer(1, kMostDoublings))) {
      for (const double z : {-half_width, half_width})
        corners.emplace_back(draw.real(radius * x[0]), draw.real(radius * x[1]), z);
    }
    problem.b.shape = Hull<double>(std::span<const Vec3<double>>(corners));
  }
  // A corner below, or a side.
  problem.b.orientation = random.once_in(4) ? kLaidDown : multiply(kLaidDown, draw.pose_about_z());
  const double thickness = draw.positive_on_grid(1);
  problem.a.shape = Box<double>{Vec3<double>(32, 32, thickness)};
  // The floor takes the radius if coordinates are floats. B's own height is the gap alone.
  problem.a.position = Vec3<double>(0, 0, -(thickness + radius));
  for (int i = 0; i < 2; ++i) problem.b.position[i] = draw.on_grid(4);
  problem.b.position[2] = height_above(draw);

  double speed = draw.real(power_of_two(static_cast<int>(hardness)) * random.uniform(0.5, 1));
  if (random.once_in(2)) speed = -speed;
  problem.spin_b.rotation = Vec3<double>(0, speed, 0);
  if (round || random.once_in(8)) {
    const double off = draw.real(speed * power_of_two(-random.integer(8, 40)));
    problem.spin_b.rotation[random.once_in(2) ? 0 : 2] = off;
  }
  if (random.once_in(3)) problem.spin_b.pivot = Vec3<double>(0, 0, draw.on_grid(2));
  // The floor turns about its normal.
  if (random.once_in(3)) problem.spin_a.rotation = Vec3<double>(0, 0, draw.real(random.uniform(-1, 1)));
  Vec3<double> v = Vec3<double>::Zero();
  switch (random.below(4)) {
    case 0:
      break;  // in its place
    case 1:
      v[0] = draw.on_grid(4);
      v[1] = draw.on_grid(4);
      break;
    default:
      v[0] = draw.real(speed * radius);  // rolls
      break;
  }
  // Off the floor, or into it, now and then.
  if (random.once_in(6)) v[2] = draw.real(random.uniform(-2, 2));
  set_motion(draw, problem, v);
  turn_exactly(draw, problem);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kWheelsLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};

}  // namespace

const Family family::wheels{
    .name = "wheels",
    .sentence = "A wheel with corners, or a cylinder, spins fast within a rounding of the floor.",
    .hardness_meaning = "k: the wheel rotates by about 2^k radians a unit of time",
    .levels = kWheelsLevels,
    .fill = fill_wheels,
    .rotating = true,
    .picture = {1, 3},
};

}  // namespace graze::corpus
