// flat_shapes: plates, needles and specks, in one plane, on one line, or anyhow. Hardness: k, the flattest
// body's aspect is 10^-k: its least extent over its largest, in its own frame. Levels above 16 are exactly
// flat: zero extents, points, segments, triangles.
//
// Exact: the thin coordinates are -1, 0 or 1 times 10^-k (rounded to float with floats and integers), the
// others reach 1 to 4 from the middle. In one plane, positions and motion lie in z = 0, or a thickness above
// it, and a rotation of the cube keeps that. Difficulty: C is flat too, so a simplex stays a triangle or a
// segment, its volume is 0 or noise, and a barycentric divisor vanishes.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

constexpr int kLastThick = 16;

struct Flat {
  double thickness = 0;  // half extent along the thin axes (length)
  int thick_axes = 2;    // x, or x and y (the others are thin)
};

Vec3<double> flat_point(Draw& draw, const Flat& flat) {
  Vec3<double> x;
  for (int i = 0; i < 3; ++i) {
    x[i] = i < flat.thick_axes ? draw.on_grid(4) : 0 + flat.thickness * draw.random.integer(-1, 1);  // no -0
  }
  return x;
}

Shape<double> flat_hull(Draw& draw, const Flat& flat, int vertices) {
  std::vector<Vec3<double>> list(static_cast<std::size_t>(vertices));
  for (Vec3<double>& x : list) x = flat_point(draw, flat);
  // The first two reach far apart along the first axis, on either side of the thin ones.
  for (int k = 0; k < 2; ++k) {
    const double side = k == 0 ? -1 : 1;
    list[static_cast<std::size_t>(k)][0] = side * (1 + draw.positive_on_grid(3));
    for (int i = flat.thick_axes; i < 3; ++i)
      list[static_cast<std::size_t>(k)][i] = 0 + side * flat.thickness;
  }
  std::swap(list[0], list[draw.random.below(list.size())]);
  if (vertices == 2) return Segment<double>{list[0], list[1]};
  if (vertices == 3) return Triangle<double>{list[0], list[1], list[2]};
  return Hull<double>(std::span<const Vec3<double>>(list));
}

Shape<double> flat_shape(Draw& draw, const Flat& flat) {
  switch (draw.random.below(6)) {
    case 0:
    case 1: {
      Vec3<double> half;
      for (int i = 0; i < 3; ++i) {
        half[i] = i < flat.thick_axes ? 1 + draw.positive_on_grid(3) : flat.thickness;
      }
      return Box<double>{half};
    }
    case 2:
      return flat_hull(draw, flat, 2);
    case 3:
      return flat_hull(draw, flat, 3);
    default:
      return flat_hull(draw, flat, draw.random.integer(4, 12));
  }
}

Shape<double> partner(Draw& draw, const Flat& flat) {
  if (draw.random.once_in(8)) return Point<double>{};
  return flat_shape(draw, flat);
}

// Both are thin along the same axes. The path lies in their plane (line) or a thickness off it.
void fill_in_one_plane(Draw& draw, const Flat& flat, Case& problem) {
  Random& random = draw.random;
  problem.b.shape = partner(draw, flat);
  if (flat.thick_axes == 2) {
    problem.a.orientation = draw.pose_about_z();
    problem.b.orientation = draw.pose_about_z();
  }
  const double t0 = 0.25 * random.integer(1, 5);
  Vec3<double> v = Vec3<double>::Zero(), start = Vec3<double>::Zero();
  for (int i = 0; i < flat.thick_axes; ++i) {
    const double along = 16 + draw.positive_on_grid(16);
    v[i] = i == 0 || random.once_in(2) ? (random.once_in(2) ? along : -along) : draw.on_grid(8);
    start[i] = draw.on_grid(4) - draw.snap(t0 * v[i]);
  }
  // In the plane, or just touching, or just beside.
  constexpr double kOff[] = {0, 0, 0, 1, -1, 2, -2, 3};
  start[2] = 0 + kOff[random.below(std::size(kOff))] * flat.thickness;
  if (random.once_in(12)) start = Vec3<double>(draw.on_grid(2), 0, start[2]);
  problem.b.position = start;
  set_motion(draw, problem, v);
  if (random.once_in(12)) problem.t_max = kInfinity<double>;
}

void fill_flat_shapes(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int k = static_cast<int>(hardness);
  // Over an extent of about 5.
  const double thin = k > kLastThick ? 0 : 2.5 * power_of_ten(-k);
  const Flat flat{draw.real(thin), random.integer(1, 2)};
  problem.a.shape = flat_shape(draw, flat);
  const bool in_one_plane = random.once_in(2);
  if (in_one_plane) {
    fill_in_one_plane(draw, flat, problem);
  } else {
    const Flat other{flat.thickness, random.integer(1, 2)};
    problem.b.shape = random.once_in(3) ? draw.shape(4, random.integer(4, 8)) : partner(draw, other);
    problem.a.orientation = draw.pose();
    problem.b.orientation = draw.pose();
    problem.a.position = draw.vector(8);
    aim(draw, problem, random.once_in(2) ? 2 : std::max(flat.thickness, 1e-8));
  }
  vary_time_scale(draw, problem);
  if (in_one_plane && draw.coordinates == Coordinates::doubles && random.once_in(4)) {
    turn_rounded(draw, problem);
  } else if (in_one_plane || random.once_in(2)) {
    turn_exactly(draw, problem);
  }
  maybe_swap(draw, problem);
}

constexpr double kFlatShapesLevels[] = {1, 2, 4, 6, 8, 10, 12, 14, 16, 17};  // 17: none at all

}  // namespace

const Family family::flat_shapes{
    .name = "flat_shapes",
    .sentence = "Plates, needles and specks, in one plane, on one line, or anyhow.",
    .hardness_meaning = "k: the flattest body's least extent is 10^-k of its largest; 17 is exactly flat",
    .levels = kFlatShapesLevels,
    .fill = fill_flat_shapes,
    .picture = {2, 4},
};

}  // namespace graze::corpus
