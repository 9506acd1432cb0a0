// Random scenes in which every economy has something to spare, and bounds are met to the bit.
#pragma once

#include <graze/scene.hpp>

namespace graze::law {

struct RandomScene {
  scene::Scene scene;
  scene::Options options;  // tier, ask, request, tolerance, target distance; the rest by default
};

// A pure function of its seed. 2 to 12 bodies and up to 4 probes in a space of a few of their sizes: at rest
// side by side, moving, turning to no effect, as one, slowly, and in sight. Half of all numbers are multiples
// of 1/8, at which bodies touch exactly, the others decimals, at which they touch but for a rounding.
[[nodiscard]] RandomScene random_scene(std::uint64_t seed);

}  // namespace graze::law
