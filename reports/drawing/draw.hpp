// Draws a case as SVG: the bodies at the start, on the way and where they meet or pass, the path, and the contact.
// Details at powers of ten show what is far smaller than the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"

namespace graze::draw {

// A claimed answer to the case, drawn beside ours.
struct DrawClaim {
  std::string words;           // the claimant, and the judgement of the claim
  std::optional<double> time;  // claimed time of contact, absent for a miss or an unknown time
  bool is_wrong = false;       // drawn if it is wrong, always listed
};

struct DrawSettings {
  std::optional<Vec3<double>> view = {};  // towards the viewer, any length but 0, absent for across the
                                          // motion
  int width = 760;                        // of the picture, in pixels
  // True for pictures that are sent to others. They show the world's axes, the viewing direction, and a magnifier at
  // the contact even if no detail is small.
  bool is_for_others = false;
  std::vector<DrawClaim> claims = {};
};

inline constexpr int kLeastWidth = 320, kGreatestWidth = 8192;

// A whole SVG document. If our default method refuses the case, it holds only text.
[[nodiscard]] std::string draw_svg(const corpus::Case& problem, const DrawSettings& settings = {});

}  // namespace graze::draw
