// A scene of many bodies as a document that a viewer plays: bodies and their motions, the events, what was spared.
//
// The document is graze.play/1, which docs/reference/page-format.md describes. The events are read from graze.events/1,
// as `graze scene --json` writes it. Here every shape gets a mesh, once, and the counts are put into words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scene/format/scene_io.hpp"

namespace graze::show {

struct PlaySettings {
  std::string command = {};        // command that runs the scene again, empty for none
  std::size_t most_bodies = 2000;  // drawn bodies: those in events first, then the first of the file
  std::size_t most_events = 2000;  // listed events, the first in time
};

[[nodiscard]] nlohmann::ordered_json play_of(const scene::Document& document, const scene::Report& report,
                                             const PlaySettings& settings = {});

}  // namespace graze::show
