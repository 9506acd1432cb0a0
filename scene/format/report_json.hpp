// The answer of a run of a scene, graze.events/1: one complete JSON object for a player. Numbers read back to
// the same bits, and nothing in it depends on time or threads.
#pragma once

#include "scene/format/scene_io.hpp"

namespace graze::scene {

// One line, without the newline at its end.
[[nodiscard]] std::string write_report(const Document& document, const Report& report);
// The plan alone: its counts, and every pair that would be simulated.
[[nodiscard]] std::string write_plan(const Document& document, const Planned& planned);

// For an event that has a proof: its case and the proof, a line for `graze check`.
[[nodiscard]] std::string write_event_proof(const Document& document, const Event& event, bool of_probe);

}  // namespace graze::scene
