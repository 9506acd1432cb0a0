// The scenes of the workloads: the bodies, their places and their motions. Each is set up anew when it has
// run for
// as many steps as it says.
#pragma once

#include "corpus/workloads/simulation.hpp"

namespace graze::corpus {

// Before each step: sets the velocities of what is driven.
struct Scene {
  virtual ~Scene() = default;
  // Puts the members in place, by the simulation's own draw.
  virtual void set_up(Simulation& world) = 0;
  virtual void drive(Simulation& world) { world.accelerate(); }
  [[nodiscard]] virtual int steps() const { return 90; }
};

}  // namespace graze::corpus
