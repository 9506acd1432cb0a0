// The pictures of graze stability, by gnuplot.
#pragma once

#include "certify/stability.hpp"

namespace graze::tool {

// Write stability_FAMILY.dat and .gp into a directory, which is made, and draw stability_FAMILY.svg if
// gnuplot is installed; `gnuplot stability_FAMILY.gp` there draws it anew. Return a line that says what is
// there; throw std::runtime_error if nothing can be written.
std::string draw_family(const FamilyStability& family, const std::string& directory);

// The same for all families side by side, linear ones (stability_overview) or rotating ones
// (stability_overview_rotating); nothing for a family alone.
std::string draw_overview(const std::vector<Curve>& curves, bool rotating, const std::string& directory);

}  // namespace graze::tool
