// Both bodies of a rotating case in balls, at the working precision of the moment, for the claims of a proof.
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <optional>

#include "oracles/curved/ball_motion.hpp"
#include "oracles/curved/whole_turns.hpp"

namespace graze::oracle {

struct PairMotion {
  BallMotion a, b;
  std::optional<SweptBody> swept_a, swept_b;
  std::optional<CommonTurn> common;
  Ball target_distance;

  explicit PairMotion(const corpus::Case& problem)
      : a(problem.a, problem.spin_a, problem.a.position),
        b(problem.b, problem.spin_b, problem.a.position),
        swept_a(SweptBody::of(a)),
        swept_b(SweptBody::of(b)),
        common(CommonTurn::of(a, b)),
        target_distance(problem.target_distance) {}

  // Bounds on the separation along n, fixed in the world: on its slope by rotation, and on that slope's
  // change.
  [[nodiscard]] Ball first_bound(const BallVec& n) const {
    const Ball each = a.first_bound(n) + b.first_bound(n);
    return common ? min(each, common->first_bound(n)) : each;
  }
  [[nodiscard]] Ball second_bound(const BallVec& n) const {
    const Ball each = a.second_bound(n) + b.second_bound(n);
    return common ? min(each, common->second_bound(n)) : each;
  }
};

struct PairInstant {
  double t;
  BallMotion::Pose a, b;

  PairInstant(const PairMotion& motion, double at) : t(at), a(motion.a.at(at)), b(motion.b.at(at)) {}
};

}  // namespace graze::oracle
