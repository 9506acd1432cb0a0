// A bullet flies through five sheets of paper, 0.1 mm thin, within one frame of a game.
//
// Poses at the frame's ends show nothing, since the bullet is before the sheets in one and behind them in the other. A
// scene has every contact, in the order of time, and says what it did not have to simulate.
#include <graze/overlap.hpp>
#include <graze/scene.hpp>

#include <cstdio>
#include <string>

int main() {
  constexpr double kFrame = 1.0 / 60, kSpeed = 900, kHalfSheet = 5e-5;  // s, m/s, m
  graze::scene::Scene scene;
  const graze::Body<double> bullet{.shape = graze::Capsule<double>{0.0045, 0.008},
                                   .position = {0, 0, 1.5},
                                   .orientation = {1, 0, 1, 0},  // its axis, z, to x
                                   .displacement = {kSpeed, 0, 0}};
  scene.bodies.push_back(
      {"bullet", {.body = bullet, .rotation = {3000, 0, 0}}});  // rifled: about its own axis
  scene.bodies.push_back({"high bullet", {.body = bullet, .rotation = {3000, 0, 0}}});
  scene.bodies.back().body.body.position = {0, 0, 3.006};  // flies 1.5 mm over the sheets
  for (int k = 0; k < 5; ++k) {
    scene.bodies.push_back({"sheet " + std::to_string(k),
                            {.body = {.shape = graze::Box<double>{{kHalfSheet, 1, 1.5}},
                                      .position = {2.0 + 2 * k, 0, 1.5},
                                      .displacement = {0, 0, k == 4 ? -200.0 : 0.0}}}});
  }
  scene.probes.push_back(graze::scene::ray("line of sight", {0, 0, 2}, {1, 0, 0}));

  const graze::scene::Report report =
      graze::scene::run(scene, {.tier = graze::Tier::certified, .t_max = kFrame});

  int seen = 0;
  for (std::size_t k = 2; k < scene.bodies.size(); ++k) {
    for (const double t : {0.0, kFrame}) {
      graze::Body<double> a = bullet, b = scene.bodies[k].body.body;
      a.position += t * a.displacement, b.position += t * b.displacement;
      seen += graze::overlap_mpr(a, b).outcome == graze::Outcome::initially_overlapping;
    }
  }
  std::printf("poses at the frame's ends: %d contacts\n", seen);
  std::printf("the scene: %s, %zu contacts\n", to_text(report.status).data(), report.events.size());
  for (const auto& event : report.events) {
    std::printf("  %8.4f ms, x = %.5f m: %s meets %s (%s)\n", event.toi_lower * 1e3, event.point_a[0],
                scene.bodies[event.a].name.c_str(), scene.bodies[event.b].name.c_str(),
                to_text(event.effects).data());
  }
  for (const auto& event : report.probe_events) {
    std::printf("%s ends at %.5f m, on %s\n", scene.probes[event.a].name.c_str(), event.toi_lower,
                scene.bodies[event.b].name.c_str());
  }
  std::printf("%s", to_text(report.counts).c_str());
}
