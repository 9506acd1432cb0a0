// A rotating body at all its angles at once: the cylinder that it sweeps about its axis of rotation, which
// only translates. A set that does not touch the cylinder does not touch the body, however many turns it
// makes.
//
// Notation   u = w/|w|,   c + t v the path of the pivot.   Every point of the body is within r of the core.
//   max over the cylinder and the ball of n.x = n.(c + t v) + max(n.u high, n.u low) + |n x u| reach + r |n|,
// high and low the core's greatest and least height along u from the pivot, which no turn changes, reach its
// largest distance from the axis. All four are those of one core: BallMotion's (ball_motion.hpp).
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <optional>

#include "oracles/curved/ball_motion.hpp"

namespace graze::oracle {

class SweptBody {
 public:
  // Nothing for a body that does not turn.
  static std::optional<SweptBody> of(const BallMotion& body) {
    if (!body.turns()) return std::nullopt;
    SweptBody out;
    out.axis_ = (Ball(1) / norm(body.rotation())) * body.rotation();
    return out;
  }

  // h(n) of all angles, at the time t, with n of any length. For a shape of revolution, of its angles in [begin, end].
  [[nodiscard]] Ball reach(const BallMotion& body, const BallVec& n, double t, double begin,
                           double end) const {
    const Ball along = dot(n, axis_);
    const BallVec pivot = body.pivot() + Ball(t) * body.velocity();
    Ball about =
        max(along * body.axis_high(), along * body.axis_low()) + norm(cross(n, axis_)) * body.axis_reach();
    if (const auto own = body.own_reach(n, begin, end)) about = min(about, *own);
    return dot(n, pivot) + about + norm(n) * body.ball();
  }

 private:
  BallVec axis_;
};

}  // namespace graze::oracle
