// What a rotating cast is asked, and what it answers. One aggregate each; every field says when it is valid.
#pragma once

#include <graze/plan.hpp>
#include <graze/rotating_body.hpp>
#include <graze/rotating_proof.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

enum class RotatingMethod : std::uint8_t {
  time_steps,                // overlap tests at equal steps; may miss what happens between two
  bounding_spheres,          // the spheres' linear cast is a lower bound; equal steps from there
  conservative_advancement,  // never passes first contact; slow where the bodies graze
  bilateral_advancement,     // never passes first contact; proves the interval that it skips
  bilateral_published,       // as Catto published it, GDC 2013: may pass an intermediate contact
};
[[nodiscard]] constexpr std::string_view to_text(RotatingMethod method) {
  switch (method) {
    case RotatingMethod::time_steps:
      return "time_steps";
    case RotatingMethod::bounding_spheres:
      return "bounding_spheres";
    case RotatingMethod::conservative_advancement:
      return "conservative_advancement";
    case RotatingMethod::bilateral_advancement:
      return "bilateral_advancement";
    case RotatingMethod::bilateral_published:
      return "bilateral_published";
  }
  return {};
}

template <Scalar S>
struct RotatingOptions {
  Tier tier = Tier::standard;                 // exact does not exist where a rotation is seen: invalid_input
  std::optional<RotatingMethod> method = {};  // none: by the plan
  Economies economies = {};                   // of the plan
  Request request = Request::normal | Request::witnesses;
  S t_max = 1;            // finite, where a rotation is seen
  S target_distance = 0;  // m: contact is when the distance reaches m (length)
  // Width of the bracket that is asked for, over scale; 0: the least that the tier reaches.
  S tolerance = 0;
  // pass_over with a visible rotation: by the plan, conservative_advancement and bilateral_advancement.
  StartPolicy start_policy = StartPolicy::report;
  int max_iterations = 262144;  // support evaluations
  int time_steps = 64;          // of time_steps and bounding_spheres, over [0, t_max]
};

template <Scalar S>
struct RotatingResult {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;  // for invalid_input
  InvalidAt invalid_at = {};
  Plan plan;  // what was simulated, and why
  // As in CastResult: both 0 for initially_overlapping, infinite for miss, NaN for invalid_input.
  S toi_lower = std::numeric_limits<S>::quiet_NaN();
  S toi_upper = std::numeric_limits<S>::quiet_NaN();
  // hit, not_converged: at toi_lower the bodies' distance exceeds the target distance by no more (length).
  S distance = 0;
  // miss, by StartPolicy::pass_over: in contact at t = 0, and no deeper or new contact followed. Has no proof.
  bool passed_over = false;
  // time_steps, bounding_spheres: no point of a body moves by more between two steps (length); what is
  // smaller than that may have been missed.
  S hidden_motion = 0;
  Vec3<S> normal = Vec3<S>::
      Zero();  // hit, and not_converged where the bodies are that near: unit, from A to B, world axes, at toi_lower
  Vec3<S> point_a = Vec3<S>::Zero(), point_b = Vec3<S>::Zero();  // as the normal: world points at toi_lower
  std::optional<RotatingProof> proof;                            // when asked for
  Counters counters;
};

}}  // namespace graze::GRAZE_LINKAGE
