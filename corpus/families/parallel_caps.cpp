// parallel_caps: prisms that fall cap on cap, the caps parallel except for the last bits. Hardness: k, the
// larger has 2^k vertices.
//
// A cap is a disk of random points, a regular polygon, or the ring of a cylinder, at a height that is the
// same up to a few units in the last place. A body often lies far out in its own frame. The two bodies are
// turned by one quaternion of four doubles, or by two that differ by a unit in the last place. So every
// vertex of a cap is as far along the normal as every other, to rounding, and A - B has a face of as many
// near ties as pairs.
//
// This breaks methods that decide near ties one by one, each in exact arithmetic.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"
#include "corpus/families/standing.hpp"

namespace graze::corpus {
namespace {

std::vector<Vec3<double>> two_caps(Draw& draw, int vertices, double radius, double half_height) {
  Random& random = draw.random;
  const auto manner = random.below(3);
  const int units = random.once_in(4) ? 0 : random.integer(1, 4);
  const auto height = [&](double sign) {
    return sign * moved_by_units(draw, half_height, units == 0 ? 0 : random.integer(-units, units));
  };
  std::vector<Vec3<double>> list;
  if (manner == 0) {
    for (int i = 0; i < vertices; ++i) {
      // In the disk: the square's other points are drawn again.
      double x = 0, y = 0;
      do {
        x = random.uniform(-1, 1);
        y = random.uniform(-1, 1);
      } while (x * x + y * y > 1);
      list.emplace_back(radius * x, radius * y, height(i % 2 == 0 ? 1 : -1));
    }
  } else {
    const int first = random.integer(3, 5);
    int doublings = 0;
    while (first << (doublings + 1) <= vertices / 2) ++doublings;
    for (const Point2& x : regular_polygon(first, doublings)) {
      for (const double sign : {-1.0, 1.0}) list.emplace_back(radius * x[0], radius * x[1], height(sign));
    }
  }
  for (Vec3<double>& x : list) x = draw.real(x);
  return list;
}

// Moves the body's vertices by `shift` in its own frame, and the body back.
void move_in_own_frame(Draw& draw, Body<double>& body, std::vector<Vec3<double>> list,
                       const Vec3<double>& shift) {
  for (Vec3<double>& x : list) x = draw.real(Vec3<double>(x + shift));
  body.shape = Hull<double>(std::span<const Vec3<double>>(list));
}

void fill_parallel_caps(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int vertices = 1 << static_cast<int>(hardness);
  const double height_a = draw.real(random.uniform(0.25, 2)), height_b = draw.real(random.uniform(0.25, 2));
  const auto draw_shift = [&] {
    Vec3<double> shift = Vec3<double>::Zero();
    if (random.once_in(3)) return shift;
    const double far = power_of_ten(random.integer(0, draw.coordinates == Coordinates::floats ? 3 : 6));
    for (int i = 0; i < 3; ++i) shift[i] = far * random.integer(-1, 1);
    return shift;
  };
  const Vec3<double> shift_a = draw_shift(), shift_b = draw_shift();
  // The exact oracle forms all differences.
  constexpr int kMostOfBoth = 64;
  const int fewer = vertices <= kMostOfBoth && random.once_in(2) ? vertices : random.integer(6, 8);
  move_in_own_frame(draw, problem.a, two_caps(draw, vertices, 1, height_a), shift_a);
  const double radius_b = random.once_in(2) ? 1 : random.uniform(0.25, 2);
  move_in_own_frame(draw, problem.b, two_caps(draw, fewer, radius_b, height_b), shift_b);

  Quaternion<double> q;
  if (!random.once_in(4)) {
    for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = draw.real(random.uniform(-1, 1));
  }
  problem.a.orientation = q;
  if (random.once_in(2)) q.z = moved_by_units(draw, q.z, random.once_in(2) ? 1 : -1);
  problem.b.orientation = q;

  // Cap to cap, along their normal or at an angle to it, from above or past each other.
  const double sign = random.once_in(2) ? 1 : -1;
  Vec3<double> way(0, 0, -sign * random.uniform(4, 12));
  if (!random.once_in(3)) {
    for (int i = 0; i < 2; ++i) way[i] = random.uniform(-4, 4);
  }
  const double across = random.once_in(4) ? 6 : 0.8;
  Vec3<double> beside(random.uniform(-across, across), 0, 0);
  beside[1] = random.uniform(-across, across);
  const Vec3<double> cap_a = rotate(problem.a.orientation, shift_a + Vec3<double>(0, 0, sign * height_a));
  const Vec3<double> cap_b = rotate(problem.b.orientation, shift_b - Vec3<double>(0, 0, sign * height_b));
  const Vec3<double> v = draw.real(rotate(problem.a.orientation, way));
  const double t = meeting_time(random);
  meet(draw, problem, cap_a, cap_b, rotate(problem.a.orientation, beside), v, t);
  draw_horizon(random, problem);
  maybe_swap(draw, problem);
}

constexpr double kParallelCapsLevels[] = {4, 5, 6, 7, 8, 9};

}  // namespace

const Family family::parallel_caps{
    .name = "parallel_caps",
    .sentence = "Prisms of many corners meet cap on cap, parallel except in the last bits.",
    .hardness_meaning = "k: the larger prism has 2^k vertices",
    .levels = kParallelCapsLevels,
    .fill = fill_parallel_caps,
    .picture = {4, 4},
};

}  // namespace graze::corpus
