// parallel_faces: a small body falls face down on a large plate, the two faces parallel to within 10^-k
// radians. parallel_edges: an edge meets an edge that crosses it at an angle of 10^-k. Hardness: k.
//
// The tilt is exact however small. The tilted face is a parallelogram about the body's origin, and the
// z-coordinates of its corners are exactly the tilt times their distance. The tilted edge is built in the
// same way. Or the body is a box, turned by the quaternion (1, x, y, 0) of half the tilt. A scene with such
// corners is turned by a rotation of the cube, into the hulls or the poses. A scene with such a quaternion is
// turned by half turns only. Any other rotation would round the tilt away.
//
// Difficulties:
//   - 10^-k decides which corner comes first, and a wrong one leaves the normal 10^-k off,
//   - the faces of C that meet are nearly one plane, so a simplex of theirs is flat, and the polytope of an EPA
//     or MPR is refined for no gain,
//   - the normal of crossing edges is the cross product of two that are nearly parallel, and the face of C that
//     holds the contact is 10^-k wide.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"
#include "corpus/families/topped.hpp"

namespace graze::corpus {
namespace {

constexpr double kSmallReach = 4;  // size of a small body (length)

struct Slope {
  double x = 0, y = 0;
};

// A slope of length 1.
Slope unit_slope(Random& random) {
  constexpr Slope kSlopes[] = {{1, 0}, {0, 1}, {0.6, 0.8}, {-0.8, 0.6}, {-0.28, 0.96}};
  return kSlopes[random.below(std::size(kSlopes))];
}

double kept(const Draw& draw, double x) {
  return draw.coordinates == Coordinates::floats ? round_to_float(x) : x;
}

// A hull above its bottom face, which passes the origin at the slope.
Shape<double> tilted_hull(Draw& draw, double tilt) {
  Random& random = draw.random;
  const double a = draw.positive_on_grid(kSmallReach), b = std::abs(draw.on_grid(kSmallReach));
  const double c = -draw.positive_on_grid(kSmallReach), d = draw.positive_on_grid(kSmallReach);
  const Slope slope = unit_slope(random);
  const Vec3<double> p(a, b, kept(draw, tilt * (slope.x * a + slope.y * b)));
  const Vec3<double> q(c, d, kept(draw, tilt * (slope.x * c + slope.y * d)));
  const Vec3<double> zero = Vec3<double>::Zero();
  std::vector<Vec3<double>> list = {p, q, zero - p, zero - q};
  const int vertices = random.integer(5, 16);
  while (static_cast<int>(list.size()) < vertices) {
    const double x = draw.on_grid(kSmallReach), y = draw.on_grid(kSmallReach);
    // Above the face, which rises by a tilt of 1/10 times 2 kSmallReach at most.
    list.emplace_back(x, y, 1 + draw.positive_on_grid(kSmallReach));
  }
  for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random.below(k)]);
  return Hull<double>(std::span<const Vec3<double>>(list));
}

