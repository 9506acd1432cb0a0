// falling, sliding, rolling, stacking: bodies on a floor of level tiles, boxes or pairs of triangles.
#include <algorithm>
#include <cmath>

#include "corpus/families/standing.hpp"
#include "corpus/workloads/scenes.hpp"
#include "corpus/workloads/workloads_list.hpp"

namespace graze::corpus {
namespace {

constexpr int kFloorGroup = 1;
constexpr double kTile = 2;  // its side (metres)

double some(Draw& draw, double low, double high) { return draw.real(draw.random.uniform(low, high)); }

// Three by three tiles about the origin, their top at z = 0: boxes, or squares of two triangles each.
void add_floor(Simulation& world) {
  Draw& draw = world.draw();
  const bool triangles = draw.random.once_in(3);
  const double half = kTile / 2, thick = 0.5;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      Member tile{.group = kFloorGroup};
      tile.position = Vec3<double>(kTile * x, kTile * y, triangles ? 0 : -thick);
      if (!triangles) {
        tile.shape = Box<double>{Vec3<double>(half, half, thick)};
        world.members.push_back(tile);
        continue;
      }
      for (const double side : {1.0, -1.0}) {
        const double h = side * half;
        tile.shape =
            Triangle<double>{Vec3<double>(-h, -h, 0), Vec3<double>(h, -h, 0), Vec3<double>(-h, h, 0)};
        world.members.push_back(tile);
      }
    }
  }
}

