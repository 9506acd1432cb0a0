// The pairs of the benchmark of rotating casts. t_max is 1, and sizes are 0.5 to 1.
#pragma once

#include <graze/rotating_result.hpp>
#include <optional>
#include <string>
#include <vector>

namespace graze::bench {

struct MovingBodies {
  RotatingBody<double> a, b;
  std::optional<bool> contact;  // where the construction knows it
};

struct Scene {
  std::string name;
  std::vector<MovingBodies> pairs;
  double tolerance = 0;  // the requested tolerance
};

// Motion that a plan can spare, and motion that it cannot: one scene each, in the order of the report.
[[nodiscard]] std::vector<Scene> scenes_of_the_plan(std::size_t pairs);
// Linear hits, rotating hits, rotating misses.
[[nodiscard]] std::vector<Scene> scenes_of_requests(std::size_t pairs);
// Ordinary hits, grazing spins, fast spins, and contacts that come and go within the step.
[[nodiscard]] std::vector<Scene> scenes_of_methods(std::size_t pairs);

}  // namespace graze::bench
