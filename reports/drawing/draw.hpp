// A picture of a case as SVG: the bodies at the start, on the way and where they meet or pass, the path, the
// contact, and details at powers of ten where what matters is far smaller than the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"

namespace graze::draw {

// An answer of somebody to the case, drawn beside ours.
struct DrawClaim {
  std::string words;           // who claims what, and what is said of it
  std::optional<double> time;  // of contact, as it is claimed; none: no contact is, or not when
  bool is_wrong = false;       // drawn where it is wrong, said in any case
};

struct DrawSettings {
  std::optional<Vec3<double>> view = {};  // towards the viewer, any length but 0; none: across the motion
  int width = 760;                        // of the picture, pixels
  // Of a picture that goes to others: the world's axes, where it is seen from, and a magnifier at the contact whether
  // or not there is anything small to see.
  bool is_for_others = false;
  std::vector<DrawClaim> claims = {};
};

inline constexpr int kLeastWidth = 320, kGreatestWidth = 8192;

// A whole SVG document. Of a case that our default method refuses it holds only the words.
[[nodiscard]] std::string draw_svg(const corpus::Case& problem, const DrawSettings& settings = {});

}  // namespace graze::draw
