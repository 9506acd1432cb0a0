// Both bodies of a rotating case in balls, at the working precision of the moment, for the claims of a proof.
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <optional>

#include "oracles/ball_motion.hpp"
#include "oracles/whole_turns.hpp"

namespace graze::oracle {

struct PairMotion {
  BallMotion a, b;
  std::optional<SweptBody> swept_a, swept_b;
  Ball target_distance;

  explicit PairMotion(const corpus::Case& problem)
      : a(problem.a, problem.spin_a, problem.a.position),
        b(problem.b, problem.spin_b, problem.a.position),
        swept_a(SweptBody::of(a)),
        swept_b(SweptBody::of(b)),
        target_distance(problem.target_distance) {}
};

struct PairInstant {
  double t;
  BallMotion::Pose a, b;

  PairInstant(const PairMotion& motion, double at) : t(at), a(motion.a.at(at)), b(motion.b.at(at)) {}
};

}  // namespace graze::oracle
