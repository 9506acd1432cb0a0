// hinges, spinning_plates, robot_arm, gears: bodies that are driven about pivots.
#include <algorithm>
#include <cmath>

#include "corpus/families/standing.hpp"
#include "corpus/workloads/scenes.hpp"
#include "corpus/workloads/workloads_list.hpp"

namespace graze::corpus {
namespace {

double between(Draw& draw, double low, double high) { return draw.real(draw.random.uniform(low, high)); }

// A door that swings about a hinge by a spring, its frame, a box in its way, and a pendulum beside them.
struct Hinges final : Scene {
  void set_up(Simulation& world) override {
    constexpr int kFrame = 1;
    Draw& draw = world.draw();
    const double half_width = between(draw, 0.3, 0.6), half_height = 1,
                 half_thick = between(draw, 0.01, 0.03);
    const double clearance = between(draw, 0.001, 0.01);
    Member door{.shape = Box<double>{Vec3<double>(half_width, half_thick, half_height)}, .moves = true};
    door.pivot = Vec3<double>(-half_width, 0, 0);
    door.position = Vec3<double>(half_width, 0, draw.real(half_height + clearance));
    door.spin = Vec3<double>(0, 0, between(draw, -4, 4));
    world.members.push_back(door);
    // Two posts, a lintel and the floor.
    const auto add = [&](const Vec3<double>& half, const Vec3<double>& position) {
      Member part{.shape = Box<double>{half}, .group = kFrame};
      part.position = draw.real(position);
      world.members.push_back(part);
    };
    const double post = 0.05;
    add(Vec3<double>(post, post, 1.25), Vec3<double>(-post - clearance, 0, 1.25));
    add(Vec3<double>(post, post, 1.25), Vec3<double>(2 * half_width + clearance + post, 0, 1.25));
    add(Vec3<double>(half_width, post, post),
        Vec3<double>(half_width, 0, 2 * half_height + 2 * clearance + post));
    add(Vec3<double>(4, 4, 0.5), Vec3<double>(0, 0, -0.5));
    Member obstacle{.shape = Box<double>{Vec3<double>(0.125, 0.125, 0.25)},
                    .orientation = draw.pose_about_z(),
                    .group = kFrame};
    obstacle.position = Vec3<double>(between(draw, 0.2, 0.8), 0, 0.25);
    obstacle.position[1] = between(draw, 0.4, 0.8);
    world.members.push_back(obstacle);
    // A rod and its bob hang from a pivot. A wall is near the lowest point of the swing.
    const double arm = between(draw, 0.5, 1);
    Member bob{.shape = Capsule<double>{0.0625, 0.25}, .moves = true};
    bob.pivot = Vec3<double>(0, 0, arm);
    bob.orientation =
        draw.random.once_in(2) ? Quaternion<double>{2, 1, 0, 0} : Quaternion<double>{3, -1, 0, 0};
    const Vec3<double> hanging = rotate(bob.orientation, Vec3<double>(0, 0, -arm));
    bob.position = draw.real(Vec3<double>(-2 + hanging[0], hanging[1], 2 + hanging[2]));
    world.members.push_back(bob);
    add(Vec3<double>(0.5, 0.5, 0.25), Vec3<double>(-2, 0, 2 - arm - 0.3125 - 0.25 - world.skin));
    add(Vec3<double>(0.25, 0.05, 1), Vec3<double>(-2, between(draw, 0.2, 0.4), 1));
  }
  void drive(Simulation& world) override {
    Member& door = world.members[0];
    // A spring to where the door is shut: its torque goes with the sine of the angle.
    const Vec3<double> along = rotate(door.orientation, Vec3<double>(1, 0, 0));
    door.spin[2] -= kStep * 9 * along[1];
    Member& bob = world.members[6];
    const Vec3<double> hanging = rotate(bob.orientation, Vec3<double>(-bob.pivot));
    const Vec3<double> torque = cross(hanging, Vec3<double>(0, 0, -kGravity));
    const double square = dot(hanging, hanging);
    for (int k = 0; k < 3; ++k) bob.spin[k] += kStep / square * torque[k];
  }
};

// Plates that spin about their middles or a hub, and bodies that are shot and thrown through them.
struct SpinningPlates final : Scene {
  void set_up(Simulation& world) override {
    constexpr int kShots = 1;
    Draw& draw = world.draw();
    Random& random = draw.random;
    for (int i = 0; i < 2; ++i) {
      Member plate{.moves = true};
      const double thick = random.once_in(2) ? 0 : between(draw, 0.001, 0.01);
      const double x = between(draw, 0.3, 1), y = between(draw, 0.1, 1);
      if (random.once_in(4)) {
        plate.shape = Cylinder<double>{x, thick};
      } else {
        plate.shape = Box<double>{Vec3<double>(x, y, thick)};
        if (random.once_in(2)) plate.pivot = Vec3<double>(x, 0, 0);
      }
      plate.orientation = draw.pose();
      plate.position = Vec3<double>(i == 0 ? 0 : 3, 0, 0);
      const double rate = random.once_in(2) ? 30 : 3;
      for (int k = 0; k < 3; ++k) plate.spin[k] = between(draw, -rate, rate);
      world.members.push_back(plate);
    }
    for (int i = 0; i < 4; ++i) {
      Member shot{.moves = true, .group = kShots};
      const double size = between(draw, 0.005, 0.1);
      switch (random.below(4)) {
        case 0:
          shot.shape = Point<double>{};
          break;
        case 1:
          shot.shape = Sphere<double>{size};
          break;
        case 2:
          shot.shape = Capsule<double>{size / 4, size};
          break;
        default:
          shot.shape = Box<double>{Vec3<double>(size, size / 2, size / 2)};
          break;
      }
      // At a point near a plate's middle, in a tenth of a second to one.
      const Vec3<double> target(i < 2 ? 0 : 3, 0, 0);
      const double seconds = random.uniform(0.1, 1);
      for (int k = 0; k < 3; ++k) {
        shot.position[k] = target[k] + between(draw, -3, 3);
        shot.velocity[k] = draw.real((target[k] + random.uniform(-0.4, 0.4) - shot.position[k]) / seconds);
        shot.spin[k] = between(draw, -20, 20);
      }
      world.members.push_back(shot);
    }
  }
  void drive(Simulation&) override {}
  [[nodiscard]] int steps() const override { return 60; }
};

// Three links on a base, each turned by its joint, past a shelf with boxes on its boards.
struct RobotArm final : Scene {
  static constexpr int kLinks = 3;
  double rate[kLinks] = {};
  int until = 0;

