// above_a_floor: a rotating body starts a little above a floor, and stays above it, rises or falls. Hardness:
// k, it starts about 10^-k above.
//
// The floor's top is z = 0, and the body's lowest feature starts at the height, exactly. Half of the bodies
// turn about z and slide. Their height does not change, which is a clear miss. Some of the others tumble and
// rise faster than any of their points can sink, and the rest tumble and fall. All cases are also run with a
// tolerance, 1e-6 or 1e-3, as in a game. A tolerance changes times but no verdict, and bodies that start
// apart do not start in contact. This breaks a search that ends within the tolerance of contact and reports
// that as an answer.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

void fill_above_a_floor(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double height = draw.real(power_of_ten(-static_cast<int>(hardness)) * random.uniform(0.5, 2));
  Topped above = standing(draw, 4);
  // A point on a plane turns in no way that is seen.
  while (std::holds_alternative<Point<double>>(above.shape)) above = standing(draw, 4);
  const double size = random.once_in(2) ? 32 : 1 + draw.positive_on_grid(8);
  const double thickness = draw.positive_on_grid(1);
  problem.a.shape = Box<double>{Vec3<double>(size, size, thickness)};
  // The floor takes the body's own height.
  problem.a.position = Vec3<double>(0, 0, -(thickness + above.position[2]));
  problem.b = {.shape = above.shape, .position = above.position, .orientation = above.orientation};
  problem.b.position[2] = height;
  if (random.once_in(3)) problem.b.orientation = multiply(draw.pose_about_z(), problem.b.orientation);
  for (int i = 0; i < 2; ++i) problem.b.position[i] = draw.on_grid(1);

  Vec3<double> v = draw.vector(2);
  v[2] = 0;
  const double angle = random.once_in(2) ? random.uniform(-4, 4) : random.uniform(-0.1, 0.1);
  problem.spin_b.rotation = Vec3<double>(0, 0, draw.real(angle));
  if (random.once_in(3)) {
    for (int i = 0; i < 3; ++i) problem.spin_b.pivot[i] = draw.on_grid(1);
  }
  const auto manner = random.below(10);
  if (manner >= 5) {
    const Vec3<double> axis = direction(draw);
    for (int i = 0; i < 3; ++i) problem.spin_b.rotation[i] = draw.real(angle * axis[i]);
    const Vec3<double> p = problem.spin_b.pivot;
    const double arm = bounding_radius(above.shape) + std::sqrt((p[0] * p[0] + p[1] * p[1]) + p[2] * p[2]);
    const double fastest = std::abs(angle) * arm;
    v[2] = manner == 5 ? draw.real(1.25 * fastest + 0.5) : draw.real(0 - random.uniform(0.1, 2));
  }
  // The floor turns about its normal.
  if (random.once_in(3)) problem.spin_a.rotation = Vec3<double>(0, 0, draw.real(random.uniform(-1, 1)));
  set_motion(draw, problem, v);
  turn_exactly(draw, problem);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kAboveAFloorLevels[] = {2, 3, 4, 5, 6, 7};

}  // namespace

const Family family::above_a_floor{
    .name = "above_a_floor",
    .sentence = "A rotating body starts a little above a floor, and stays above it, rises or falls.",
    .hardness_meaning = "k: it starts about 10^-k above the floor, for shapes of size 4",
    .levels = kAboveAFloorLevels,
    .fill = fill_above_a_floor,
    .rotating = true,
    .picture = {2, 1},
};

}  // namespace graze::corpus
