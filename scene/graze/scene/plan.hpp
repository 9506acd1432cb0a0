/// @file
/// The plan of a scene: what is simulated and what is skipped, pair by pair and in sum.
#pragma once

#include <array>
#include <graze/plan.hpp>
#include <string>

namespace graze::scene {

/// The effects that are simulated for a pair of bodies, and the reasons.
struct PairPlan {
  std::uint32_t a = 0;  ///< The index of a body.
  std::uint32_t b = 0;  ///< The index of another, a < b.
  graze::Plan plan;     ///< The effects that are simulated.
  double begin = 0;     ///< The swept bounds do not meet before this time.

  /// True if all of both plans is the same, their reasons included.
  friend bool operator==(const PairPlan& l, const PairPlan& r) {
    return l.a == r.a && l.b == r.b && l.begin == r.begin && l.plan.effects == r.plan.effects &&
           l.plan.reasons == r.plan.reasons;
  }
};

/// How many pairs were simulated or skipped, and why.
///
/// Every pair of bodies is counted once: as filtered, apart, never_meet, moot, parted, held, kept or unfinished, or
/// in `effects` by what was simulated. Probes are counted separately.
struct Counts {
  std::uint64_t bodies = 0;      ///< Bodies.
  std::uint64_t resting = 0;     ///< Bodies that neither move nor rotate.
  std::uint64_t turning = 0;     ///< Bodies that rotate.
  std::uint64_t pairs = 0;       ///< n (n - 1) / 2.
  std::uint64_t filtered = 0;    ///< Pairs that groups and masks separate.
  std::uint64_t apart = 0;       ///< Pairs at rest whose bounds are apart.
  std::uint64_t never_meet = 0;  ///< Pairs of which one moves, and whose swept bounds never meet.
  std::uint64_t moot = 0;        ///< Pairs that an earlier event made unnecessary.
  std::uint64_t parted = 0;      ///< With a memory: an axis separates them, as in the step before.
  std::uint64_t held = 0;  ///< With a memory: they are in contact along the directions of the step before.
  std::uint64_t kept = 0;  ///< With a memory: they rest as in the step before, and so does their overlap.
  std::uint64_t unfinished = 0;                          ///< The run was interrupted before.
  std::uint64_t shortened = 0;                           ///< Cast only up to the time of an earlier event.
  std::array<std::uint64_t, 4> effects = {};             ///< Simulated pairs, by graze::Effects.
  std::array<std::uint64_t, kPlanReasons> reasons = {};  ///< Simulated pairs, by graze::PlanReason.
  std::uint64_t probes = 0;                              ///< Probes.
  std::uint64_t probe_casts = 0;                         ///< Casts of a probe against a body.
  std::uint64_t probe_moot = 0;  ///< Pairs of a probe and a body that an earlier contact made unnecessary.

  /// The number of pairs that were simulated.
  [[nodiscard]] std::uint64_t simulated() const { return effects[0] + effects[1] + effects[2] + effects[3]; }
  /// Counts a simulated pair.
  void add(const graze::Plan& plan);

  /// True if all counts are the same.
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// A line for each number that is not 0, with its meaning.
[[nodiscard]] std::string to_text(const Counts& counts);

}  // namespace graze::scene