Shape<double> loose_shape(Draw& draw) {
  Random& random = draw.random;
  const double a = some(draw, 0.1, 0.5), b = some(draw, 0.1, 0.5), c = some(draw, 0.1, 0.5);
  switch (random.below(6)) {
    case 0:
      return Cylinder<double>{a, b};
    case 1:
      return Capsule<double>{a / 2, b};
    case 2: {
      std::vector<Vec3<double>> list;
      for (int i = random.integer(8, 24); i > 0; --i) {
        Vec3<double> x;
        for (int k = 0; k < 3; ++k) x[k] = some(draw, -0.4, 0.4);
        list.push_back(x);
      }
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
    case 3:
      return Sphere<double>{a};
    default:
      return Box<double>{Vec3<double>(a, b, c)};
  }
}

Vec3<double> some_vector(Draw& draw, double reach) {
  Vec3<double> x;
  for (int k = 0; k < 3; ++k) x[k] = some(draw, -reach, reach);
  return x;
}

struct Falling final : Scene {
  void set_up(Simulation& world) override {
    Draw& draw = world.draw();
    add_floor(world);
    for (int i = 0; i < 3; ++i) {
      Member body{.shape = loose_shape(draw), .orientation = draw.pose(), .moves = true, .falls = true};
      body.position = some_vector(draw, 2);
      body.position[2] = some(draw, 0.75, 2);
      body.velocity = some_vector(draw, 3);
      body.spin = some_vector(draw, 8);
      world.members.push_back(body);
    }
  }
};

// Bodies that keep their height and turn about z only, at a skin above the floor. Friction slows them.
struct Sliding final : Scene {
  void set_up(Simulation& world) override {
    Draw& draw = world.draw();
    Random& random = draw.random;
    add_floor(world);
    for (int i = 0; i < 2; ++i) {
      Member body{.moves = true};
      const double half_height = some(draw, 0.1, 0.5), size = some(draw, 0.1, 0.5);
      double lift = half_height;
      switch (random.below(4)) {
        case 0:
          body.shape = Cylinder<double>{size, half_height};
          break;
        case 1:
          body.shape = rounded<double>(Box<double>{Vec3<double>(size, size, half_height)}, 0.0625);
          lift = draw.real(half_height + 0.0625);
          break;
        case 2: {
          std::vector<Vec3<double>> list;
          for (const Point2& x : regular_polygon(random.integer(3, 5), 1)) {
            for (const double z : {-half_height, half_height})
              list.emplace_back(draw.real(size * x[0]), draw.real(size * x[1]), z);
          }
          body.shape = Hull<double>(std::span<const Vec3<double>>(list));
          break;
        }
        default:
          body.shape = Box<double>{Vec3<double>(size, some(draw, 0.1, 0.5), half_height)};
          break;
      }
      body.orientation = draw.pose_about_z();
      body.position = Vec3<double>(i == 0 ? -1.5 : 1.5, some(draw, -1.5, 1.5), draw.real(lift + world.skin));
      body.velocity = Vec3<double>(i == 0 ? 3 : -3, 0, 0);
      body.velocity[1] = some(draw, -1, 1);
      body.spin = Vec3<double>(0, 0, some(draw, -4, 4));
      world.members.push_back(body);
    }
  }
  void drive(Simulation& world) override {
    for (Member& one : world.members) {
      if (!one.moves) continue;
      const double speed = length(one.velocity);
      const double kept = speed > 0 ? std::max(0.0, 1 - 0.1 * kGravity * kStep / speed) : 0;
      for (int i = 0; i < 2; ++i) one.velocity[i] *= kept;
      one.spin[2] *= 0.99;
    }
  }
};

// Wheels, cylinders, capsules and balls that roll, each about its own axis, and yaw.
struct Rolling final : Scene {
  std::vector<double> radius, speed, yaw;

  void set_up(Simulation& world) override {
    Draw& draw = world.draw();
    Random& random = draw.random;
    radius.clear();
    speed.clear();
    yaw.clear();
    add_floor(world);
    for (int i = 0; i < 2; ++i) {
      Member body{.moves = true};
      const double r = some(draw, 0.1, 0.5), half_width = some(draw, 0.05, 0.25);
      switch (random.below(5)) {
        case 0:
          body.shape = Capsule<double>{r, half_width};
          break;
        case 1:
          body.shape = Sphere<double>{r};
          break;
        case 2: {
          std::vector<Vec3<double>> list;
          const int first = random.integer(3, 5);
          for (const Point2& x : regular_polygon(first, random.integer(2, 3))) {
            for (const double z : {-half_width, half_width})
              list.emplace_back(draw.real(r * x[0]), draw.real(r * x[1]), z);
          }
          body.shape = Hull<double>(std::span<const Vec3<double>>(list));
          break;
        }
        default:
          body.shape = Cylinder<double>{r, half_width};
          break;
      }
      body.orientation = multiply(draw.pose_about_z(), kLaidDown);
      for (int k = 0; k < 2; ++k) body.position[k] = some(draw, -1.5, 1.5);
      body.position[2] = draw.real(r + world.skin);
      radius.push_back(r);
      speed.push_back(some(draw, -4, 4));
      yaw.push_back(random.once_in(3) ? 0 : some(draw, -0.5, 0.5));
      world.members.push_back(body);
    }
  }
  void drive(Simulation& world) override {
    std::size_t i = 0;
    for (Member& one : world.members) {
      if (!one.moves) continue;
      const Vec3<double> axis = rotate(one.orientation, Vec3<double>(0, 0, 1));
      // Without sliding: v = spin x (0, 0, r).
      for (int k = 0; k < 3; ++k) one.spin[k] = speed[i] / radius[i] * axis[k];
      one.spin[2] += yaw[i];
      one.velocity = Vec3<double>(one.spin[1] * radius[i], -one.spin[0] * radius[i], 0);
      ++i;
    }
  }
};

// A column of boxes and cylinders at rest on each other. Gravity presses it, and the solver's noise moves it
// by less than a millimetre a step. Another body falls onto it.
struct Stacking final : Scene {
  void set_up(Simulation& world) override {
    Draw& draw = world.draw();
    Random& random = draw.random;
    add_floor(world);
    double top = 0;
    const int bodies = random.integer(3, 5);
    for (int i = 0; i < bodies; ++i) {
      Member body{.moves = true, .falls = true, .floor = top};
      const double half_height = some(draw, 0.1, 0.4), size = some(draw, 0.2, 0.5);
      if (random.once_in(3)) {
        body.shape = Cylinder<double>{size, half_height};
      } else {
        body.shape = Box<double>{Vec3<double>(size, some(draw, 0.2, 0.5), half_height)};
      }
      if (random.once_in(2)) body.orientation = draw.pose_about_z();
      for (int k = 0; k < 2; ++k) body.position[k] = some(draw, -0.05, 0.05);
      body.position[2] = draw.real(top + half_height + world.skin);
      top = draw.real(top + 2 * half_height + world.skin);
      if (i + 1 == bodies) {
        body.position[2] = draw.real(body.position[2] + random.uniform(0.05, 0.5));
        body.spin = some_vector(draw, 0.5);
      }
      world.members.push_back(body);
    }
  }
  void drive(Simulation& world) override {
    Draw& draw = world.draw();
    world.accelerate();
    for (Member& one : world.members) {
      if (!one.moves || draw.random.once_in(2)) continue;
      for (int k = 0; k < 2; ++k) one.velocity[k] = some(draw, -0.01, 0.01);
      one.spin[2] = some(draw, -0.02, 0.02);
    }
  }
};

template <class S>
void fill(Draw& draw, double place, Case& problem) {
  S scene;
  answer_question(draw, place, scene, problem);
}

}  // namespace

const Family workload::falling{
    .name = "falling",
    .sentence = "Boxes, cylinders, capsules, balls and hulls fall and tumble on a floor of tiles.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill<Falling>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

const Family workload::sliding_on_tiles{
    .name = "sliding_on_tiles",
    .sentence = "Bodies slide, yawing, over level tiles and triangles.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill<Sliding>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

const Family workload::rolling{
    .name = "rolling",
    .sentence = "Wheels, cylinders, capsules and balls roll over level tiles and triangles.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill<Rolling>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

const Family workload::stacking{
    .name = "stacking",
    .sentence = "A column of boxes and cylinders at rest, and one that falls onto it.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill<Stacking>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

}  // namespace graze::corpus
