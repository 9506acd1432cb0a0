// redundant_vertices: hulls that list more than their corners. Hardness: k, 2^k redundant vertices for each
// of the corners: copies, midpoints of two corners, weighted means of three and of four, all shuffled.
//
// Exact: corners are multiples of 4 grid steps, so that halves and quarters of their sums are on the grid. A
// mean of two, three or four corners lies on an edge, in a face, or inside. Difficulties: a support that is
// drawn again under another index, collinear and coplanar simplexes, cycles.
#include <algorithm>
#include <utility>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

// Weights in quarters, of up to four corners.
constexpr int kWeights[][4] = {{4, 0, 0, 0}, {4, 0, 0, 0}, {2, 2, 0, 0}, {2, 2, 0, 0},
                               {1, 3, 0, 0}, {2, 1, 1, 0}, {2, 1, 1, 0}, {1, 1, 1, 1}};

std::vector<Vec3<double>> random_corners(Draw& draw) {
  Random& random = draw.random;
  // Four grid steps a unit, within 4, or 8 with integers.
  const double reach = draw.coordinates == Coordinates::integers ? 2 : 1;
  const auto extent = [&] { return 4 * draw.positive_on_grid(reach); };
  Vec3<double> half;
  for (int i = 0; i < 3; ++i) half[i] = extent();
  std::vector<Vec3<double>> list;
  switch (random.below(4)) {
    case 0:  // a box
      for (int k = 0; k < 8; ++k) {
        list.emplace_back(k & 1 ? half[0] : -half[0], k & 2 ? half[1] : -half[1], k & 4 ? half[2] : -half[2]);
      }
      break;
    case 1:  // an octahedron
      for (int i = 0; i < 3; ++i) {
        for (const double side : {-1.0, 1.0}) {
          Vec3<double> x = Vec3<double>::Zero();
          x[i] = side * half[i];
          list.push_back(x);
        }
      }
      break;
    case 2:  // a parallelogram: flat
      for (int k = 0; k < 4; ++k)
        list.emplace_back(k & 1 ? half[0] : -half[0], k & 2 ? half[1] : -half[1], 0);
      break;
    default:  // a tetrahedron, its corners in four octants
      for (const int octant : {0, 3, 5, 6}) {
        const double x = extent(), y = extent(), z = extent();
        list.emplace_back(octant & 1 ? x : -x, octant & 2 ? y : -y, octant & 4 ? z : -z);
      }
      break;
  }
  return list;
}

Shape<double> redundant_hull(Draw& draw, int copies) {
  Random& random = draw.random;
  const std::vector<Vec3<double>> corner = random_corners(draw);
  std::vector<Vec3<double>> list = corner;
  while (list.size() < corner.size() * static_cast<std::size_t>(1 + copies)) {
    const auto& weights = kWeights[random.below(std::size(kWeights))];
    Vec3<double> mean = Vec3<double>::Zero();
    for (const int weight : weights) {
      const Vec3<double>& x = corner[random.below(corner.size())];
      for (int i = 0; i < 3; ++i) mean[i] += weight * (x[i] / 4);
    }
    list.push_back(mean);
  }
  for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random.below(k)]);
  for (Vec3<double>& x : list) x = Vec3<double>(0 + x[0], 0 + x[1], 0 + x[2]);
  return Hull<double>(std::span<const Vec3<double>>(list));
}

void fill_redundant_vertices(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int copies = 1 << static_cast<int>(hardness);
  // The other body is kept small: the exact oracle forms all differences.
  constexpr int kOtherCopies = 4;
  problem.a.shape = redundant_hull(draw, copies);
  problem.b.shape =
      random.once_in(2) ? redundant_hull(draw, std::min(copies, kOtherCopies)) : draw.shape(4, 6);
  // On a grid, along an axis or a diagonal (ties along the whole path), or anyhow.
  const bool aligned = random.once_in(2);
  if (aligned) {
    const double speed = 32 + draw.positive_on_grid(32), t0 = 0.25 * random.integer(0, 3);
    Vec3<double> v = Vec3<double>::Zero(), start;
    const int axis = random.integer(0, 2);
    v[axis] = random.once_in(2) ? speed : -speed;
    if (random.once_in(3)) v[(axis + 1) % 3] = random.once_in(2) ? speed : -speed;
    for (int i = 0; i < 3; ++i) {
      const double aim_at = i != axis && random.once_in(2) ? 0 : 2 * draw.on_grid(4);
      start[i] = aim_at - draw.snap(t0 * v[i]);
    }
    problem.b.position = start;
    set_motion(draw, problem, v);
    if (random.once_in(8)) problem.t_max = kInfinity<double>;
    vary_time_scale(draw, problem);
    turn_exactly(draw, problem);
  } else {
    problem.a.orientation = draw.pose();
    problem.b.orientation = draw.pose();
    problem.a.position = draw.vector(8);
    aim(draw, problem, 2);
    vary_time_scale(draw, problem);
  }
  maybe_swap(draw, problem);
}

constexpr double kRedundantVerticesLevels[] = {0, 1, 2, 3, 4, 5};

}  // namespace

const Family family::redundant_vertices{
    .name = "redundant_vertices",
    .sentence = "Hulls that list more than their corners: copies, midpoints, inner points.",
    .hardness_meaning = "k: 2^k redundant vertices for each corner",
    .levels = kRedundantVerticesLevels,
    .fill = fill_redundant_vertices,
    .picture = {2, 8},
};

}  // namespace graze::corpus