void fill_parallel_faces(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double tilt = small_unit(draw, hardness);
  const bool by_pose = random.once_in(3);

  // The plate: its top is z = 0.
  const double x = 20 * kSmallReach, y = 20 * kSmallReach, z = draw.positive_on_grid(kSmallReach);
  problem.a.shape = Box<double>{Vec3<double>(x, y, z)};
  problem.a.position = Vec3<double>(0, 0, -z);
  // Its face over the plate's, now and then over its rim or beside it.
  Vec3<double> place;
  place[0] = draw.on_grid(random.once_in(2) ? x + kSmallReach : 0.5 * x);
  place[1] = draw.on_grid(random.once_in(3) ? y + kSmallReach : 0.5 * y);
  const double height = draw.positive_on_grid(8);
  place[2] = height + 1;
  if (by_pose) {
    const double half_z = draw.positive_on_grid(kSmallReach);
    const double half_x = draw.positive_on_grid(kSmallReach);
    problem.b.shape = Box<double>{Vec3<double>(half_x, draw.positive_on_grid(kSmallReach), half_z)};
    const Slope slope = unit_slope(random);
    problem.b.orientation = {1, kept(draw, tilt / 2 * slope.x), kept(draw, tilt / 2 * slope.y), 0};
    place[2] += half_z;
  } else {
    problem.b.shape = tilted_hull(draw, tilt);
  }
  // Down, often aslant, and one time in six not far enough.
  const double fall = random.once_in(6) ? 0.25 : 2;
  Vec3<double> v(0, 0, -fall * (height + 2));
  if (random.once_in(2)) {
    v[0] = draw.on_grid(16);
    v[1] = draw.on_grid(16);
  }
  problem.b.position = place;
  set_motion(draw, problem, v);
  draw_horizon(random, problem);
  vary_time_scale(draw, problem);
  if (by_pose) {
    turn_by_half_turn(draw, problem);
  } else {
    turn_exactly(draw, problem);
  }
  maybe_swap(draw, problem);
}

void fill_parallel_edges(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double tilt = small_unit(draw, hardness);
  const double length_a = 1 + draw.positive_on_grid(kSmallReach),
               length_b = 1 + draw.positive_on_grid(kSmallReach);
  const Vec3<double> zero = Vec3<double>::Zero();
  const Vec3<double> p(length_a, 0, 0), q(length_b, kept(draw, tilt * length_b), 0);
  const Shape<double> a = random.once_in(6) ? Shape<double>(Segment<double>{p, zero - p})
                                            : hull_under(draw, {p, zero - p}, kSmallReach, zero);
  const Shape<double> b = random.once_in(6) ? Shape<double>(Segment<double>{q, zero - q})
                                            : hull_under(draw, {q, zero - q}, kSmallReach, zero);
  if (random.once_in(2)) {
    // Past the crossing, above or below by some power of ten: v is horizontal.
    const double height = small_unit(draw, random.integer(1, static_cast<int>(hardness)));
    const Vec3<double> direction = random.once_in(4) ? p : zero;
    const double delta = random.once_in(2) ? height : -height;
    pass_over(draw, problem, {a, {}, zero}, {b, {}, zero}, direction, delta);
    return;
  }
  // Down onto the strip {s p + t q : |s|, |t| <= 1} of C, one in ten beside it.
  const Topped below = mirrored({b, {}, zero});
  problem.a.shape = a;
  problem.b.shape = below.shape;
  const double s = random.uniform(-1.1, 1.1), t = random.uniform(-1.1, 1.1);
  const double t0 = 0.25 * random.integer(1, 5);
  Vec3<double> v(draw.on_grid(8), 0, 0);
  if (random.once_in(3)) v[1] = draw.on_grid(8);
  v[2] = 0 - (8 + draw.positive_on_grid(16));
  problem.b.position = Vec3<double>((s * p[0] + t * q[0]) - t0 * v[0], t * q[1] - t0 * v[1], 0 - t0 * v[2]);
  if (draw.coordinates == Coordinates::floats) {
    for (int i = 0; i < 3; ++i) problem.b.position[i] = round_to_float(problem.b.position[i]);
  }
  set_motion(draw, problem, v);
  draw_horizon(random, problem);
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kNearParallelLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

}  // namespace

const Family family::parallel_faces{
    .name = "parallel_faces",
    .sentence = "A small body falls face on face, the two nearly parallel.",
    .hardness_meaning = "k: the angle between the faces is 10^-k radians",
    .levels = kNearParallelLevels,
    .fill = fill_parallel_faces,
    .picture = {1, 6},
};

const Family family::parallel_edges{
    .name = "parallel_edges",
    .sentence = "Two edges meet that are nearly parallel.",
    .hardness_meaning = "k: the angle between the edges is 10^-k radians",
    .levels = kNearParallelLevels,
    .fill = fill_parallel_edges,
    .picture = {1, 3},
};

}  // namespace graze::corpus