  void set_up(Simulation& world) override {
    constexpr int kArm = 1, kShelf = 2;
    Draw& draw = world.draw();
    Random& random = draw.random;
    until = 0;
    for (int i = 0; i < kLinks; ++i) {
      Member link{.moves = true, .group = kArm};
      const double half = 0.35 - 0.05 * i, thick = 0.06 - 0.01 * i;
      // Along z in its own frame: a capsule, a box, or, at the end, a tool with corners.
      if (random.once_in(2)) {
        link.shape = Capsule<double>{draw.real(thick), draw.real(half)};
      } else {
        link.shape = Box<double>{draw.real(Vec3<double>(thick, thick, half))};
      }
      link.pivot = draw.real(Vec3<double>(0, 0, -half));
      if (i > 0) link.orientation = {2, 0, 1, 0};
      world.members.push_back(link);
    }
    join(world);
    const double beyond = between(draw, 0.9, 1.4);
    const auto add = [&](const Vec3<double>& half, const Vec3<double>& position) {
      Member part{.shape = Box<double>{draw.real(half)}, .group = kShelf};
      part.position = draw.real(position);
      world.members.push_back(part);
    };
    for (int board = 0; board < 4; ++board) {
      const double z = 0.4 * board + 0.1;
      add(Vec3<double>(0.2, 0.6, 0.01), Vec3<double>(beyond + 0.2, 0, z));
      const double size = between(draw, 0.04, 0.15);
      add(Vec3<double>(size, size, size),
          Vec3<double>(beyond + 0.2, between(draw, -0.5, 0.5), z + 0.01 + size));
    }
    for (const double side : {-0.61, 0.61})
      add(Vec3<double>(0.2, 0.01, 0.8), Vec3<double>(beyond + 0.2, side, 0.8));
  }
  // Each link's pivot is the end of the one before.
  static void join(Simulation& world) {
    Vec3<double> joint(0, 0, 0.25);
    for (int i = 0; i < kLinks; ++i) {
      Member& link = world.members[static_cast<std::size_t>(i)];
      const Vec3<double> arm = rotate(link.orientation, link.pivot);
      for (int k = 0; k < 3; ++k) {
        link.position[k] = world.draw().real(joint[k] - arm[k]);
        joint[k] = link.position[k] - arm[k];
      }
    }
  }
  void drive(Simulation& world) override {
    Draw& draw = world.draw();
    join(world);
    if (until-- <= 0) {
      until = 15;
      for (double& one : rate) one = draw.random.once_in(5) ? 0 : between(draw, -3, 3);
    }
    // The first joint turns about z, the others about the y-axis of the link before. Spins add up.
    Vec3<double> spin(0, 0, rate[0]), speed = Vec3<double>::Zero();
    for (int i = 0; i < kLinks; ++i) {
      Member& link = world.members[static_cast<std::size_t>(i)];
      if (i > 0) {
        const Vec3<double> axis =
            rotate(world.members[static_cast<std::size_t>(i - 1)].orientation, Vec3<double>(0, 1, 0));
        for (int k = 0; k < 3; ++k) spin[k] += rate[i] * axis[k];
      }
      link.spin = draw.real(spin);
      link.velocity = draw.real(speed);
      const Vec3<double> end = rotate(link.orientation, Vec3<double>(-2 * link.pivot));
      const Vec3<double> more = cross(link.spin, end);
      for (int k = 0; k < 3; ++k) speed[k] += more[k];
    }
  }
};

// Two spur gears in mesh: each tooth a prism that turns about its gear's axis, which is far outside of it.
struct Gears final : Scene {
  static constexpr int kTeeth[] = {8, 10, 12, 16};

