// resting_turns: bodies that start in contact and rotate, with the start policy pass_over. Hardness: k, the part of the
// rotation that lies in the plane of contact is 10^-k of it (k > 16: none).
//
// A body stands on another (standing.hpp) or touches it as in `sliding`, on the plane z = 0 of the grid, so
// that the contact is exact. It moves in one of four ways:
//   - it spins about the plane's normal and slides, with a tilt,
//   - it tips about a point or an edge of the contact,
//   - it lifts, and may land again,
//   - it swings about a pivot somewhere.
//
// This breaks methods that always report, or always ignore, a start in contact. Steps are as short as the
// rounding where a body tips about an edge that stays. A wobble of the normal makes a contact deeper by no
// more than rounding.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

constexpr int kLastPart = 16;

void stand_on_a_box(Draw& draw, Case& problem) {
  Topped above = standing(draw, 4);
  while (std::holds_alternative<Point<double>>(above.shape)) above = standing(draw, 4);
  const double size = draw.random.once_in(2) ? 32 : 1 + draw.positive_on_grid(8),
               thickness = draw.positive_on_grid(2);
  problem.a.shape = Box<double>{Vec3<double>(size, size, thickness)};
  problem.a.position = Vec3<double>(0, 0, -thickness);
  problem.b = {.shape = above.shape, .position = above.position, .orientation = above.orientation};
  if (draw.random.once_in(3)) problem.b.orientation = multiply(draw.pose_about_z(), problem.b.orientation);
  for (int i = 0; i < 2; ++i) problem.b.position[i] += draw.on_grid(1);
}

// Gives the height of the plane.
double touch(Draw& draw, Case& problem) {
  const Capped a = draw.capped(4), b = draw.capped_below(4);
  problem.a.shape = a.shape;
  problem.b.shape = b.shape;
  problem.a.position = Vec3<double>(0, 0, a.lift - b.lift);
  return 0 - b.lift;
}

void fill_resting_turns(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const bool stands = !random.once_in(3);
  double plane = 0;
  if (stands) {
    stand_on_a_box(draw, problem);
  } else {
    plane = touch(draw, problem);
  }
  // A point of the contact below the body's origin, in its own frame. It is for bodies without an
  // orientation.
  const bool is_plain = problem.b.orientation.is_identity();
  const Vec3<double> foot(0, 0, plane - problem.b.position[2]);

  const int k = static_cast<int>(hardness);
  const double angle = random.once_in(3) ? random.uniform(-0.05, 0.05) : random.uniform(-4, 4);
  const double part = k > kLastPart ? 0 : power_of_ten(-k);
  const Vec3<double> along = Vec3<double>(part * random.uniform(-1, 1), part * random.uniform(-1, 1), 1);
  Vec3<double> v(draw.on_grid(4), draw.on_grid(4), 0);
  Vec3<double> w = angle * along;
  const auto manner = random.below(8);
  if (manner == 4 || manner == 5) {
    // Tips about a point of the plane, or about an axis through it.
    v = Vec3<double>::Zero();
    w = random.once_in(2) ? Vec3<double>(angle, angle * along[0], 0)
                          : Vec3<double>(angle * along[1], angle, 0);
    if (is_plain) problem.spin_b.pivot = foot;
    for (int i = 0; i < 2 && is_plain; ++i) {
      if (random.once_in(2)) problem.spin_b.pivot[i] += draw.on_grid(2);
    }
  } else if (manner == 6) {
    v[2] = draw.real(random.uniform(0, 8));  // lifts
    w = angle * direction(draw);
  } else if (manner == 7) {
    v[2] = random.once_in(2) ? 0.0 : draw.on_grid(2);
    w = angle * direction(draw);
    for (int i = 0; i < 3; ++i) problem.spin_b.pivot[i] = draw.on_grid(4);
  } else if (random.once_in(3)) {
    for (int i = 0; i < 3; ++i) problem.spin_b.pivot[i] = draw.on_grid(2);
  }
  for (int i = 0; i < 3; ++i) problem.spin_b.rotation[i] = draw.real(w[i]);
  if (random.once_in(4)) problem.spin_a.rotation = Vec3<double>(0, 0, draw.real(random.uniform(-2, 2)));
  problem.start_policy = StartPolicy::pass_over;
  set_motion(draw, problem, v);
  turn_exactly(draw, problem);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kRestingTurnsLevels[] = {0, 2, 4, 6, 8, 10, 12, 14, 16, 17};

}  // namespace

const Family family::resting_turns{
    .name = "resting_turns",
    .sentence =
        "Bodies that start in contact and rotate: they spin on it, tip about it, lift off it and land.",
    .hardness_meaning =
        "k: the part of the rotation in the plane of contact is 10^-k of it; 17 has no such part",
    .levels = kRestingTurnsLevels,
    .fill = fill_resting_turns,
    .rotating = true,
    .picture = {17, 1},
};

}  // namespace graze::corpus
