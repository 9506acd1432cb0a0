/// @file
/// Plans: the effects that must be simulated for a pair of bodies that may rotate, and the reasons.
#pragma once

#include <graze/result.hpp>
#include <string_view>

namespace graze { inline namespace GRAZE_LINKAGE {

/// Effects that must be simulated, from the cheapest to the most expensive.
enum class Effects : std::uint8_t {
  nothing,   ///< Nothing: the bounds show the answer.
  at_rest,   ///< One static query: the bodies do not move relative to each other.
  linear,    ///< A linear cast.
  rotating,  ///< A rotating cast.
};

/// Savings that a plan may use. Each can be switched off alone, and none changes a verdict.
///
/// @code
/// const graze::Economies all, no_bounds{.bounds = false};
/// assert(all.bounds && no_bounds.unseen_spin && !graze::Economies::none().as_one);
/// @endcode
struct Economies {
  bool at_rest = true;  ///< Bodies that do not move relative to each other: a static query.
  /// A rotation that leaves the shape as it is, as a ball's about its centre: a linear cast.
  bool unseen_spin = true;
  bool as_one = true;  ///< Bodies that rotate and move as one: a static query.
  bool bounds = true;  ///< Bounding spheres that never meet: nothing.

  /// With everything off, every pair is cast as it moves.
  [[nodiscard]] static constexpr Economies none() { return {false, false, false, false}; }
};

/// The reasons for a plan.
enum class PlanReason : std::uint8_t {
  nothing_moves,      ///< The bodies do not move relative to each other.
  no_rotation,        ///< Neither body rotates.
  unseen_spin_a,      ///< A rotates, and its shape stays as it is.
  unseen_spin_b,      ///< B rotates, and its shape stays as it is.
  as_one,             ///< The bodies rotate and move as one.
  bounds_never_meet,  ///< The bounding spheres of the bodies stay apart.
  rotation_a,         ///< A rotates visibly.
  rotation_b,         ///< B rotates visibly.
};
/// The number of reasons: PlanReason k exists for 0 <= k < kPlanReasons.
inline constexpr int kPlanReasons = 8;

/// "nothing", "static", "linear" or "rotating".
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

/// The reason in words.
[[nodiscard]] constexpr std::string_view to_text(PlanReason reason) {
  switch (reason) {
    case PlanReason::nothing_moves:
      return "nothing moves";
    case PlanReason::no_rotation:
      return "neither body rotates";
    case PlanReason::unseen_spin_a:
      return "A's rotation cannot be seen";
    case PlanReason::unseen_spin_b:
      return "B's rotation cannot be seen";
    case PlanReason::as_one:
      return "both bodies rotate as one";
    case PlanReason::bounds_never_meet:
      return "the bounds never meet";
    case PlanReason::rotation_a:
      return "A's rotation can be seen";
    case PlanReason::rotation_b:
      return "B's rotation can be seen";
  }
  return {};
}

/// The effects that must be simulated for a pair, and the reasons. A rotating cast returns it, and plan() of
/// rotating_cast.hpp computes it alone.
///
/// @code
/// graze::Plan plan;
/// plan.add(graze::PlanReason::rotation_b);
/// assert(plan.has(graze::PlanReason::rotation_b) && !plan.has(graze::PlanReason::rotation_a));
/// assert(to_text(plan.effects) == "rotating");
///
/// std::string reasons;
/// for (int k = 0; k < graze::kPlanReasons; ++k) {
///   const auto reason = static_cast<graze::PlanReason>(k);
///   if (plan.has(reason)) reasons += to_text(reason);
/// }
/// assert(reasons == "B's rotation can be seen");
/// @endcode
struct Plan {
  Effects effects = Effects::rotating;  ///< The effects that must be simulated.
  std::uint16_t reasons = 0;            ///< Bit k is set if PlanReason k holds.

  /// True if the reason holds.
  [[nodiscard]] constexpr bool has(PlanReason reason) const {
    return (reasons >> static_cast<unsigned>(reason) & 1u) != 0;
  }
  /// Adds a reason.
  constexpr void add(PlanReason reason) {
    reasons = static_cast<std::uint16_t>(reasons | 1u << static_cast<unsigned>(reason));
  }
};

}}  // namespace graze::GRAZE_LINKAGE
