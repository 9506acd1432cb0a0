// Casts of balls, which the bad engine answers rightly where it does not err.
#pragma once

#include <string>
#include <vector>

#include "certify/external/engine.hpp"
#include "corpus/case.hpp"

namespace graze::test {

// Along x: a ball of radius 1 at rest, and one of radius 0.5 that comes from x = 4 by `step` in one unit of t. It hits
// where step < -2.5.
inline corpus::Case balls(double step) {
  corpus::Case problem;
  problem.id = "test/balls";
  problem.a.shape = Sphere<double>{1};
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = {4, 0, 0};
  problem.b.displacement = {step, 0, 0};
  return problem;
}
inline corpus::Case hit() { return balls(-5); }
inline corpus::Case miss() { return balls(-1); }

inline external::EngineOptions bad_engine(const std::string& fault, int at = 1) {
  external::EngineOptions options{.command = "'" BAD_ENGINE "' " + fault + " " + std::to_string(at)};
  options.limits.time = std::chrono::milliseconds(500);
  options.limits.start = std::chrono::milliseconds(2000);
  options.limits.memory = std::uint64_t{256} << 20;
  return options;
}

}  // namespace graze::test
