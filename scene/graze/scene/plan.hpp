// What a scene simulates and what it spares: pair by pair, and in sum. Values that print, count and compare.
#pragma once

#include <array>
#include <graze/plan.hpp>
#include <string>

namespace graze::scene {

struct PairPlan {
  std::uint32_t a = 0, b = 0;  // bodies, a < b
  graze::Plan plan;
  double begin = 0;  // the swept bounds do not meet before this time

  friend bool operator==(const PairPlan& l, const PairPlan& r) {
    return l.a == r.a && l.b == r.b && l.begin == r.begin && l.plan.effects == r.plan.effects &&
           l.plan.reasons == r.plan.reasons;
  }
};

// Every pair of bodies is counted once: filtered, apart at rest, never_meet, moot, parted, held or kept by a memory,
// unfinished, or by what was simulated. Probes are counted by themselves.
struct Counts {
  std::uint64_t bodies = 0, resting = 0, turning = 0;
  std::uint64_t pairs = 0;       // n (n - 1) / 2
  std::uint64_t filtered = 0;    // by groups and masks
  std::uint64_t apart = 0;       // at rest, bounds apart
  std::uint64_t never_meet = 0;  // one moves, swept bounds never meet
  std::uint64_t moot = 0;        // an earlier event had settled what was asked
  std::uint64_t parted = 0;      // an axis parts them that did in the step before, or one near it
  std::uint64_t held = 0;        // in contact along the directions of the step before
  std::uint64_t kept = 0;        // they rest as in the step before, and so does their overlap
  std::uint64_t unfinished = 0;  // interrupted before
  std::uint64_t shortened = 0;   // cast with a horizon that an earlier event had bounded
  std::array<std::uint64_t, 4> effects = {};                  // by graze::Effects
  std::array<std::uint64_t, kPlanReasons> reasons = {};       // by graze::PlanReason
  std::uint64_t probes = 0, probe_casts = 0, probe_moot = 0;  // probes; pairs with a body: cast, moot

  [[nodiscard]] std::uint64_t simulated() const { return effects[0] + effects[1] + effects[2] + effects[3]; }
  void add(const graze::Plan& plan);

  friend bool operator==(const Counts&, const Counts&) = default;
};

// A line for each number that is not 0, and what it stands for.
[[nodiscard]] std::string to_text(const Counts& counts);

}  // namespace graze::scene
