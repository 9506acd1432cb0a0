// A turning body at all its angles at once: the cylinder that it sweeps about its axis of rotation, which
// only moves along. What keeps clear of the cylinder keeps clear of the body, however many turns it makes.
//
// Notation   u = w/|w|;   c + t v the path of the pivot;   the body is a core plus a ball of radius r.
//   max over the cylinder and the ball of n.x = n.(c + t v) + max(n.u high, n.u low) + |n x u| reach + r |n|,
// high and low the core's greatest and least height along u from the pivot, which no turn changes, reach its
// largest distance from the axis (ball_motion.hpp).
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <optional>

#include "oracles/ball_motion.hpp"

namespace graze::oracle {

class SweptBody {
 public:
  // Nothing for a body that does not turn, and for a combinator, whose ball is not one.
  static std::optional<SweptBody> of(const Shape<double>& shape, const BallMotion& body) {
    const std::optional<double> radius = ball_of(shape);
    if (!radius || !body.turns()) return std::nullopt;
    SweptBody out;
    out.radius_ = Ball(*radius);
    out.reach_ = body.axis_reach();
    const BallVec& w = body.rotation();
    out.axis_ = (Ball(1) / norm(w)) * w;
    const BallMotion::Pose start = body.at(0);
    out.high_ = start.support(out.axis_).reach - dot(out.axis_, body.pivot()) - out.radius_;
    out.low_ = -(start.support(-out.axis_).reach + dot(out.axis_, body.pivot()) - out.radius_);
    return out;
  }

  // h(n) of all angles, at the time t; n of any length.
  [[nodiscard]] Ball reach(const BallMotion& body, const BallVec& n, double t) const {
    const Ball along = dot(n, axis_);
    const BallVec pivot = body.pivot() + Ball(t) * body.velocity();
    return dot(n, pivot) + max(along * high_, along * low_) + norm(cross(n, axis_)) * reach_ +
           radius_ * norm(n);
  }

 private:
  static std::optional<double> ball_of(const Shape<double>& shape) {
    if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) return sphere->radius;
    if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) return capsule->radius;
    const bool combined =
        std::holds_alternative<Posed<double>>(shape) || std::holds_alternative<Rounded<double>>(shape) ||
        std::holds_alternative<Sum<double>>(shape) || std::holds_alternative<HullOf<double>>(shape);
    return combined ? std::nullopt : std::optional<double>(0);
  }

  BallVec axis_;
  Ball radius_, reach_, high_, low_;
};

}  // namespace graze::oracle
