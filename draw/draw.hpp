// A picture of a case as SVG: the bodies at the start, on the way and where they meet or pass, the path, the
// contact, and details at powers of ten where what matters is far smaller than the scene.
#pragma once

#include <optional>
#include <string>

#include "corpus/case.hpp"

namespace graze::draw {

struct DrawSettings {
  std::optional<Vec3<double>> view;  // towards the viewer, any length but 0; none: across the motion
  int width = 760;                   // of the picture, pixels
};

inline constexpr int kLeastWidth = 320, kGreatestWidth = 8192;

// A whole SVG document. Of a case that our default method refuses it holds only the words.
[[nodiscard]] std::string draw_svg(const corpus::Case& problem, const DrawSettings& settings = {});

}  // namespace graze::draw
