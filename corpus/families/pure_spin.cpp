// pure_spin: no linear motion at all. A body meets the other by rotation alone, about an axis of its own or a
// distant axis. Hardness: k, the clearance is 2^-k, or the depth 2^-k at most.
//
// About an axis of its own, this is `spinning_graze` without the sliding, and with longer turns. With a
// distant axis, the body is the end of an arm. One vertex of it is at the distance `reach` from the axis, a
// rational (a Pythagorean triple), the others within reach (1 - 2^-5). The other body stands on the plane
// that is reach + delta away. The body is not turned at the start, so that position + pivot is exact, and the
// scene is turned by a rotation of the cube only. Clearance and depth are exact with every kind of
// coordinate. Difficulties: bounds from |v| alone, spheres about a pivot that is not within the body, steps
// that jump over a contact when nothing moves but an angle.
#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

// The end of an arm about the axis x through the pivot. In the frame of the pivot (y, z), except for
// `origin`.
struct Arm {
  Shape<double> shape;  // in its own frame: the pivot is at -origin
  Vec3<double> origin;
  Vec3<double> feature;
  double reach = 0;
};

Arm arm(Draw& draw) {
  constexpr int kTriples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}};
  Random& random = draw.random;
  const auto& triple = kTriples[random.below(std::size(kTriples))];
  const double unit = std::max(1.0, std::floor(random.uniform(1, 160) / triple[2]));
  double m = unit * triple[0], n = unit * triple[1];
  if (random.once_in(2)) std::swap(m, n);
  Arm out;
  out.reach = unit * triple[2];
  // Below the axis, or to its side and no higher than 0.96 of the reach (24 of 25): where it starts.
  const double along = draw.on_grid(4), side = random.once_in(2) ? m : -m;
  out.feature = Vec3<double>(along, side, random.once_in(4) ? n : -n);
  std::vector<Vec3<double>> list = {out.feature};
  const double within = out.reach * (1 - 0x1p-5), size = std::min(8.0, out.reach);
  const int vertices = random.integer(2, 10);
  while (static_cast<int>(list.size()) < vertices) {
    Vec3<double> x;
    for (int i = 0; i < 3; ++i) x[i] = out.feature[i] + draw.on_grid(size);
    if (x[1] * x[1] + x[2] * x[2] <= within * within) list.push_back(x);
  }
  // The body's own origin is somewhere near.
  for (int i = 0; i < 3; ++i) out.origin[i] = out.feature[i] + draw.on_grid(2);
  std::swap(list[0], list[random.below(list.size())]);
  for (Vec3<double>& x : list) {
    for (int i = 0; i < 3; ++i) x[i] = 0 + (x[i] - out.origin[i]);
  }
  if (vertices == 2) {
    out.shape = Segment<double>{list[0], list[1]};
  } else if (vertices == 3) {
    out.shape = Triangle<double>{list[0], list[1], list[2]};
  } else {
    out.shape = Hull<double>(std::span<const Vec3<double>>(list));
  }
  return out;
}

void swing_past(Draw& draw, Case& problem, double delta) {
  Random& random = draw.random;
  const Arm turning = arm(draw);
  const bool wide = random.once_in(2);
  const double height = draw.positive_on_grid(4);
  const Capped above =
      wide ? Capped{Box<double>{Vec3<double>(32, 32, height)}, height} : draw.capped_below(4);
  problem.a.shape = turning.shape;
  problem.b.shape = above.shape;
  // Except for the lift, the pivot is on the axis x through (0, 0, -reach), and the plane above is z = delta.
  // B's own coordinate is exactly delta, however small, and A's, on the grid, takes the lift.
  problem.a.position = Vec3<double>(0 + (turning.origin[0] - turning.feature[0]), turning.origin[1],
                                    turning.origin[2] - (turning.reach + above.lift));
  problem.b.position = Vec3<double>(0, 0, delta);
  for (int i = 0; i < 3; ++i) problem.spin_a.pivot[i] = 0 - turning.origin[i];
  // By way of the side that it is on, past the top, and maybe round again.
  const double angle = draw.real(random.once_in(4) ? random.uniform(6.3, 40) : random.uniform(3.2, 6.2));
  problem.spin_a.rotation = Vec3<double>(turning.feature[1] >= 0 ? angle : -angle, 0, 0);
  // A turn about the normal through the lowest feature moves no height.
  if (random.once_in(3)) problem.spin_b.rotation = Vec3<double>(0, 0, draw.real(random.uniform(-4, 4)));
  if (random.once_in(6)) {
    problem.t_max = 0.5;  // the same turn in half the time
    for (Spin* spin : {&problem.spin_a, &problem.spin_b}) spin->rotation = 2 * spin->rotation;
  }
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

void fill_pure_spin(Draw& draw, double hardness, Case& problem) {
  const double size = power_of_two(-static_cast<int>(hardness));
  const double delta = draw.random.once_in(2) ? size : -size;
  if (draw.random.once_in(2)) {
    swing_past(draw, problem, delta);
    return;
  }
  spin_past(draw, problem, delta, 3.7, draw.random.once_in(4) ? 40 : 9);
  // A body that slides there moves along the plane, and so does a common motion of both. The clearance is the
  // same without that motion.
  problem.a.displacement = Vec3<double>::Zero();
  problem.b.displacement = Vec3<double>::Zero();
}

constexpr double kPureSpinLevels[] = {4, 8, 12, 16, 20, 24, 28, 32, 36, 40};

}  // namespace

const Family family::pure_spin{
    .name = "pure_spin",
    .sentence = "No linear motion: a body meets the other by rotation alone.",
    .hardness_meaning = "k: the clearance is 2^-k, or the depth at most that, for an arm of 5 to 160",
    .levels = kPureSpinLevels,
    .fill = fill_pure_spin,
    .rotating = true,
    .picture = {12, 4},
};

}  // namespace graze::corpus
