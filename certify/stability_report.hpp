// The tables of graze stability.
#pragma once

#include "certify/stability.hpp"

namespace graze::tool {

// A method breaks down at a loss of more than half of its digits: a forward error above sqrt(u) of scale.
[[nodiscard]] double broken_forward(double unit_roundoff);

// One line about a family, as soon as it is measured.
[[nodiscard]] std::string family_line(const FamilyStability& family);

// The curves of a family, a row a level.
[[nodiscard]] std::string level_table(const FamilyStability& family);

// A row for each method and family at its worst level, by method, the worst family first.
[[nodiscard]] std::string stability_table(const std::vector<Curve>& curves);

// For each curve, the levels from which on forward errors, verdicts and convergence fail.
[[nodiscard]] std::string break_table(const std::vector<Curve>& curves);

// A row for each method: its worst level, its claim, and whether the claim holds.
[[nodiscard]] std::string summary_table(const std::vector<Curve>& curves);

// The broken guarantees, one line each.
[[nodiscard]] std::vector<std::string> breaches(const std::vector<Curve>& curves);

}  // namespace graze::tool
