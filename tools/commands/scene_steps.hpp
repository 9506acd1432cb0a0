// graze scene --steps: shows the savings from a memory of the step before.
#pragma once

#include "reports/text/table.hpp"
#include "scene/format/scene_io.hpp"

namespace graze::tool {

// Simulates the scene's step in this number of substeps, one after the other, with and without a memory. One thread,
// processor time. The two take turns, and each one's best run counts. The table has a row for each. It is empty if a
// signal stopped the run.
class SceneSteps {
 public:
  SceneSteps(const scene::Document& document, int steps);

  // False: stopped by a signal.
  [[nodiscard]] bool run();
  [[nodiscard]] Table table() const;

 private:
  struct Sum {
    scene::Counts counts;
    std::uint64_t supports = 0, events = 0;
    double seconds = kInfinity<double>;
    std::size_t bytes = 0;
  };
  [[nodiscard]] bool go_through(bool with_memory, Sum& best) const;

  scene::Options options_;
  std::vector<scene::Scene> scenes_;
  Sum without_, with_;
};

}  // namespace graze::tool
