// at_rest: a body stands exactly on another, or comes to it by a path on which it just touches. Hardness: -n,
// an extent of one body is n units in its last place too large or too small. At 0 the bodies touch.
//
// The bodies are placed on the plane z = 0, on the grid. The scene is then turned by an integer quaternion q
// with every length times |q|^2 (standing.hpp). Contact at rest is therefore a tie that is exact in doubles,
// although the entries of the rotation matrices are not doubles. The body rests, slides, leaves, is pushed
// in, falls so far that it arrives when the step ends, or slides in from the side at exactly that height.
//
// This breaks a proof of contact by a point that must lie in both bodies, and a proof of separation by a
// plane that must lie between them. It also breaks a tie that some other tolerance decides.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"

namespace graze::corpus {
namespace {

constexpr double kRestReach = 4;  // size of a body (length)

// Its top is z = 0: a box, a triangle, the face of a hull, or another standing body, upside down.
Topped ground(Draw& draw) {
  Random& random = draw.random;
  const double size = kRestReach + draw.positive_on_grid(2 * kRestReach),
               height = draw.positive_on_grid(kRestReach);
  switch (random.below(6)) {
    case 0:
    case 1:
    case 2:
      return {Box<double>{Vec3<double>(size, size + height, height)}, {}, Vec3<double>(0, 0, -height)};
    case 3:
      return {Triangle<double>{Vec3<double>(-size, -size, 0), Vec3<double>(2 * size, -size, 0),
                               Vec3<double>(-size, 2 * size, 0)},
              {}};
    case 4: {
      std::vector<Vec3<double>> top = {Vec3<double>(-size, -size, 0), Vec3<double>(size, -size, 0),
                                       Vec3<double>(size, size, 0), Vec3<double>(-size, size, 0)};
      return {hull_under(draw, std::move(top), size, Vec3<double>::Zero()), {}};
    }
    default:
      return mirrored(standing(draw, kRestReach));
  }
}

// Changes every extent by that many units in its last place. A shape without extents changes its place.
void change_extents(Draw& draw, Body<double>& body, int units) {
  const auto changed = [&](double x) { return moved_by_units(draw, x, units); };
  const auto change = [&](double& x) { x = changed(x); };
  const auto place = [&] {
    double& x = body.position[draw.random.integer(0, 2)];
    x = x == 0 ? std::scalbn(static_cast<double>(units), -52) : changed(x);
  };
  if (auto* sphere = std::get_if<Sphere<double>>(&body.shape)) {
    change(sphere->radius);
  } else if (auto* round = std::get_if<Rounded<double>>(&body.shape)) {
    change(round->radius);
  } else if (auto* box = std::get_if<Box<double>>(&body.shape)) {
    for (int i = 0; i < 3; ++i) change(box->half_extents[i]);
  } else if (auto* ellipsoid = std::get_if<Ellipsoid<double>>(&body.shape)) {
    for (int i = 0; i < 3; ++i) change(ellipsoid->radii[i]);
  } else if (auto* capsule = std::get_if<Capsule<double>>(&body.shape)) {
    change(capsule->radius);
  } else if (auto* cylinder = std::get_if<Cylinder<double>>(&body.shape)) {
    change(cylinder->radius);
    change(cylinder->half_height);
  } else if (auto* cone = std::get_if<Cone<double>>(&body.shape)) {
    change(cone->radius);
    change(cone->half_height);
  } else {
    place();
  }
}

void fill_at_rest(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const Topped below = ground(draw), above = standing(draw, kRestReach);
  problem.a = {.shape = below.shape, .position = below.position, .orientation = below.orientation};
  problem.b = {.shape = above.shape, .position = above.position, .orientation = above.orientation};
  // If the point of contact is on the body's z-axis, a turn about z leaves it where it is.
  if (above.position[0] == 0 && above.position[1] == 0 && random.once_in(2))
    problem.b.orientation = multiply(draw.pose_about_z(), problem.b.orientation);
  // Anywhere on a face that is large enough. On a round body, at its top.
  const auto* box = std::get_if<Box<double>>(&below.shape);
  if (box && below.orientation.is_identity() && box->half_extents.head<2>().minCoeff() >= kRestReach) {
    for (int i = 0; i < 2; ++i) problem.b.position[i] += draw.on_grid(kRestReach);
  }

  Vec3<double> v(draw.on_grid(8), 0, 0);
  v[1] = draw.on_grid(8);
  const double speed = 8 + draw.positive_on_grid(8);
  const auto manner = random.below(10);
  if (manner == 0) {
    v = Vec3<double>::Zero();  // rests
  } else if (manner < 3) {
    // slides
  } else if (manner == 3) {
    v[2] = speed;  // leaves
  } else if (manner < 6) {
    v[2] = -speed;  // is pushed in
  } else if (manner == 6) {
    // Falls, and arrives when the step ends.
    v = Vec3<double>(0, 0, -speed);
    problem.b.position[2] += speed;
  } else {
    // In from beside at half of the step, from farther away than the bodies are wide.
    const double far = std::floor(reach_of(below) + reach_of(above)) + 8;
    v = random.once_in(2) ? Vec3<double>(far, v[1], 0) : Vec3<double>(v[0], -far, 0);
    v = 4 * v;
    problem.b.position -= 0.5 * v;
  }
  if (manner < 6 && random.once_in(2)) problem.start_policy = StartPolicy::pass_over;
  set_motion(draw, problem, v);
  vary_time_scale(draw, problem);
  if (manner != 6 && random.once_in(16)) problem.t_max = kInfinity<double>;
  if (!random.once_in(4)) turn_stretched(draw, problem);
  const int units = static_cast<int>(hardness);
  change_extents(draw, random.once_in(4) ? problem.a : problem.b, random.once_in(2) ? units : -units);
  maybe_swap(draw, problem);
}

constexpr double kAtRestLevels[] = {-1024, -16, -4, -2, -1, 0};

}  // namespace

const Family family::at_rest{
    .name = "at_rest",
    .sentence =
        "Bodies at rest on each other, by construction: the contact is a tie that is exact in doubles.",
    .hardness_meaning = "-n: an extent is n units in its last place too large or too small; 0 touches",
    .levels = kAtRestLevels,
    .fill = fill_at_rest,
    .picture = {0, 3},
};

}  // namespace graze::corpus
