#include "properties/generate/far.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <vector>

#include "corpus/families/far_own_frame.hpp"
#include "corpus/families/turning.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;
using corpus::Spin;

namespace {

// From the origin to `tip` on the axis x. It is a segment, or so thin there that the ball about it is no larger: its
// thickness is the root of a unit in the last place of 2^exponent.
Shape<double> rod(Random& random, double tip, int exponent) {
  const Vec3<double> end(tip, 0, 0);
  const double thick = std::scalbn(1.0, (exponent - 56) / 2);
  switch (random.below(4)) {
    case 0:
      return Triangle<double>{Vec3<double>::Zero(), end, Vec3<double>(0, thick, 0)};
    case 1: {
      const std::vector<Vec3<double>> corners = {end, Vec3<double>(0, thick, thick),
                                                 Vec3<double>(0, -thick, thick), Vec3<double>(0, 0, -thick)};
      return Hull<double>(std::span<const Vec3<double>>(corners));
    }
    case 2:
      return sum<double>(Segment<double>{Vec3<double>::Zero(), end}, Point<double>{});
    default:
      return Segment<double>{Vec3<double>::Zero(), end};
  }
}

// A unit in the last place of 2^exponent at most, in eighths.
double part_of_a_unit(Random& random, int exponent) {
  return std::scalbn(random.integer(-4, 8), exponent - 52 - 3);
}

// One or two coordinates to a neighbouring double.
void move_by_a_unit(Random& random, Vec3<double>& x) {
  for (int moved = random.integer(1, 2); moved > 0; --moved) {
    double& one = x[random.integer(0, 2)];
    if (one != 0) one = std::nextafter(one, random.once_in(2) ? kInfinity<double> : -kInfinity<double>);
  }
}

void add_integers(Random& random, Vec3<double>& x, int most) {
  for (int i = 0; i < 3; ++i) x[i] += random.integer(-most, most);
}

// An axis of small integers.
Vec3<double> some_axis(Random& random) {
  Vec3<double> axis = Vec3<double>::Zero();
  while (axis.isZero(0)) add_integers(random, axis, random.once_in(4) ? 3 : 1);
  return axis;
}

// Above the plane z = 0 and below it.
void stack(Random& random, Case& problem, double gap) {
  for (const bool above : {false, true}) {
    Body<double>& body = above ? problem.b : problem.a;
    const double height = random.integer(1, 4) / 2.0;
    switch (random.below(3)) {
      case 0:
        body.shape = Sphere<double>{height};
        break;
      case 1:
        body.shape = Segment<double>{Vec3<double>(0, 0, -height), Vec3<double>(0, 0, height)};
        break;
      default:
        body.shape = Box<double>{Vec3<double>(random.integer(1, 2), 1, height)};
        break;
    }
    // B's number is the gap and its height. The part of the gap that rounds away is lost.
    body.position = Vec3<double>(0, 0, above ? gap + height : -height);
  }
}

// Balls, one behind the other along the axis.
void line_up(Random& random, Case& problem, const Vec3<double>& axis, double gap) {
  const double a = random.integer(1, 4) / 2.0, b = random.integer(1, 4) / 2.0;
  problem.a.shape = Sphere<double>{a};
  problem.b.shape = random.once_in(2) ? Shape<double>(Sphere<double>{b})
                                      : Shape<double>(Ellipsoid<double>{Vec3<double>(b, b, b)});
  problem.a.position = Vec3<double>::Zero();
  problem.b.position = (a + b + gap) / axis.norm() * axis;
}

}  // namespace

void place_far_rods(Random& random, Case& problem, double t) {
  const int exponent = random.integer(10, 50);
  const double length_a = random.integer(1, 4), length_b = random.integer(1, 4);
  for (Body<double>* body : {&problem.a, &problem.b}) *body = Body<double>{};
  problem.spin_a = problem.spin_b = Spin{};
  problem.a.shape = rod(random, length_a, exponent);
  problem.b.shape = rod(random, -length_b, exponent);
  problem.b.position[0] = length_a + length_b;
  Quaternion<double> turn;
  turn.w = random.integer(1, 3);
  turn.z = random.integer(1, 3);
  if (t > 0) {
    problem.a.orientation = {turn.w, 0, 0, -turn.z};
    problem.spin_a.rotation = corpus::rotation_vector(turn, 0) / t;
  } else {
    problem.spin_a.rotation[2] = random.once_in(2) ? 1 : 0x1p-10;
  }
  const auto out = [&] {
    Vec3<double> offset = Vec3<double>::Zero();
    offset[0] = std::scalbn(random.uniform(1, 2), exponent - 1);
    if (random.once_in(2)) offset[0] = -offset[0];
    return offset;
  };
  if (random.once_in(3)) corpus::push_out(problem.a, problem.spin_a, out());
  corpus::push_out(problem.b, problem.spin_b, out());
  if (random.once_in(2)) problem.spin_b.pivot.setZero();  // it does not turn
  problem.a.position[0] -= part_of_a_unit(random, exponent);
}

void place_far_arms(Random& random, Case& problem) {
  const int exponent = random.integer(8, 40);
  const double arm = std::floor(std::scalbn(random.uniform(1, 2), exponent - 1));
  for (Body<double>* body : {&problem.a, &problem.b}) body->orientation = {};
  problem.b.displacement = problem.a.displacement;
  Vec3<double> axis = some_axis(random);
  const bool apart = random.once_in(2);
  // Pivots a unit off such an axis swing along z, in the direction of stacking. Products in doubles round to
  // as much as for pivots on it.
  if (apart && random.once_in(2)) axis = Vec3<double>(1, random.once_in(2) ? 1 : -1, 0);
  // Exact multiples: 2^-3 and 2^-2 of integers.
  problem.spin_a.rotation = problem.spin_b.rotation = random.integer(1, 12) / 4.0 * axis;
  if (apart || random.once_in(2)) {
    stack(random, problem, part_of_a_unit(random, exponent));
  } else {
    line_up(random, problem, axis, part_of_a_unit(random, exponent));
  }
  Vec3<double> a = Vec3<double>::Zero(), b = Vec3<double>::Zero();
  if (apart) {
    // Pivots apart along the axis, within a unit in the last place or two.
    b = arm * axis;
    move_by_a_unit(random, b);
  } else {
    // One pivot, across the axis, and rotation vectors that differ by a unit in the last place or two.
    Vec3<double> across;
    do {
      across = axis.cross(some_axis(random));
    } while (across.isZero(0));
    a = b = arm * across;
    if (random.once_in(2)) move_by_a_unit(random, problem.spin_a.rotation);
    move_by_a_unit(random, problem.spin_b.rotation);
  }
  problem.spin_a.pivot = a - problem.a.position;
  problem.spin_b.pivot = b - problem.b.position;
}

}  // namespace graze::law
