// many_vertices: hulls of 2^k vertices, all of them corners. Hardness: k.
//
// Kinds:
//   - rational points of a sphere,
//   - a cap of the paraboloid z = -s (x^2 + y^2) over a lattice, flat where s is small,
//   - a prism over a polygon, its two faces of half the vertices each exactly plane,
//   - the same with the corners of the top lowered by 2^-38 at most, or, with floats, by 2^-17, a ring of
//     nearly coplanar triangles.
// Half of the hulls come with the graph of their faces, which methods climb on. The other body is small.
//
// This breaks a climb that stops on a plateau or at a neighbour that is as high, a face normal of three
// neighbours in a row, and a simplex of nearly coplanar supports.
#include <algorithm>
#include <cmath>
#include <graze/hull.hpp>
#include <utility>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

// Integers are given a size at which that many corners are not rounded into one another.
double size_of(const Draw& draw) { return draw.coordinates == Coordinates::integers ? 1 << 20 : 4; }

using Points = std::vector<Vec3<double>>;

// Stereographic: (2 p d, 2 q d, p^2 + q^2 - d^2) / (p^2 + q^2 + d^2), by |p|, |q| <= 3 d all but a cap at the
// top.
Points on_sphere(Draw& draw, int count) {
  constexpr int kDenominator = 512;
  Points list;
  while (static_cast<int>(list.size()) < count) {
    const double p = draw.random.integer(-3 * kDenominator, 3 * kDenominator),
                 q = draw.random.integer(-3 * kDenominator, 3 * kDenominator), d = kDenominator;
    const double norm = (p * p + q * q) + d * d, r = size_of(draw);
    list.push_back(draw.snap(
        Vec3<double>(r * (2 * p * d / norm), r * (2 * q * d / norm), r * ((p * p + q * q - d * d) / norm))));
  }
  return list;
}

// The lattice points nearest to the middle, each a corner: z = -s |x|^2 is strictly convex.
Points on_cap(Draw& draw, int count) {
  std::vector<std::pair<int, int>> lattice;
  for (int x = -16; x <= 16; ++x) {
    for (int y = -16; y <= 16; ++y) lattice.emplace_back(x, y);
  }
  std::sort(lattice.begin(), lattice.end(), [](const auto& l, const auto& r) {
    const int dl = l.first * l.first + l.second * l.second, dr = r.first * r.first + r.second * r.second;
    return std::pair(dl, l) < std::pair(dr, r);
  });
  // With integers s is 1, else down to 2^-12: a cap as flat as 4 to 2^-10.
  const bool integers = draw.coordinates == Coordinates::integers;
  const double step = integers ? 1 : 0.25, s = integers ? 1 : std::scalbn(1.0, -draw.random.integer(4, 16));
  Points list;
  for (const auto& [x, y] : lattice) {
    if (static_cast<int>(list.size()) == count) break;
    list.emplace_back(step * x, step * y, 0 - s * (x * x + y * y));
  }
  return list;
}

// Two rings of count / 2 points of a circle, at z = h and z = -h. With `lowered`, the upper one's corners are
// 0, 1 or 2 units lower.
Points prism(Draw& draw, int count, bool lowered) {
  const double r = size_of(draw), height = r / 2;
  const double unit = draw.coordinates == Coordinates::doubles ? 0x1p-40 : r * 0x1p-20;
  Points list;
  const int ring = count / 2;
  for (int k = 0; k < ring; ++k) {
    // tan of a quarter of the angle, in -1 .. 1, on the right, and mirrored on the left.
    const int pair = k / 2, pairs = ring / 2;
    const double t = static_cast<double>(2 * pair + 1 - pairs) / pairs, norm = 1 + t * t;
    const double x = draw.snap(r * ((1 - t * t) / norm)), y = draw.snap(r * (2 * t / norm));
    const double drop = lowered ? unit * draw.random.integer(0, 2) : 0;
    list.emplace_back(k % 2 == 0 ? x : 0 - x, y, height - drop);
    list.emplace_back(k % 2 == 0 ? x : 0 - x, y, -height);
  }
  return list;
}

Shape<double> dense_hull(Draw& draw, int count) {
  Random& random = draw.random;
  Points list;
  switch (random.below(4)) {
    case 0:
      list = on_sphere(draw, count);
      break;
    case 1:
      list = on_cap(draw, count);
      break;
    case 2:
      list = prism(draw, count, false);
      break;
    default:
      list = prism(draw, count, true);
      break;
  }
  for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random.below(k)]);
  for (Vec3<double>& x : list) x = Vec3<double>(0 + x[0], 0 + x[1], 0 + x[2]);
  const std::span<const Vec3<double>> points(list);
  return random.once_in(2) ? with_adjacency(points) : Hull<double>(points);
}

// Four vertices at most: the exact oracle forms all differences.
Shape<double> small_shape(Draw& draw, double reach) {
  switch (draw.random.below(6)) {
    case 0:
      return Point<double>{};
    case 1:
      return Sphere<double>{std::abs(draw.coordinate(reach))};
    case 2: {
      const Vec3<double> a = draw.vector(reach), b = draw.vector(reach);
      return Segment<double>{a, b};
    }
    case 3: {
      const Vec3<double> a = draw.vector(reach), b = draw.vector(reach);
      return Triangle<double>{a, b, draw.vector(reach)};
    }
    default:
      return draw.hull(reach, 4);
  }
}

void fill_many_vertices(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  problem.a.shape = dense_hull(draw, 1 << static_cast<int>(hardness));
  const double reach = std::max(bounding_radius(problem.a.shape), 1.0);
  problem.b.shape = small_shape(draw, std::max(draw.snap(reach / 4), 1.0));
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  // From somewhere around to somewhere inside, or beside, and not always far enough.
  Vec3<double> start = draw.vector(3 * reach), v;
  const int axis = random.integer(0, 2);
  const double away = draw.snap(reach * random.uniform(1.5, 4));
  if (!random.once_in(10)) start[axis] = random.once_in(2) ? away : -away;
  const double far = random.uniform(0.5, 2);
  for (int i = 0; i < 3; ++i) {
    const double target = draw.coordinate(0.8 * reach);
    v[i] = draw.snap((target - start[i]) * far);
  }
  // Straight along an axis now and then: onto a plane face or along it.
  if (random.once_in(4)) v[(axis + 1) % 3] = v[(axis + 2) % 3] = 0;
  problem.b.position = start;
  set_motion(draw, problem, v);
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kManyVerticesLevels[] = {5, 6, 7, 8, 9};

}  // namespace

const Family family::many_vertices{
    .name = "many_vertices",
    .sentence = "Dense hulls: spheres, caps, prisms, rings of nearly coplanar triangles.",
    .hardness_meaning = "k: one hull has 2^k corners",
    .levels = kManyVerticesLevels,
    .fill = fill_many_vertices,
    .picture = {6, 4},
};

}  // namespace graze::corpus
