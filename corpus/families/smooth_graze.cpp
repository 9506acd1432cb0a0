// smooth_graze: round shapes that pass, each other or something flat, at a gap of 10^-k, or meet to a depth
// of it (or pass beneath, where C is thinner than that). Hardness: k.
//
// Frame and construction: pass_over in topped.hpp. C's top plane is z = 0, and so the gap is exact. This
// requires shapes whose extreme along z is a grid number:
//   - spheres,
//   - capsules, cylinders and cones standing, lying or turned by the angle of cosine 3/5 and sine 4/5, with
//     sizes that are multiples of 5,
//   - ellipsoids standing, or turned so, with radii for which the root of (4/5 r)^2 + (3/5 s)^2 is whole,
//   - rounded polytopes.
// The extreme point's other coordinates are rounded if they are not grid numbers (a turned ellipsoid). The
// path then passes the pole beside it by e < 2^-45, and the gap is off by e^2 over a radius.
//
// Difficulties:
//   - the support of a smooth shape never repeats, so a walk that waits for it to do so never ends,
//   - the bounds close by the square root: at a gap of g the contact point moves by sqrt(g),
//   - the distance from the smooth side of a flat top (a cylinder's) is decided by a face.
#include <algorithm>
#include <utility>

#include "corpus/families/families_list.hpp"
#include "corpus/families/topped.hpp"

namespace graze::corpus {
namespace {

constexpr double kSmoothReach = 4;                      // size of a shape (length)
constexpr Quaternion<double> kOnSide = {1, 1, 0, 0};    // the z-axis to -y: it lies
constexpr Quaternion<double> kLeaning = {2, 1, 0, 0};   // about x, cosine 3/5, sine 4/5: z to (0, -4/5, 3/5)
constexpr Quaternion<double> kHalfTurn = {0, 1, 0, 0};  // stands on its head

enum class Stance { standing, lying, leaning };

Stance stance(Draw& draw) { return static_cast<Stance>(draw.random.below(3)); }

// One in eight is as thin as the grid allows.
double extent(Draw& draw, double reach) {
  return draw.random.once_in(8) ? draw.grid_step() : draw.positive_on_grid(reach);
}

Topped capsule(Draw& draw) {
  const Stance how = stance(draw);
  const double reach = how == Stance::leaning ? kSmoothReach / 4 : kSmoothReach;
  const double r = extent(draw, reach), h = extent(draw, reach);
  switch (how) {
    case Stance::standing:
      return {Capsule<double>{r, h}, {}, {0, 0, 0 - (h + r)}};
    case Stance::lying:
      return {Capsule<double>{r, h}, kOnSide, {0, 0, -r}};
    default:
      return {Capsule<double>{r, 5 * h}, kLeaning, {0, 4 * h, 0 - (3 * h + r)}};
  }
}

Topped ellipsoid(Draw& draw) {
  const double x = extent(draw, kSmoothReach);
  if (draw.random.once_in(2)) {
    const double y = extent(draw, kSmoothReach), z = extent(draw, kSmoothReach);
    return {Ellipsoid<double>{Vec3<double>(x, y, z)}, {}, {0, 0, -z}};
  }
  // Leaning, z' = 4/5 y + 3/5 z: the height is the root of (4/5 r_y)^2 + (3/5 r_z)^2.
  constexpr double kWhole[][3] = {{10, 25, 17}, {25, 35, 29}, {45, 25, 39}, {30, 30, 30}};
  const double g = extent(draw, std::max(0.25, draw.grid_step()));
  const auto& [r_y, r_z, height] = kWhole[draw.random.below(std::size(kWhole))];
  // The top point in the body's frame is r_i^2 n_i / height.
  const double y = (r_y * r_y * 4) / (5 * height) * g, z = (r_z * r_z * 3) / (5 * height) * g;
  return {Ellipsoid<double>{Vec3<double>(x, r_y * g, r_z * g)},
          kLeaning,
          {0, 0 - (3 * y - 4 * z) / 5, -(height * g)}};
}

Topped cylinder(Draw& draw) {
  const Stance how = stance(draw);
  const double reach = how == Stance::leaning ? kSmoothReach / 4 : kSmoothReach;
  const double r = extent(draw, reach), h = extent(draw, reach);
  switch (how) {
    case Stance::standing:
      return {Cylinder<double>{r, h}, {}, {0, 0, -h}};
    case Stance::lying:
      return {Cylinder<double>{r, h}, kOnSide, {0, 0, -r}};
    default:
      // The rim's point (0, 5 r, 5 h) on top.
      return {Cylinder<double>{5 * r, 5 * h}, kLeaning, {0, 4 * h - 3 * r, 0 - (4 * r + 3 * h)}};
  }
}

Topped cone(Draw& draw) {
  const Stance how = stance(draw);
  const double reach = how == Stance::leaning ? kSmoothReach / 4 : kSmoothReach;
  const double r = extent(draw, reach), h = extent(draw, reach);
  switch (how) {
    case Stance::standing:
      if (draw.random.once_in(2)) return {Cone<double>{r, h}, {}, {0, 0, -h}};
      return {Cone<double>{r, h}, kHalfTurn, {0, 0, -h}};
    case Stance::lying:
      // The rim's point (0, r, -h) goes to (0, h, r).
      return {Cone<double>{r, h}, kOnSide, {0, -h, -r}};
    default: {
      // The apex at height 3 h, the rim's point (0, 5 r, -5 h) at 4 r - 3 h.
      const bool apex = 3 * h >= 4 * r - 3 * h;
      const Vec3<double> top =
          apex ? Vec3<double>(0, -4 * h, 3 * h) : Vec3<double>(0, 3 * r + 4 * h, 4 * r - 3 * h);
      return {Cone<double>{5 * r, 5 * h}, kLeaning, Vec3<double>::Zero() - top};
    }
  }
}

Topped smooth(Draw& draw) {
  switch (draw.random.below(6)) {
    case 0: {
      const double r = extent(draw, kSmoothReach);
      return {Sphere<double>{r}, {}, {0, 0, -r}};
    }
    case 1:
      return capsule(draw);
    case 2:
      return ellipsoid(draw);
    case 3:
      return cylinder(draw);
    case 4:
      return cone(draw);
    default: {
      Topped body = topped_any(draw, kSmoothReach);
      const double r = extent(draw, kSmoothReach);
      body.shape = rounded<double>(std::move(body.shape), r);
      body.position[2] -= r;
      return body;
    }
  }
}

void fill_smooth_graze(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double unit = power_of_ten(-static_cast<int>(hardness));
  const double size = draw.coordinates == Coordinates::floats ? round_to_float(unit) : unit;
  const double delta = random.once_in(2) ? size : -size;
  Topped a = smooth(draw), b = random.once_in(3) ? topped_any(draw, kSmoothReach) : smooth(draw);
  if (random.once_in(3)) turn_about_z(draw, a);
  if (random.once_in(3)) turn_about_z(draw, b);
  pass_over(draw, problem, a, b, Vec3<double>::Zero(), delta);
}

constexpr double kSmoothGrazeLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};

}  // namespace

const Family family::smooth_graze{
    .name = "smooth_graze",
    .sentence = "Round shapes that pass at a small gap, or meet to a small depth.",
    .hardness_meaning = "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4",
    .levels = kSmoothGrazeLevels,
    .fill = fill_smooth_graze,
    .picture = {4, 1},
};

}  // namespace graze::corpus
