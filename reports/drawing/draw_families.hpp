// The pictures of docs/reference/families.md: of each family the case that shows its point.
#pragma once

#include <string>
#include <vector>

#include "reports/drawing/draw.hpp"

namespace graze::draw {

struct FamilyPicture {
  std::string family;
  double hardness = 0;
  std::uint64_t seed = 1;
  DrawSettings settings;
};

// One for every family, linear ones first, in the families' order. A family that nobody has chosen a case
// for shows its middle level.
[[nodiscard]] std::vector<FamilyPicture> family_pictures();
[[nodiscard]] std::string draw_family(const FamilyPicture& picture);

}  // namespace graze::draw
