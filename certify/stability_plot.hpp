// The pictures of graze stability, by gnuplot.
#pragma once

#include "certify/stability.hpp"

namespace graze::tool {

// Writes stability_FAMILY.dat and .gp into a directory, which is created, and draws stability_FAMILY.svg if
// gnuplot is installed. `gnuplot stability_FAMILY.gp` in that directory draws it again. Returns a line that
// lists the files. Throws std::runtime_error if nothing can be written.
std::string draw_family(const FamilyStability& family, const std::string& directory);

// The same for all families side by side, linear ones (stability_overview) or rotating ones
// (stability_overview_rotating). Draws nothing for a single family.
std::string draw_overview(const std::vector<Curve>& curves, bool rotating, const std::string& directory);

}  // namespace graze::tool
