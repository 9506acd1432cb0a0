// long_arms: both bodies, on arms of 2^k, rotate as one or nearly so, and stand near each other. The
// difference of the two motions decides, and each motion is 2^k times as large as the bodies. Hardness: k.
//
// In the axes that turn with A, and with one rotation vector w for both, B moves by (R(wt)^-1 - 1) d, where d
// is the difference of the pivots. Only the part of d across w counts. With rotation vectors that differ by
// dw about one point, c away, it moves by about dw x c. So, a third of the cases each:
//   pivots   one w, a multiple of small integers, and pivots apart by nearly a multiple of it, or by nearly
//            nothing: they leave its direction by one or two units in the last place of 2^k,
//   axes     one pivot, to rounding, and axes that are parallel except for a unit in the last place or two. Half
//            have round bodies, one behind the other along w, where n x w comes out as 0,
//   speeds   one pivot, and rotation vectors that differ by 2^-j of 1/2^k, j drawn.
// B's motion relative to A is `swing`, at least 2^-34. The bodies start within half of it of each other, or
// up to a fifth of it deep. About a quarter are in contact at the start, and as many meet later.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"
#include "corpus/support_value.hpp"

namespace graze::corpus {
namespace {

Vec3<double> small_integers(Random& random, int most) {
  Vec3<double> out;
  do {
    for (int i = 0; i < 3; ++i) out[i] = random.integer(-most, most);
  } while (out == Vec3<double>::Zero());
  return out;
}

double length_of(const Vec3<double>& x) { return std::sqrt((x[0] * x[0] + x[1] * x[1]) + x[2] * x[2]); }

// angle times its direction, each product exact: 24 bits times a small integer.
Vec3<double> exactly_along(const Vec3<double>& integers, double angle) {
  const double unit = round_to_float(angle / length_of(integers));
  return {unit * integers[0], unit * integers[1], unit * integers[2]};
}

// Integers of 2 at most, across `along`.
Vec3<double> across(Random& random, const Vec3<double>& along) {
  for (;;) {
    Vec3<double> x = small_integers(random, 2);
    if ((x[0] * along[0] + x[1] * along[1]) + x[2] * along[2] == 0) return x;
    Vec3<double> cross(along[1] * x[2] - along[2] * x[1], along[2] * x[0] - along[0] * x[2],
                       along[0] * x[1] - along[1] * x[0]);
    if (cross != Vec3<double>::Zero()) return cross;
  }
}

// One or two coordinates to a neighbouring double, or farther, by `least`, where the neighbours are nearer.
void move_by_units(Random& random, Vec3<double>& x, double least) {
  for (int moved = random.integer(1, 2); moved > 0; --moved) {
    double& one = x[random.integer(0, 2)];
    const double way = random.once_in(2) ? 1 : -1, next = std::nextafter(one, way * kInfinity<double>);
    one = std::abs(next - one) < least ? one + way * least : next;
  }
}

// One above the other, along z: A's origin, B's is where the gap says, and `swing` times what was drawn
// apart.
void stack(Draw& draw, Case& problem, double swing) {
  const auto is_flat = [](const Capped& one) {
    const Bounds box = bounds(one.shape);
    return box.low[2] == box.high[2];
  };
  Capped below = draw.capped(4), above = draw.capped_below(4);
  // Two that are flat meet without a depth.
  while (is_flat(below) && is_flat(above)) below = draw.capped(4);
  problem.a.shape = below.shape;
  problem.b.shape = above.shape;
  problem.a.position = Vec3<double>(0, 0, 0 + (below.lift - above.lift));
  problem.b.position = Vec3<double>(0, 0, draw.real(swing * draw.random.uniform(-0.2, 0.5)));
}

// Round bodies, one behind the other along `along`.
void line_up(Draw& draw, Case& problem, const Vec3<double>& along, double swing) {
  Random& random = draw.random;
  double between = 0;
  for (Body<double>* body : {&problem.a, &problem.b}) {
    const double radius = draw.positive_on_grid(4);
    between += radius;
    switch (random.below(4)) {
      case 0:
        body->shape = Ellipsoid<double>{Vec3<double>(radius, radius, radius)};
        break;
      case 1:
        body->shape = rounded<double>(Point<double>{}, radius);
        break;
      default:
        body->shape = Sphere<double>{radius};
        break;
    }
  }
  const double far = (between + swing * random.uniform(-0.2, 0.5)) / length_of(along);
  problem.b.position = Vec3<double>(far * along[0], far * along[1], far * along[2]);
}

// Both pivots, given as points of the world. The bodies are not turned yet.
void set_pivots(Case& problem, const Vec3<double>& a, const Vec3<double>& b) {
  for (int i = 0; i < 3; ++i) {
    problem.spin_a.pivot[i] = a[i] - problem.a.position[i];
    problem.spin_b.pivot[i] = b[i] - problem.b.position[i];
  }
}

void pivots_apart(Draw& draw, double arm, double step, Case& problem) {
  Random& random = draw.random;
  stack(draw, problem, step);
  const Vec3<double> along = small_integers(random, random.once_in(4) ? 4 : 1);
  problem.spin_a.rotation = exactly_along(along, random.uniform(0.5, 8));
  problem.spin_b.rotation = problem.spin_a.rotation;
  // The pivots are beside the bodies, or out on an arm. They are apart along w by an arm, or not at all.
  Vec3<double> a = Vec3<double>::Zero();
  const bool far = random.once_in(2);
  if (far) {
    const Vec3<double> way = direction(draw);
    for (int i = 0; i < 3; ++i) a[i] = std::floor(arm * way[i]);
  }
  const double units = far && random.once_in(2) ? 0 : std::floor(arm * random.uniform(0.5, 1));
  Vec3<double> b;
  for (int i = 0; i < 3; ++i) b[i] = a[i] + units * along[i];
  move_by_units(random, b, 0x1p-34);
  set_pivots(problem, a, b);
}

void axes_apart(Draw& draw, double arm, double step, Case& problem) {
  Random& random = draw.random;
  const Vec3<double> along = small_integers(random, random.once_in(4) ? 4 : 1);
  problem.spin_a.rotation = exactly_along(along, random.uniform(0.5, 4));
  const Vec3<double> out = across(random, along);
  Vec3<double> c;
  for (int i = 0; i < 3; ++i) c[i] = std::floor(arm / length_of(out)) * out[i];
  problem.spin_b.rotation = problem.spin_a.rotation;
  if (random.once_in(2)) move_by_units(random, problem.spin_a.rotation, 0x1p-34 / arm);
  move_by_units(random, problem.spin_b.rotation, 0x1p-34 / arm);
  Vec3<double> difference;
  for (int i = 0; i < 3; ++i) difference[i] = problem.spin_b.rotation[i] - problem.spin_a.rotation[i];
  const double swing = std::max(length_of(difference) * arm, step);
  if (random.once_in(2)) {
    line_up(draw, problem, along, swing);
  } else {
    stack(draw, problem, swing);
  }
  set_pivots(problem, c, c);
}

void speeds_apart(Draw& draw, double arm, Case& problem) {
  Random& random = draw.random;
  const double swing = power_of_two(-random.integer(2, 24));
  stack(draw, problem, swing);
  const Vec3<double> way = direction(draw), axis = direction(draw);
  Vec3<double> c;
  for (int i = 0; i < 3; ++i) c[i] = std::floor(arm * way[i]);
  const double angle = random.uniform(0.5, 4);
  for (int i = 0; i < 3; ++i) {
    problem.spin_a.rotation[i] = angle * axis[i];
    problem.spin_b.rotation[i] = problem.spin_a.rotation[i] + swing / arm * random.uniform(-1, 1);
  }
  set_pivots(problem, c, c);
}

void fill_long_arms(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double arm = power_of_two(static_cast<int>(hardness));
  // A few units in the last place of a pivot's coordinate.
  const double step = std::max(0x1p-34, power_of_two(static_cast<int>(hardness) - 52));
  const auto manner = random.below(3);
  if (manner == 0) {
    pivots_apart(draw, arm, step, problem);
  } else if (manner == 1) {
    axes_apart(draw, arm, step, problem);
  } else {
    speeds_apart(draw, arm, problem);
  }
  set_motion(draw, problem, Vec3<double>::Zero());
  if (draw.coordinates == Coordinates::doubles && random.once_in(3)) {
    turn_rounded(draw, problem);
  } else {
    turn_exactly(draw, problem);
  }
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kLongArmsLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};

}  // namespace

const Family family::long_arms{
    .name = "long_arms",
    .sentence = "Both bodies, on arms far longer than they are, rotate as one except in the last digits.",
    .hardness_meaning = "k: the arms are about 2^k, for shapes of size 4",
    .levels = kLongArmsLevels,
    .fill = fill_long_arms,
    .rotating = true,
    .picture = {4, 1},
};

}  // namespace graze::corpus
