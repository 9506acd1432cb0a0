// level_tiles: a body slides or rolls, yawing, onto a tile that is level with the floor it came from.
// Hardness: k, its height above the tile is 10^-k, either way. From 17 on it is exactly 0.
//
// The tile's top is z = 0, the body's lowest feature is at that height, on the grid, and a turn about z moves
// no height. A sliding body touches the tile at the moment at which it reaches its rim, and stays in touch,
// or hovers, or its rim meets the tile's wall at the lowest corner. A rolling body turns about its own axis
// as well, and its axis then dips by the product of the two turns. Most start beside the tile, one in six on
// it, and one in six passes by.
//
// Difficulties: contact is never deeper than the rounding, so no depth can be proved. A march that must get
// there gains less with every step.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"
#include "corpus/families/turning.hpp"
#include "corpus/support_value.hpp"

namespace graze::corpus {
namespace {

// Its top is z = 0.
Topped tile(Draw& draw) {
  const double x = 1 + draw.positive_on_grid(4), y = 1 + draw.positive_on_grid(4);
  const double height = draw.positive_on_grid(2);
  switch (draw.random.below(6)) {
    case 0:
      return {Triangle<double>{Vec3<double>(-x, -y, 0), Vec3<double>(x, -y, 0), Vec3<double>(-x, y, 0)}, {}};
    case 1:
      return {Cylinder<double>{x, height}, {}, Vec3<double>(0, 0, -height)};
    case 2: {
      std::vector<Vec3<double>> top = {Vec3<double>(-x, -y, 0), Vec3<double>(x, -y, 0), Vec3<double>(x, y, 0),
                                       Vec3<double>(-x, y, 0)};
      return {hull_under(draw, std::move(top), 4, Vec3<double>::Zero()), {}};
    }
    default:
      return {Box<double>{Vec3<double>(x, y, height)}, {}, Vec3<double>(0, 0, -height)};
  }
}

// On its side, its axis along y.
Topped roller(Draw& draw) {
  const double radius = draw.positive_on_grid(2), half_height = draw.positive_on_grid(2);
  const Vec3<double> position(0, 0, radius);
  switch (draw.random.below(4)) {
    case 0:
      return {Capsule<double>{radius, half_height}, kLaidDown, position};
    case 1:
      return {Ellipsoid<double>{Vec3<double>(radius, radius, half_height)}, kLaidDown, position};
    default:
      return {Cylinder<double>{radius, half_height}, kLaidDown, position};
  }
}

void fill_level_tiles(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  constexpr int kLastHeight = 16;
  const int k = static_cast<int>(hardness);
  const double unit = k > kLastHeight ? 0 : draw.real(power_of_ten(-k));
  const double height = random.once_in(2) ? unit : 0 - unit;
  const bool rolls = random.once_in(3);
  const Topped below = tile(draw), above = rolls ? roller(draw) : standing(draw, 4);
  problem.a = {.shape = below.shape, .position = below.position, .orientation = below.orientation};
  problem.b = {.shape = above.shape, .position = above.position, .orientation = above.orientation};
  // The tile takes the part that the body's own height cannot: B's position is exactly the height.
  problem.a.position[2] -= above.position[2];
  problem.b.position[2] = height;

  // From beside the tile onto it within this step or the next, or on it, or past it.
  const double reach = std::floor(reach_of(below) + reach_of(above)) + 1;
  const bool fast = random.once_in(2);
  const double along = fast ? draw.positive_on_grid(8) : draw.real(random.uniform(0.01, 0.25));
  Vec3<double> v(random.once_in(2) ? along : -along, 0, 0);
  if (random.once_in(2)) v[1] = draw.real(along * random.uniform(-0.5, 0.5));
  const auto manner = random.below(6);
  if (manner != 0) {
    // Its lowest point comes over the tile's rim within the step, or the first of its points does.
    double rim = bounds(below.shape, below.orientation).high[0];
    if (manner > 3) rim += bounds(above.shape, above.orientation).high[0];
    const double start = draw.real(rim + along * random.uniform(0, 0.75));
    problem.b.position[0] = v[0] > 0 ? -start : start;
    problem.b.position[1] = manner == 1 ? reach : draw.on_grid(1);
  }
  const double yaw = draw.real(random.once_in(2) ? random.uniform(-2, 2) : random.uniform(-0.05, 0.05));
  problem.spin_b.rotation = Vec3<double>(0, 0, yaw);
  if (rolls) {
    // It rolls as fast as it moves. Its yaw is zero, slight or any.
    const double radius = above.position[2];
    problem.spin_b.rotation[1] = draw.real(v[0] / radius);
    if (!random.once_in(4))
      problem.spin_b.rotation[2] = draw.real(yaw * power_of_two(-random.integer(4, 20)));
    if (random.once_in(4)) problem.spin_b.rotation[2] = 0;
    if (random.once_in(3)) problem.spin_b.pivot = Vec3<double>(0, 0, draw.on_grid(2));
  } else if (random.once_in(3)) {
    problem.b.orientation = multiply(draw.pose_about_z(), problem.b.orientation);
  }
  if (!rolls && random.once_in(3)) {
    for (int i = 0; i < 3; ++i) problem.spin_b.pivot[i] = draw.on_grid(1);
  }
  // The tile turns about the plane's normal: that moves no height.
  if (random.once_in(3)) problem.spin_a.rotation = Vec3<double>(0, 0, draw.real(random.uniform(-1, 1)));
  if (random.once_in(4)) {
    for (int i = 0; i < 2; ++i) problem.spin_a.pivot[i] = draw.on_grid(2);
  }
  set_motion(draw, problem, v);
  turn_exactly(draw, problem);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kLevelTilesLevels[] = {9, 10, 11, 12, 13, 14, 15, 16, 17};  // 17: level

}  // namespace

const Family family::level_tiles{
    .name = "level_tiles",
    .sentence = "A body slides or rolls, yawing, onto a tile that is level with its lowest point.",
    .hardness_meaning = "k: the body is 10^-k above or below the tile; 17 is level",
    .levels = kLevelTilesLevels,
    .fill = fill_level_tiles,
    .rotating = true,
    .picture = {9, 11},
};

}  // namespace graze::corpus
