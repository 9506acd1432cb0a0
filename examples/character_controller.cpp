// A character walks towards the north-east of a room and slides along what it meets.
//
// A step moves the character to the first contact, removes the part of the motion that leads into the wall, and
// continues with the rest. The character keeps a skin of 1 cm (`target_distance`), so `distance` knows the wall's normal
// at any time. At the next step it still touches the skin. `pass_over` lets it leave or slide from there.
#include <graze/cast.hpp>
#include <graze/distance.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

using Vec = graze::Vec3<double>;

namespace {

constexpr double kSkin = 0.01;  // metres

struct Wall {
  const char* name;
  graze::Body<double> body;
};

const Wall kRoom[] = {
    {.name = "pillar", .body = {.shape = graze::Cylinder<double>{0.5, 1.5}, .position = {2, 0.8, 1.5}}},
    {.name = "north wall",
     .body = {.shape = graze::Box<double>{{4, 0.1, 1.5}},
              .position = {4, 3, 1.5},
              .orientation = {1, 0, 0, -0.1}}},
    {.name = "east wall", .body = {.shape = graze::Box<double>{{0.1, 4, 1.5}}, .position = {6, 0, 1.5}}}};

// The part of a motion that leads into none of the walls with these normals, or 0 in a corner.
Vec along(const Vec& motion, const std::vector<Vec>& normals) {
  for (const Vec& n : normals) {
    const Vec slid = motion - motion.dot(n) * n;
    if (std::all_of(normals.begin(), normals.end(), [&](const Vec& m) { return slid.dot(m) < 1e-9; }))
      return slid;
  }
  return Vec::Zero();
}

// Moves the character by `wanted`, or by as much of it as the walls allow.
void walk(graze::Body<double>& character, Vec wanted) {
  std::vector<Vec> normals;  // from the character to each wall that this step has met
  character.displacement = wanted;
  for (int meetings = 0; meetings < 4 && character.displacement.norm() > 1e-6; ++meetings) {
    double first = 1;
    const Wall* met = nullptr;
    for (const Wall& wall : kRoom) {
      const auto r = graze::cast(character, wall.body,
                                 {.target_distance = kSkin, .start_policy = graze::StartPolicy::pass_over});
      if (r.outcome == graze::Outcome::miss || r.toi_lower >= first) continue;
      first = r.toi_lower, met = &wall;
    }
    character.position += first * character.displacement;
    if (met == nullptr) return;
    normals.push_back(graze::distance(character, met->body).normal);
    wanted *= 1 - first;
    character.displacement = along(wanted, normals);
    std::printf("   meets the %s at (%.3f, %.3f) and %s\n", met->name, character.position[0],
                character.position[1], character.displacement.norm() > 1e-6 ? "slides" : "stops");
  }
}

}  // namespace

int main() {
  graze::Body<double> character{.shape = graze::Capsule<double>{0.3, 0.6}, .position = {0, 0, 0.9}};
  double nearest = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= 20; ++step) {
    walk(character, {0.5, 0.25, 0});
    std::printf("%2d (%.4f, %.4f)\n", step, character.position[0], character.position[1]);
    for (const Wall& wall : kRoom) nearest = std::min(nearest, graze::distance(wall.body, character).lower);
  }
  std::printf("never nearer to a wall than %.6f m\n", nearest);
}
