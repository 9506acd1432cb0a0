// swung_balls: a ball that is written as another shape, swung by up to a few turns about a pivot that is 2^k
// of its radii away. Hardness: k.
//
// The ball sweeps a ring that is as thick as the ball. A method that takes the shape for a rotating point, or
// counts the radius twice, is wrong by a radius or two. The other body stands on the ring's outside, within
// the ring, or on its flank, at a gap or a depth of 2^-4 to 2^-24, or drifts into the ring while the ball
// comes round. The ring is exact to the rounding of its radius, 2^-36 at most. The ball starts about 8 from
// where it meets, at a rational angle, so that the scale is the bodies' size and not the arm's.
#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

// About the origin, of that radius exactly: radius and its half are on the grid, or a float's.
Shape<double> ball(Draw& draw, double radius) {
  const double half = radius / 2;
  switch (draw.random.below(8)) {
    case 0:
      return Sphere<double>{radius};
    case 1:
    case 2:
      return Ellipsoid<double>{Vec3<double>(radius, radius, radius)};
    case 3:
      return rounded<double>(Point<double>{}, radius);
    case 4:
      return Capsule<double>{radius, 0};
    case 5:
      return sum<double>(Sphere<double>{half}, Ellipsoid<double>{Vec3<double>(half, half, half)});
    case 6:
      return rounded<double>(Capsule<double>{half, 0}, half);
    default:
      return hull_of<double>(Ellipsoid<double>{Vec3<double>(radius, radius, radius)}, Sphere<double>{half});
  }
}

// A shape with its lowest point at the origin and no width along y. Within the ring, a wide shape would reach
// into it elsewhere.
Capped narrow(Draw& draw) {
  const double size = draw.positive_on_grid(2), other = draw.positive_on_grid(4);
  switch (draw.random.below(4)) {
    case 0:
      return {Point<double>{}, 0};
    case 1:
      return {Segment<double>{Vec3<double>(-size, 0, 0), Vec3<double>(size, 0, other)}, 0};
    case 2:
      return {
          Triangle<double>{Vec3<double>(-size, 0, 0), Vec3<double>(size, 0, 0), Vec3<double>(0, 0, other)},
          0};
    default:
      return {Box<double>{Vec3<double>(size, 0, other)}, other};
  }
}

// The axis is x through the origin. The ball meets at (0, 0, radius of the ring), or beside it.
void fill_swung_balls(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double radius = 2 * draw.positive_on_grid(2);
  const double ring =
      std::floor(radius * power_of_two(static_cast<int>(hardness)) * random.uniform(1, 2)) + 1;
  problem.a.shape = ball(draw, radius);
  Vec3<double> center = Vec3<double>::Zero();
  if (random.once_in(3)) {
    for (int i = 0; i < 3; ++i) center[i] = draw.on_grid(4);
    problem.a.shape = posed<double>(std::move(problem.a.shape), center, draw.pose());
  }
  // A start some 8 from there: on an arc of two half angles 1 / w.
  Quaternion<double> start;
  start.w = std::max(1.0, std::floor(ring / random.integer(4, 12)));
  start.x = random.once_in(2) ? 1 : -1;
  if (random.once_in(8)) start = {};  // or there
  problem.a.orientation = start;
  problem.spin_a.pivot = Vec3<double>(center[0], center[1], center[2] - ring);
  const Vec3<double> pivot = rotate(start, problem.spin_a.pivot);
  problem.a.position = Vec3<double>(0 - pivot[0], 0 - pivot[1], 0 - pivot[2]);

  // It passes the meeting, or goes round to it, by a part of a turn or by a few.
  const int whole = random.once_in(3) ? 0 : random.integer(1, 4);
  const double turns = whole + random.uniform(0.25, 1);
  const double angle = draw.real(2 * kPi * turns);
  problem.spin_a.rotation = Vec3<double>(random.once_in(2) ? angle : -angle, 0, 0);

  const double least = power_of_two(-random.integer(4, 24));
  const double delta = random.once_in(2) ? least : -least;
  Vec3<double> away(0, 0, 1);
  Capped other;
  switch (random.below(4)) {
    case 0:
      other = narrow(draw);
      away = Vec3<double>(0, 0, -1);
      problem.b.orientation = {0, 1, 0, 0};  // upside down
      break;
    case 1:
      other = draw.capped_below(4);
      away = Vec3<double>(1, 0, 0);
      problem.b.orientation = {1, 0, 1, 0};  // z to x, exactly
      break;
    default:
      other = random.once_in(3) ? narrow(draw) : draw.capped_below(4);
      break;
  }
  problem.b.shape = other.shape;
  if (random.once_in(6)) {
    const double size = draw.positive_on_grid(4);
    problem.b.shape = ball(draw, size);
    other.lift = size;
  }
  const double out = (radius + other.lift) + delta;
  problem.b.position = Vec3<double>(away[0] * out, 0, ring + away[2] * out);
  Vec3<double> v = Vec3<double>::Zero();
  if (random.once_in(3)) {
    // Into the ring, or out of it, by that much.
    const double by = draw.real(1.5 * delta);
    v = Vec3<double>(-by * away[0], 0, -by * away[2]);
  }
  // A turn about the normal through the lowest feature moves no height.
  if (random.once_in(3)) {
    const double about = draw.real(random.uniform(-4, 4));
    problem.spin_b.rotation = Vec3<double>(about * away[0], 0, about * away[2]);
  }
  set_motion(draw, problem, v);
  turn_exactly(draw, problem);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kSwungBallsLevels[] = {0, 1, 2, 3, 4, 5, 6, 8, 10, 12};

}  // namespace

const Family family::swung_balls{
    .name = "swung_balls",
    .sentence = "A ball, written as another shape, swings about a far pivot by up to a few turns.",
    .hardness_meaning = "k: the pivot is 2^k radii away",
    .levels = kSwungBallsLevels,
    .fill = fill_swung_balls,
    .rotating = true,
    .picture = {2, 1},
};

}  // namespace graze::corpus
