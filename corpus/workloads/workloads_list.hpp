// The workloads, in the order in which they are judged, and what makes a case of a scene.
#pragma once

#include "corpus/workloads.hpp"
#include "corpus/workloads/scenes.hpp"

// clang-format off
#define GRAZE_WORKLOADS(workload) \
  workload(falling) workload(sliding_on_tiles) workload(rolling) workload(stacking) \
  workload(hinges) workload(spinning_plates) workload(robot_arm) workload(gears)
// clang-format on

namespace graze::corpus {

namespace workload {
#define GRAZE_WORKLOAD(name) extern const Family name;
GRAZE_WORKLOADS(GRAZE_WORKLOAD)
#undef GRAZE_WORKLOAD
}  // namespace workload

inline constexpr double kPlaces[] = {0, 1};
inline constexpr std::string_view kPlaceMeaning = "0 at the origin, 1 a kilometre away from it";

// Runs the scene, again and again with other draws, up to the question with the number that `draw` has.
void answer_question(Draw& draw, double place, Scene& scene, Case& problem);

}  // namespace graze::corpus
