// Edits of a case with rotating bodies, beside those of case.hpp: other descriptions of one motion, the same motion
// reversed, and a motion that repeats itself. Each is exact unless it states an error.
//
// Frame: world. A body's point x is at R(w t)(x - c) + c + v t, c = position + R(orientation) pivot.
#pragma once

#include <cstdint>
#include <optional>

#include "corpus/case.hpp"

namespace graze::law {

// The pivot of A (or B) moved along the axis of rotation, which leaves the motion as it is. If that needs rounding,
// `before` has the case with its rotation in few bits, or the body without its orientation. Nothing if the body does
// not rotate.
struct SlidPivot {
  corpus::Case before, after;
};
[[nodiscard]] std::optional<SlidPivot> with_slid_pivot(const corpus::Case& problem, bool first,
                                                       std::uint64_t salt);
// A pivot, far or near, for every body that does not rotate, where it has no effect. Nothing if both rotate.
[[nodiscard]] std::optional<corpus::Case> with_idle_pivots(const corpus::Case& problem, std::uint64_t salt);
// One velocity added to both bodies. Contact is at the same times, with its points moved by `drift` times t.
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
// The whole step from its end back to its beginning. A contact at t becomes one at T - t, except that points are off by
// `error` at most.
struct WayBack {
  double error = 0;
  corpus::Case problem;
};
[[nodiscard]] std::optional<WayBack> way_back(const corpus::Case& problem);
// One body in whole rotations and nothing else. One step is a full turn and a little, in which the body has been
// everywhere. The other is eight times as long. Both have the same contact, or none. `first`: A rotates. Nothing if
// that body does not rotate.
struct WholeTurn {
  corpus::Case once, often;
};
[[nodiscard]] std::optional<WholeTurn> whole_turns(const corpus::Case& problem, bool first);

}  // namespace graze::law
