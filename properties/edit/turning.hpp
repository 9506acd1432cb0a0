// Edits of a case whose bodies turn, beside those of case.hpp: other ways to say one motion, the same
// motion the other way round, and a motion that repeats itself. Each is exact but where it states an error.
//
// Frame: world. A body's point x is at R(w t)(x - c) + c + v t, c = position + R(orientation) pivot.
#pragma once

#include <cstdint>
#include <optional>

#include "corpus/case.hpp"

namespace graze::law {

// The pivot of A (or B) moved along the axis of rotation, which leaves the motion as it is. Where that takes
// rounding, `before` has the turn of the case in few bits, or the body without its orientation. Nothing where
// the body does not turn.
struct SlidPivot {
  corpus::Case before, after;
};
[[nodiscard]] std::optional<SlidPivot> with_slid_pivot(const corpus::Case& problem, bool first,
                                                       std::uint64_t salt);
// A pivot, far or near, for every body that does not turn, where it means nothing. Nothing if both turn.
[[nodiscard]] std::optional<corpus::Case> with_idle_pivots(const corpus::Case& problem, std::uint64_t salt);
// One velocity added to both bodies. Contact at the same times, and its points further on by `drift` times t.
struct Drift {
  Vec3<double> drift = Vec3<double>::Zero();
  corpus::Case problem;
};
[[nodiscard]] std::optional<Drift> drifting(const corpus::Case& problem, std::uint64_t salt);

// The bodies as they are at time s, at rest. No point of them is off by more than `error`.
struct Standing {
  double error = 0;
  corpus::Case still;
};
[[nodiscard]] std::optional<Standing> standing_at(const corpus::Case& problem, double s);
// The whole step from its end back to its beginning: contact at T - t where it was at t, but that points are
// off by `error` at most.
struct WayBack {
  double error = 0;
  corpus::Case problem;
};
[[nodiscard]] std::optional<WayBack> way_back(const corpus::Case& problem);
// One body turning, whole turns and nothing else: a step of one turn and a little, in which it has been
// everywhere, and one of eight times that. The same contact, or none. `first`: A turns. Nothing where that
// body does not turn.
struct WholeTurn {
  corpus::Case once, often;
};
[[nodiscard]] std::optional<WholeTurn> whole_turns(const corpus::Case& problem, bool first);

}  // namespace graze::law
