// Exact edits of the motion of the bodies of a linear case. As in case.hpp, nothing is returned if some number of the
// new case would have to be rounded, and the true answer is known from the original's.
//
// Frame: world. Contact at t iff t v in C. The whole line is in contact over [t_in, t_out].
#pragma once

#include <cstdint>
#include <optional>

#include "corpus/case.hpp"

namespace graze::law {

// Both bodies moved by their own displacement over the time s, which may be negative. Times are then counted from s.
// Horizon and expectations are left alone.
[[nodiscard]] std::optional<corpus::Case> started_at(const corpus::Case& problem, double s);

// The same path run backwards, from the end at T to the start: contact over [T - t_out, T - t_in]. Nothing
// for T = 0 or infinity.
[[nodiscard]] std::optional<corpus::Case> reversed(const corpus::Case& problem);

// The start moved back by s, a few lengths of the path or a thousand by `salt`, and the horizon moved out by as much. A
// TOI t > 0 becomes s + t. A start in contact or a miss may meet C on the new part.
struct Extended {
  double by = 0;
  corpus::Case longer;
};
[[nodiscard]] std::optional<Extended> extended(const corpus::Case& problem, std::uint64_t salt);

// One velocity added to both bodies, or taken off so that one of them rests: v is the same.
[[nodiscard]] std::optional<corpus::Case> moved_together(const corpus::Case& problem, std::uint64_t salt);

}  // namespace graze::law
