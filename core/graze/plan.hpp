// What must be simulated for a pair, and why: a value, with names that print.
#pragma once

#include <graze/result.hpp>
#include <string_view>

namespace graze { inline namespace GRAZE_LINKAGE {

// From the cheapest to the dearest.
enum class Effects : std::uint8_t {
  nothing,   // the answer is known from the bounds
  at_rest,   // one static query: nothing moves relative to the other
  linear,    // a linear cast
  rotating,  // a rotating cast
};

// Each can be switched off; none changes a verdict (properties/: plan laws).
struct Economies {
  bool at_rest = true;      // nothing moves: a static query
  bool unseen_spin = true;  // a turn that leaves the shape as it is: a ball's about its centre, ...
  bool as_one = true;       // both bodies turn and move as one
  bool bounds = true;       // bounding volumes that never meet

  [[nodiscard]] static constexpr Economies none() { return {false, false, false, false}; }
};

enum class PlanReason : std::uint8_t {
  nothing_moves,  // neither body moves relative to the other
  no_rotation,    // neither body turns
  unseen_spin_a,  // A turns, and its shape does not show it
  unseen_spin_b,
  as_one,             // the bodies turn together
  bounds_never_meet,  // the bounding spheres of the bodies stay apart
  rotation_a,         // A's turn can be seen
  rotation_b,
};
inline constexpr int kPlanReasons = 8;

[[nodiscard]] constexpr std::string_view to_text(Effects effects) {
  switch (effects) {
    case Effects::nothing:
      return "nothing";
    case Effects::at_rest:
      return "static";
    case Effects::linear:
      return "linear";
    case Effects::rotating:
      return "rotating";
  }
  return {};
}

[[nodiscard]] constexpr std::string_view to_text(PlanReason reason) {
  switch (reason) {
    case PlanReason::nothing_moves:
      return "nothing moves";
    case PlanReason::no_rotation:
      return "neither body turns";
    case PlanReason::unseen_spin_a:
      return "A's turn cannot be seen";
    case PlanReason::unseen_spin_b:
      return "B's turn cannot be seen";
    case PlanReason::as_one:
      return "both bodies turn as one";
    case PlanReason::bounds_never_meet:
      return "the bounds never meet";
    case PlanReason::rotation_a:
      return "A's turn can be seen";
    case PlanReason::rotation_b:
      return "B's turn can be seen";
  }
  return {};
}

struct Plan {
  Effects effects = Effects::rotating;
  std::uint16_t reasons = 0;  // bit k: PlanReason k

  [[nodiscard]] constexpr bool has(PlanReason reason) const {
    return (reasons >> static_cast<unsigned>(reason) & 1u) != 0;
  }
  constexpr void add(PlanReason reason) {
    reasons = static_cast<std::uint16_t>(reasons | 1u << static_cast<unsigned>(reason));
  }
};

}}  // namespace graze::GRAZE_LINKAGE
