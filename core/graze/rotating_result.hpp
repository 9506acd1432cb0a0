/// @file
/// The options and the result of a rotating cast. Each is one aggregate, and every field says when it is valid.
#pragma once

#include <graze/plan.hpp>
#include <graze/rotating_body.hpp>
#include <graze/rotating_proof.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The search that answers a rotating cast.
enum class RotatingMethod : std::uint8_t {
  time_steps,        ///< Overlap tests at equal steps. It may miss contacts between two. For comparison.
  bounding_spheres,  ///< The linear contact of bounding spheres, then equal steps. For comparison.
  conservative_advancement,  ///< It never passes the first contact. It is slow if the bodies graze.
  bilateral_advancement,     ///< It never passes the first contact, and proves each interval that it skips.
  bilateral_published,       ///< As Catto published it (GDC 2013). It may pass a contact. For comparison.
};
/// The enumerator's name.
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

/// The options of a rotating cast. The defaults suit a first call.
///
/// @code
/// const graze::RotatingOptions<double> sampled{.method = graze::RotatingMethod::time_steps, .time_steps = 16};
/// const graze::RotatingOptions<double> proved{
///     .tier = graze::Tier::certified, .request = graze::Request::everything, .tolerance = 1e-6};
/// assert(sampled.t_max == 1 && !proved.method);
/// @endcode
template <Scalar S>
struct RotatingOptions {
  Tier tier = Tier::standard;  ///< Guarantee of the answer. exact is only for invisible rotations.
  std::optional<RotatingMethod> method = {};               ///< The method. Without one, the plan decides.
  Economies economies = {};                                ///< Savings that the plan may use.
  Request request = Request::normal | Request::witnesses;  ///< The results to compute.
  S t_max = 1;            ///< The end of the cast. It is finite if a rotation is visible.
  S target_distance = 0;  ///< m, a length: contact is when the distance reaches m.
  S tolerance = 0;  ///< The requested width of the bracket, over scale. 0 is the least that the tier reaches.
  /// The treatment of a start in contact. With a visible rotation, pass_over needs the plan, conservative_advancement
  /// or bilateral_advancement.
  StartPolicy start_policy = StartPolicy::report;
  int max_iterations = 262144;  ///< The largest number of support evaluations.
  int time_steps = 64;          ///< The number of steps of time_steps and bounding_spheres, over [0, t_max].
};

/// The answer of a rotating cast. Advance a simulation to `toi_lower`.
template <Scalar S>
struct RotatingResult {
  Outcome outcome = Outcome::invalid_input;  ///< Contact or no contact.
  Invalid invalid = Invalid::none;           ///< For invalid_input: the reason.
  InvalidAt invalid_at = {};                 ///< For invalid_input: the place.
  Plan plan;                                 ///< The simulated effects, and the reasons.
  /// The bracket, toi_lower <= TOI <= toi_upper, as the tier guarantees it. Both are 0 for initially_overlapping,
  /// infinite for miss, and NaN for invalid_input.
  S toi_lower = std::numeric_limits<S>::quiet_NaN();
  S toi_upper = std::numeric_limits<S>::quiet_NaN();  ///< The upper end of the bracket.
  /// For hit and not_converged, a length: at `toi_lower` the bodies' distance exceeds the target distance by no more.
  S distance = 0;
  /// For a miss by StartPolicy::pass_over: the bodies are in contact at t = 0, and the contact gets neither deeper
  /// nor new. It has no proof.
  bool passed_over = false;
  /// For time_steps and bounding_spheres, a length: no point of a body moves by more between two steps. Anything
  /// smaller may have been missed.
  S hidden_motion = 0;
  /// For a hit, and for not_converged if the bodies are that near, if requested: unit, from A to B, world axes, at
  /// `toi_lower`.
  Vec3<S> normal = Vec3<S>::Zero();
  /// For the same outcomes, if requested: the contact point of A at `toi_lower`, in world coordinates.
  Vec3<S> point_a = Vec3<S>::Zero();
  Vec3<S> point_b = Vec3<S>::Zero();   ///< The contact point of B, likewise.
  std::optional<RotatingProof> proof;  ///< If requested: the proof of the bracket.
  Counters counters;                   ///< The work that was done.
};

}}  // namespace graze::GRAZE_LINKAGE
