// A crate slides to a wall, and a second one is out of its way: one contact, and one pair that is not cast.
#include <cmath>
#include <cstdio>
#include <graze/cast_all.hpp>
#include <graze/scene.hpp>

int main() {
  const graze::Box<double> cube{{0.5, 0.5, 0.5}};
  graze::scene::Scene scene;
  scene.bodies = {
      {.name = "wall", .body = {.body = {.shape = graze::Box<double>{{0.5, 5, 5}}}}},
      {.name = "crate", .body = {.body = {.shape = cube, .position = {4, 0, 0}, .displacement = {-6, 0, 0}}}},
      {.name = "aside", .body = {.body = {.shape = cube, .position = {0, 90, 0}}}},
  };
  const graze::scene::Report report = graze::scene::run(scene, {.threads = 2});
  if (!report.wrong.empty()) {
    std::printf("%s\n", report.wrong.c_str());
    return 1;
  }
  for (const graze::scene::Event& event : report.events) {
    std::printf("%s meets %s at %.17g\n", scene.bodies[event.a].name.c_str(),
                scene.bodies[event.b].name.c_str(), event.toi_lower);
  }
  return report.events.size() == 1 && report.events[0].a == 0 && report.events[0].b == 1 &&
                 std::abs(report.events[0].toi_lower - 0.5) < 1e-12 &&
                 report.counts.apart + report.counts.never_meet == 2
             ? 0
             : 1;
}