  void set_up(Simulation& world) override {
    Draw& draw = world.draw();
    Random& random = draw.random;
    const int one = kTeeth[random.below(4)], other = kTeeth[random.below(4)];
    constexpr double kModule = 0.05;  // pitch diameter over teeth (metres)
    const double backlash = between(draw, 0.05, 0.3), speed = between(draw, -6, 6);
    const double radius = 0.5 * kModule * one, far = 0.5 * kModule * other;
    add_gear(world, 1, one, radius, Vec3<double>::Zero(), speed, backlash, false);
    // Across from a tooth is a gap.
    add_gear(world, 2, other, far, Vec3<double>(draw.real(radius + far), 0, 0), -speed * one / other,
             backlash, true);
  }
  static void add_gear(Simulation& world, int group, int teeth, double radius, const Vec3<double>& middle,
                       double speed, double backlash, bool between_teeth) {
    constexpr double kModule = 0.05, kHalfWidth = 0.05;
    Draw& draw = world.draw();
    // A tooth: half of the pitch wide at the pitch circle, less the backlash, and narrower at its tip.
    const double half = 0.25 * 3.140625 * kModule * (1 - backlash);
    std::vector<Vec3<double>> list;
    for (const double z : {-kHalfWidth, kHalfWidth}) {
      for (const double y : {-1.0, 1.0}) {
        list.emplace_back(draw.real(0.9 * kModule), draw.real(y * 0.5 * half), z);
        list.emplace_back(draw.real(-1.1 * kModule), draw.real(y * 1.25 * half), z);
      }
    }
    const Hull<double> tooth{std::span<const Vec3<double>>(list)};
    int first = teeth, doublings = 0;
    while (first > 5) {
      first /= 2;
      ++doublings;
    }
    // Twice as many directions, of which every other one has a tooth.
    const std::vector<Point2> directions = regular_polygon(first, doublings + 1);
    for (std::size_t i = 0; i < directions.size(); i += 2) {
      // The second gear meets the first at the direction (-1, 0).
      const Point2& x = directions[i + (between_teeth ? 1 : 0)];
      Member member{.shape = tooth, .orientation = turn_to(x[0], x[1]), .moves = true, .group = group};
      member.pivot = draw.real(Vec3<double>(-radius, 0, 0));
      const Vec3<double> arm = rotate(member.orientation, member.pivot);
      for (int k = 0; k < 3; ++k) member.position[k] = draw.real(middle[k] - arm[k]);
      member.spin = Vec3<double>(0, 0, draw.real(speed));
      world.members.push_back(member);
    }
  }
  void drive(Simulation&) override {}
};

template <class S>
void fill_machine(Draw& draw, double place, Case& problem) {
  S scene;
  answer_question(draw, place, scene, problem);
}

}  // namespace

const Family workload::hinges{
    .name = "hinges",
    .sentence = "A door swings in its frame, and a pendulum between walls.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill_machine<Hinges>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

const Family workload::spinning_plates{
    .name = "spinning_plates",
    .sentence = "Plates spin, and points and small bodies are shot through them.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill_machine<SpinningPlates>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

const Family workload::robot_arm{
    .name = "robot_arm",
    .sentence = "An arm of three links moves past a shelf with boxes on its boards.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill_machine<RobotArm>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

const Family workload::gears{
    .name = "gears",
    .sentence = "Two gears in mesh, tooth by tooth.",
    .hardness_meaning = kPlaceMeaning,
    .levels = kPlaces,
    .fill = fill_machine<Gears>,
    .rotating = true,
    .of_run = kQuestionsOfRun,
};

}  // namespace graze::corpus
