// The law of scenes: the savings of a scene change no verdict, and brackets meet.
//
// One side runs core on every pair and on each probe with each body, over the whole step, without a line of scene's and
// without a plan. Pairs with a rotating body use bilateral advancement, whether or not the rotation is visible. The
// others use a linear cast. The other side is the scene's run. Then
//
//   pair     a contact that one side proves is not denied by the other, and their brackets have a time in common.
//   first    the first event by the one may be the first by the other. The brackets of the two firsts have a
//            time in common, no event is one that cannot be the first, and one that must be is there.
//   body     the same for each body's events.
//   verdict  there is a contact by both, or by neither.
//
// A pair that either leaves open (not_converged) may be anything, but its bracket has to meet all the same. In tiers
// certified and exact all this is proved. Tier standard answers for shapes near the given ones: its brackets may miss
// each other by kStandardSlack, which is for scenes in general position.
#pragma once

#include <graze/scene/memory.hpp>

namespace graze::law {

// A part of a step of 1: roundings of 1e-13 at motions of which a thousandth is along the normal.
inline constexpr double kStandardSlack = 1e-9;

struct SceneTally {
  std::uint64_t scenes = 0, contacts = 0, open = 0, probe_contacts = 0;
  scene::Counts spared;  // of the runs with economies, summed
};

// Empty, or how the two sides contradict each other. Both are counted into the tally.
[[nodiscard]] std::string scene_law(const scene::Scene& scene, const scene::Options& options,
                                    SceneTally& tally);

// Cuts the scene's step into four, one after the other. Each is run twice: by itself, and with the memory of the step
// before, whatever that memory belonged to at first. Events are the same to the bit. On the way a body is moved by
// hand, and the target distance changes. The runs with a memory are counted into the tally.
[[nodiscard]] std::string memory_law(const scene::Scene& scene, const scene::Options& options,
                                     scene::Memory& memory, SceneTally& tally);

// As many scenes from this seed on, each with every economy on and with one of them off, and in steps.
struct SceneLawRun {
  SceneTally tally;
  std::string broken;  // the first break, with its seed, or empty
};
[[nodiscard]] SceneLawRun try_random_scenes(std::uint64_t first_seed, std::uint64_t count);

}  // namespace graze::law
