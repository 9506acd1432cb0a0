// Random scenes in which every saving applies somewhere, and bounds are met to the bit.
#pragma once

#include <graze/scene.hpp>

namespace graze::law {

struct RandomScene {
  scene::Scene scene;
  scene::Options options;  // tier, request, tolerance and target distance are random, the rest by default
};

// A pure function of its seed. The scene has 2 to 12 bodies and up to 4 probes in a space of a few of their sizes.
// Bodies are at rest side by side, moving, rotating without effect, as one, slowly, and visibly. Half of all numbers
// are multiples of 1/8, at which bodies touch exactly. The others are decimals, at which they touch within rounding.
[[nodiscard]] RandomScene random_scene(std::uint64_t seed);

}  // namespace graze::law
