// lattice: shapes, positions and motion on ever coarser lattices. Hardness: k, the coordinates of shapes are
// integers of -2^(6-k) .. 2^(6-k). Positions and velocities are small integer multiples of such. With k grows
// the fraction of the 26 directions of -1, 0, 1 in which C's support is not a single vertex.
//
// Exact: integers below 2^12 alone, and poses that are rotations of the cube. Difficulties: support ties at
// every step, the origin on faces and edges of the simplex, starts that touch.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

Vec3<double> integers(Random& random, int reach) {
  const int x = random.integer(-reach, reach), y = random.integer(-reach, reach);
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(random.integer(-reach, reach))};
}

Shape<double> lattice_shape(Random& random, int reach) {
  std::vector<Vec3<double>> list(static_cast<std::size_t>(random.integer(4, 16)));
  for (Vec3<double>& x : list) x = integers(random, reach);
  switch (random.below(10)) {
    case 0:
      return Point<double>{};
    case 1:
      return Segment<double>{list[0], list[1]};
    case 2:
      return Triangle<double>{list[0], list[1], list[2]};
    case 3:
    case 4:
      return Box<double>{list[0].cwiseAbs()};
    default:
      return Hull<double>(std::span<const Vec3<double>>(list));
  }
}

void fill_lattice(Draw& draw, double hardness, Case& problem) {
  draw.coordinates = Coordinates::integers;
  Random& random = draw.random;
  const int reach = 1 << (6 - static_cast<int>(hardness));
  problem.a.shape = lattice_shape(random, reach);
  problem.b.shape = lattice_shape(random, reach);
  if (random.once_in(2)) problem.a.orientation = draw.cube_rotation();
  if (random.once_in(2)) problem.b.orientation = draw.cube_rotation();
  problem.a.position = integers(random, reach);

  // From `steps` strides away to a lattice point near A, at half of the horizon or beyond it.
  Vec3<double> stride;
  do {
    stride = integers(random, reach);
  } while (stride == Vec3<double>::Zero());
  const int steps = random.once_in(12) ? 0 : random.integer(2, 8);
  const Vec3<double> target = integers(random, 2 * reach);
  problem.b.position = problem.a.position + target - steps * stride;
  set_motion(draw, problem, random.once_in(16) ? Vec3<double>::Zero() : Vec3<double>(2 * steps * stride));
  if (random.once_in(8)) {
    problem.t_max = kInfinity<double>;
  } else if (random.once_in(4)) {
    problem.t_max = 0.25;
  }
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kLatticeLevels[] = {0, 1, 2, 3, 4, 5, 6};

}  // namespace

const Family family::lattice{
    .name = "lattice",
    .sentence = "Shapes, positions and motion on a coarse lattice.",
    .hardness_meaning = "k: the shapes' coordinates are integers of -2^(6-k) .. 2^(6-k)",
    .levels = kLatticeLevels,
    .fill = fill_lattice,
    .picture = {5, 6},
};

}  // namespace graze::corpus
