// Reading and writing scenes, graze.scene/1 (docs/reference/scenes.md).
//
// A number is the double nearest to its decimal or hexfloat. A written scene reads back to the same bits. An
// error names the file and the field, what is wrong there and what would be right.
#pragma once

#include <graze/scene.hpp>

#include "corpus/format/case_io.hpp"

namespace graze::scene {

inline constexpr std::string_view kSceneSchema = "graze.scene/1";

struct Document {
  std::string id, comment;
  Scene scene;
  Options options;  // tier, ask, request, t_max, target_distance, tolerance, the rest is the caller's
};

struct ReadResult {
  std::optional<Document> document;
  std::vector<corpus::ReadError> errors;
};

[[nodiscard]] ReadResult read_scene_file(const std::string& path);
[[nodiscard]] ReadResult read_scene_text(std::string_view text, const std::string& name);

// A body, a ray or a cast on each line, with the newline at the end.
[[nodiscard]] std::string write_scene(const Document& document);

}  // namespace graze::scene
