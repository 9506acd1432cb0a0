// ray_ties: a point that meets an ellipsoid, a cylinder or a cone at a point with integer coordinates, where it passes on a
// tangent, enters, leaves or rests. Rims, the apex and the start are among these. Hardness: minus the number of units in
// the last place by which a radius is then changed, either way. 0 is the tie.
//
// The scene is rotated by an integer quaternion q, with every length times |q|^2: the tie stays exact. Contact is at the
// start, on the path, or at t_max, which may be the double before it.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

// A point of the surface, and a normal there. Lengths before they are multiplied.
struct Touch {
  Shape<double> shape;
  Vec3<double> at, normal;
};

// Pythagorean: x^2 + y^2 = 25.
Vec3<double> draw_level(Random& random) {
  constexpr double kLevel[][2] = {{3, 4}, {4, 3}, {5, 0}, {0, 5}};
  const auto& xy = kLevel[random.below(std::size(kLevel))];
  return {random.once_in(2) ? xy[0] : 0 - xy[0], random.once_in(2) ? xy[1] : 0 - xy[1], 0};
}

Touch draw_ellipsoid(Random& random, double length) {
  constexpr double kUnits[][4] = {{0, 0, 1, 1}, {3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}};
  const auto& unit = kUnits[random.below(std::size(kUnits))];
  const int first = random.integer(0, 2);
  Vec3<double> stretch, n;
  for (int i = 0; i < 3; ++i) {
    stretch[i] = random.integer(1, 4);
    n[i] = (random.once_in(2) ? 1 : -1) * unit[(first + i) % 3];
  }
  Touch out;
  out.shape = Ellipsoid<double>{stretch * unit[3] * length};
  for (int i = 0; i < 3; ++i) {
    out.at[i] = stretch[i] * n[i];
    out.normal[i] = n[i] * stretch[(i + 1) % 3] * stretch[(i + 2) % 3];
  }
  return out;
}
// On the side, a rim, or a plane face.
Touch draw_cylinder(Random& random, double length) {
  const int half = random.integer(0, 4), size = random.integer(1, 2);
  Touch out;
  out.shape = Cylinder<double>{5.0 * size * length, half * length};
  const Vec3<double> level = draw_level(random);
  out.at = size * level;
  out.at[2] = random.once_in(3) ? half : random.integer(-half, half);
  out.normal = level;
  if (random.once_in(3)) {
    out.at = Vec3<double>(random.integer(-3, 3), random.integer(-3, 3), half);
    out.normal = {0, 0, 1};
  }
  return out;
}
// On the side, the rim, or the apex, at which a normal may be any from the side's to the axis.
Touch draw_cone(Random& random, double length) {
  const double half = std::scalbn(1.0, random.integer(0, 2)), radius = 20;
  const int quarters = random.integer(0, 4);
  Touch out;
  out.shape = Cone<double>{radius * length, half * length};
  const Vec3<double> level = draw_level(random);
  out.at = (4 - quarters) * level;
  out.at[2] = half * (quarters - 2) / 2;
  // The side's slope: 20 across for 2 half up, and 5 across in `level`.
  out.normal = half * level;
  out.normal[2] = 5 * radius / 2 * (quarters == 4 ? random.integer(1, 3) : 1);
  return out;
}

void fill_ray_ties(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const Quaternion<double> q = random.once_in(2) ? draw.turned_pose() : Quaternion<double>{};
  const double length = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  Touch touch = random.once_in(3)   ? draw_ellipsoid(random, length)
                : random.once_in(2) ? draw_cylinder(random, length)
                                    : draw_cone(random, length);
  const double unit = draw.coordinates == Coordinates::floats ? 0x1p-23 : 0x1p-52;
  const auto change = [&](double& radius) {
    radius += (random.once_in(2) ? hardness : 0 - hardness) * unit * std::scalbn(1.0, std::ilogb(radius));
  };
  std::visit(
      [&]<class T>(T& shape) {
        if constexpr (requires { shape.radii; }) {
          change(shape.radii[random.integer(0, 2)]);
        } else if constexpr (requires { shape.half_height; }) {
          change(shape.radius);
        }
      },
      touch.shape);

  const auto [v, t0] = draw_passage(random, touch.normal);
  Vec3<double> at;
  for (int i = 0; i < 3; ++i) at[i] = random.integer(-8, 8);
  problem.a.shape = touch.shape;
  problem.a.orientation = q;
  problem.a.position = rotate_scaled(q, at);
  problem.b.shape = Point<double>{};
  problem.b.position = rotate_scaled(q, at + touch.at - t0 * v);
  set_motion(draw, problem, rotate_scaled(q, v));
  if (t0 > 0 && random.once_in(4)) problem.t_max = random.once_in(2) ? t0 : std::nextafter(t0, 0.0);
  if (random.once_in(4)) problem.start_policy = StartPolicy::pass_over;
  maybe_swap(draw, problem);
}

constexpr double kRayTieLevels[] = {-1024, -64, -8, -2, -1, 0};

}  // namespace

const Family family::ray_ties{
    .name = "ray_ties",
    .sentence = "A ray that touches an ellipsoid, a cylinder or a cone, to the last bit or not.",
    .hardness_meaning =
        "-n: a radius is n units in the last place (2^-23 or 2^-52 of it) too large or small; 0 touches",
    .levels = kRayTieLevels,
    .fill = fill_ray_ties,
    .picture = {0, 47},
};

}  // namespace graze::corpus
