// smooth_depths: smooth bodies in each other, shallow to concentric, discs among them: a lens in a ring, a cone on
// a cone, a hull in an ellipsoid. Hardness: k, they are 10^-k of a size of 4, and of a radian, from symmetric.
//
// One body is a capsule, an ellipsoid, a cylinder or a cone. The other is one of these, a ball, a box, a
// hull, its copy, or a smaller copy. A half height or a radius of an ellipsoid may be 0, which leaves a disc
// without inside. They are concentric, on one axis, beside each other along it or across, or anywhere. They
// are turned by quarter turns, and anyhow.
//
// This breaks a local minimum of the depth that is taken for the least, and a bound by a ball that is not in
// the body. At some points a whole disc is equally near.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"
#include "corpus/support_value.hpp"

namespace graze::corpus {
namespace {

constexpr double kReach = 4;
constexpr int kLastOffset = 16;

// Kinds from `first` on. The last four are smooth and not a ball.
Shape<double> draw_shape(Draw& draw, int first) {
  Random& random = draw.random;
  const double radius = draw.positive_on_grid(kReach), other = draw.positive_on_grid(kReach);
  const double height = random.once_in(5) ? 0 : draw.positive_on_grid(kReach);
  switch (random.integer(first, 6)) {
    case 0:
      return Sphere<double>{radius};
    case 1:
      return Box<double>{Vec3<double>(radius, other, height)};
    case 2:
      return draw.hull(kReach, random.integer(4, 8));
    case 3:
      return Capsule<double>{radius, height};
    case 4: {
      // Three radii, two that are equal, or all.
      const double second = random.once_in(3) ? radius : other;
      return Ellipsoid<double>{Vec3<double>(radius, second, random.once_in(4) ? radius : height)};
    }
    case 5:
      return Cylinder<double>{radius, height};
    default:
      return Cone<double>{radius, height};
  }
}
constexpr int kAnyShape = 0, kSmoothShape = 3;

// Turns the body by up to 3 off about each axis, beside what it is turned by already.
void tilt(Draw& draw, Body<double>& body, double off) {
  Random& random = draw.random;
  const double x = off * random.integer(-3, 3), y = off * random.integer(-3, 3);
  const Quaternion<double> turned =
      multiply(Quaternion<double>{1, x, y, off * random.integer(-3, 3)}, body.orientation);
  body.orientation = {draw.real(turned.w), draw.real(turned.x), draw.real(turned.y), draw.real(turned.z)};
}

void fill_smooth_depths(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int k = static_cast<int>(hardness);
  const double off = k > kLastOffset ? 0 : draw.real(power_of_ten(-k));
  problem.a.shape = draw_shape(draw, kSmoothShape);
  switch (random.below(8)) {
    case 0:
      problem.b.shape = problem.a.shape;
      break;
    case 1:
      problem.b.shape = stretched(problem.a.shape, std::scalbn(1.0, -random.integer(1, 4)));
      break;
    default:
      problem.b.shape = draw_shape(draw, kAnyShape);
      break;
  }
  problem.b.orientation = random.once_in(2) ? draw.cube_rotation() : draw.pose();
  if (random.once_in(3)) tilt(draw, problem.b, off);

  Vec3<double> meeting;
  for (int i = 0; i < 3; ++i) meeting[i] = 0 + kReach * off * random.integer(-1, 1);
  const int axis = random.once_in(3) ? random.integer(0, 1) : 2;
  switch (random.below(5)) {
    case 0:
    case 1:
      break;
    case 2:
      meeting[axis] = draw.on_grid(kReach);
      break;
    case 3: {
      // Beside each other: along the axis as deep as 4 units, or much less.
      const double deep = kReach * power_of_ten(-random.integer(0, 12));
      const double low = bounds(problem.b.shape, problem.b.orientation).low[axis];
      meeting[axis] = (bounds(problem.a.shape).high[axis] - low) - deep;
      break;
    }
    default:
      meeting = draw.vector(kReach / 2);
      break;
  }
  // The body starts there and may stay, comes to it at a half, has left it, or never comes.
  double speed = 32, t0 = 0;
  switch (random.below(8)) {
    case 0:
    case 1:
      t0 = 0.5;
      break;
    case 2:
      t0 = -0.5;
      break;
    case 3:
      meeting[1] += 4 * kReach;
      break;
    default:
      if (random.once_in(2)) speed = 0;
      break;
  }
  Vec3<double> v = Vec3<double>::Zero();
  v[random.once_in(2) ? 2 : 0] = random.once_in(2) ? speed : 0 - speed;
  for (int i = 0; i < 3; ++i) problem.b.position[i] = draw.real(0 + (meeting[i] - t0 * v[i]));
  set_motion(draw, problem, v);
  if (random.once_in(4)) problem.start_policy = StartPolicy::pass_over;
  vary_time_scale(draw, problem);
  // Most are turned by rotations whose axes round: what is parallel is so up to rounding.
  if (draw.coordinates == Coordinates::doubles || random.once_in(2)) {
    turn_rounded(draw, problem);
  } else {
    turn_exactly(draw, problem);
  }
  maybe_swap(draw, problem);
}

constexpr double kSmoothDepthLevels[] = {1, 2, 4, 6, 8, 10, 12, 14, 16, 17};  // 17: symmetric

}  // namespace

const Family family::smooth_depths{
    .name = "smooth_depths",
    .sentence = "Smooth bodies in each other, shallow to concentric, discs among them: how deep?",
    .hardness_meaning = "k: they are 10^-k of a size of 4, and of a radian, from symmetric; 17 is symmetric",
    .levels = kSmoothDepthLevels,
    .fill = fill_smooth_depths,
    .picture = {1, 5},
};

}  // namespace graze::corpus
