// rays: a point flies at a feature of a shape, or passes it by 10^-k. Hardness: k. One case in eight has
// distance 0.
//
// Frame: the shape has a pose. Its feature is a corner, a point of an edge or of a face, the middle or the
// side of its bounds, or a point on a curved side. The ray comes from anywhere, along one of the shape's own
// axes, or in the plane of a face. Its start is on the feature one time in eight.
//
// Difficulties:
//   - a slab whose direction is 0, and one whose start is on its plane,
//   - an edge between two triangles that neither claims,
//   - a discriminant that cancels far from the shape,
//   - the upper half of the double cone,
//   - the end of a capsule that is never tested,
//   - the body behind the start.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

constexpr double kShapeSize = 4;  // size of the shape (length)

// A point of the shape's boundary, or near it, in its own frame.
Vec3<double> feature(Random& random, const Shape<double>& shape) {
  const std::vector<Vec3<double>> all = corners(shape);
  if (all.size() > 1 && !random.once_in(4)) {
    const Vec3<double>&p = all[random.below(all.size())], &q = all[random.below(all.size())];
    return random.once_in(2) ? p : Vec3<double>((p + q) / 2);
  }
  const Vec3<double> x = middle_or_side(random, shape);
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
    const double z =
        random.once_in(2) ? cylinder->half_height : random.uniform(-1, 1) * cylinder->half_height;
    return {0.6 * cylinder->radius, 0.8 * cylinder->radius, z};
  }
  if (const auto* cone = std::get_if<Cone<double>>(&shape)) {
    const double up = random.once_in(2) ? 0 : random.unit();
    return {0.6 * cone->radius * (1 - up), 0.8 * cone->radius * (1 - up), cone->half_height * (2 * up - 1)};
  }
  return x;
}

void fill_rays(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  problem.a.shape =
      random.once_in(4) ? draw.hull(kShapeSize, random.integer(4, 12)) : draw.leaf(kShapeSize, 0);
  problem.a.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  problem.b.shape = Point<double>{};

  Vec3<double> v = draw.vector(16);
  const int axis = random.integer(0, 2);
  v[axis] = draw.snap(random.uniform(8, 24));
  if (random.once_in(3)) {
    // Along an axis of the shape, or in a plane of two of them.
    v[(axis + 1) % 3] = 0;
    if (random.once_in(2)) v[(axis + 2) % 3] = 0;
    v = draw.real(rotate(problem.a.orientation, v));
  }
  if (random.once_in(2)) v = -v;
  const Vec3<double> at = rotate(problem.a.orientation, feature(random, problem.a.shape));
  Vec3<double> beside = Vec3<double>::Zero();
  if (!random.once_in(8)) {
    const double size = small_unit(draw, hardness);
    for (int i = 0; i < 3; ++i) beside[i] = size * random.uniform(-1, 1);
  }
  meet(draw, problem, at, Vec3<double>::Zero(), beside, v, meeting_time(random));
  draw_horizon(random, problem);
  maybe_swap(draw, problem);
}

constexpr double kRaysLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

}  // namespace

const Family family::rays{
    .name = "rays",
    .sentence = "A ray at a corner, an edge, a face or a curved side.",
    .hardness_meaning = "k: the ray passes the feature by up to 10^-k; one case in eight aims at it",
    .levels = kRaysLevels,
    .fill = fill_rays,
    .picture = {1, 3},
};

}  // namespace graze::corpus
