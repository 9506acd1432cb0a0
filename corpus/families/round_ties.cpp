// round_ties: spheres, capsules, rounded boxes and hulls, and polytopes at a target distance. At the meeting, the
// cores' nearest points are R times an integer direction of integer length apart, so the distance is R exactly. There
// B passes on a tangent, enters, leaves or rests. Hardness: minus the number of units in the last place by which a
// radius or the target distance is then changed, either way. 0 is the tie.
//
// The scene is rotated by an integer quaternion q, with every length times |q|^2: the tie stays exact. Where the
// direction has a component 0, the nearest points are on an edge or a face, at times at its end, which is a boundary of
// Voronoi regions. Contact is at the start, on the path, or at t_max, which may be the double before it.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

// Integer vectors of integer length (Pythagorean triples and quadruples).
struct Direction {
  double x, y, z, length;
};
constexpr Direction kDirections[] = {{0, 0, 1, 1}, {3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}};

// A core whose farthest point along n is `top`. Where n has a component 0, that point is anywhere on the grid of the edge
// or the face, or at its end.
struct Core {
  Shape<double> shape;
  Vec3<double> top = Vec3<double>::Zero();
};
Core draw_core(Draw& draw, const Vec3<double>& n, double length) {
  Random& random = draw.random;
  Core out;
  Vec3<double> half;
  for (int i = 0; i < 3; ++i) half[i] = random.integer(0, 4);
  switch (random.below(4)) {
    case 0:
      out.shape = Point<double>{};
      return out;
    case 1:
      half[0] = half[1] = 0;
      out.shape =
          Segment<double>{Vec3<double>(0, 0, -half[2] * length), Vec3<double>(0, 0, half[2] * length)};
      break;
    case 2:
      out.shape = Box<double>{half * length};
      break;
    default: {
      // The box's corners, in any order.
      Hull<double> hull;
      std::vector<Vec3<double>> points;
      const int first = random.integer(0, 7);
      for (int k = 0; k < 8; ++k) {
        const int at = (first + 3 * k) % 8;
        points.push_back(length * Vec3<double>(at % 2 == 1 ? half[0] : -half[0],
                                               at / 2 % 2 == 1 ? half[1] : -half[1],
                                               at / 4 == 1 ? half[2] : -half[2]));
      }
      out.shape = Hull<double>(points);
      break;
    }
  }
  for (int i = 0; i < 3; ++i) {
    const int most = static_cast<int>(half[i]);
    out.top[i] = n[i] > 0 ? half[i] : n[i] < 0 ? -half[i] : random.integer(-most, most);
  }
  return out;
}

// The core grown by a ball: a sphere or a capsule by name where there is one.
Shape<double> grown(Random& random, const Shape<double>& core, double radius) {
  if (radius == 0) return core;
  if (std::holds_alternative<Point<double>>(core) && !random.once_in(4)) return Sphere<double>{radius};
  if (const auto* segment = std::get_if<Segment<double>>(&core); segment != nullptr && !random.once_in(4))
    return Capsule<double>{radius, segment->b[2]};
  return Rounded<double>{share(core), radius};
}

void fill_round_ties(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const Direction& direction = kDirections[random.below(std::size(kDirections))];
  Vec3<double> n(direction.x, direction.y, direction.z);
  const int first = random.integer(0, 2);
  n = Vec3<double>(n[first], n[(first + 1) % 3], n[(first + 2) % 3]);
  for (int i = 0; i < 3; ++i) n[i] = random.once_in(2) ? n[i] : 0 - n[i];

  const Quaternion<double> q = random.once_in(2) ? draw.turned_pose() : Quaternion<double>{};
  const double length = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const Core a = draw_core(draw, n, length), b = draw_core(draw, -n, length);

  // R is the length of n times so many, shared out among the two balls and the target distance.
  const int parts = random.integer(1, 3);
  double share[3] = {0, 0, 0};
  for (int part = 0; part < parts; ++part)
    share[random.once_in(4) ? 2 : random.below(2)] += direction.length * length;
  const double unit = draw.coordinates == Coordinates::floats ? 0x1p-23 : 0x1p-52;
  double& changed = share[share[0] > 0 ? 0 : share[1] > 0 ? 1 : 2];
  changed += (random.once_in(2) ? hardness : 0 - hardness) * unit * std::scalbn(1.0, std::ilogb(changed));
  problem.a.shape = grown(random, a.shape, share[0]);
  problem.b.shape = grown(random, b.shape, share[1]);
  problem.target_distance = share[2];

  const auto [v, t0] = draw_passage(random, n);
  Vec3<double> at_a;
  for (int i = 0; i < 3; ++i) at_a[i] = random.integer(-8, 8);
  problem.a.orientation = problem.b.orientation = q;
  problem.a.position = rotate_scaled(q, at_a);
  problem.b.position = rotate_scaled(q, at_a + a.top + parts * n - b.top - t0 * v);
  set_motion(draw, problem, rotate_scaled(q, v));
  if (t0 > 0 && random.once_in(4)) problem.t_max = random.once_in(2) ? t0 : std::nextafter(t0, 0.0);
  if (random.once_in(4)) problem.start_policy = StartPolicy::pass_over;
  turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kRoundTieLevels[] = {-1024, -64, -8, -2, -1, 0};

}  // namespace

const Family family::round_ties{
    .name = "round_ties",
    .sentence = "Round bodies that touch on a tangent, at the start or at the end, to the last bit or not.",
    .hardness_meaning =
        "-n: a radius is n units in the last place (2^-23 or 2^-52 of it) too large or small; 0 touches",
    .levels = kRoundTieLevels,
    .fill = fill_round_ties,
    .picture = {0, 32},
};

}  // namespace graze::corpus
