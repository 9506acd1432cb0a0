// What a cast is asked, and what it answers. One aggregate each; every field says when it is valid.
//
// Every enumeration of graze has a to_text: its enumerators' names, or, where a reason is given, the reason
// in words. A value that is no enumerator has an empty text.
#pragma once

#include <graze/proof.hpp>
#include <optional>
#include <string_view>

namespace graze { inline namespace GRAZE_LINKAGE {

enum class Outcome : std::uint8_t {
  initially_overlapping,  // contact at t = 0, touching included; TOI 0
  hit,                    // TOI in (0, T]
  miss,                   // no contact in [0, T]
  not_converged,  // neither is shown; the bracket is what is known. Tier certified of linear casts: a tie,
                  // the bodies within the promised width of contact at toi_lower (casts/certified_cast.hpp)
  invalid_input,  // CastResult::invalid says why, invalid_at where
};
[[nodiscard]] constexpr std::string_view to_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::initially_overlapping:
      return "initially_overlapping";
    case Outcome::hit:
      return "hit";
    case Outcome::miss:
      return "miss";
    case Outcome::not_converged:
      return "not_converged";
    case Outcome::invalid_input:
      return "invalid_input";
  }
  return {};
}

enum class Method : std::uint8_t {
  conservative_advancement,
  gjk_ray_cast,
  mpr_sweep,
  exact_portal,
  certified_portal,  // the search of tier certified, where that is not the exact one
};
[[nodiscard]] constexpr std::string_view to_text(Method method) {
  switch (method) {
    case Method::conservative_advancement:
      return "conservative_advancement";
    case Method::gjk_ray_cast:
      return "gjk_ray_cast";
    case Method::mpr_sweep:
      return "mpr_sweep";
    case Method::exact_portal:
      return "exact_portal";
    case Method::certified_portal:
      return "certified_portal";
  }
  return {};
}

// standard: true for some convex set within kappa u scale of C, by the method that the options name.
// certified: a bracket proved for the true shapes, rounding included (docs/guarantees.md says how wide).
// exact: of the true shapes, correctly rounded (casts/exact_cast.hpp); for polytopes without a target
// distance.
enum class Tier : std::uint8_t { standard, certified, exact };
[[nodiscard]] constexpr std::string_view to_text(Tier tier) {
  switch (tier) {
    case Tier::standard:
      return "standard";
    case Tier::certified:
      return "certified";
    case Tier::exact:
      return "exact";
  }
  return {};
}

// What a start in contact means. pass_over, linear motions: where the motion leaves or slides as it begins, n.v >= 0
// for some n != 0 with h(n) <= 0 (h of C without the target distance), it is a miss, as no contact is made anew; any
// other start in contact is reported. Rotating casts instead follow such a start while it is no deeper than kappa u
// scale. The hit is where it gets deeper, or where the bodies touch again after they were apart by more than rounding;
// without either it is a miss. A start that is deeper is reported (docs/rotating.md).
enum class StartPolicy : std::uint8_t { report, pass_over };
[[nodiscard]] constexpr std::string_view to_text(StartPolicy policy) {
  switch (policy) {
    case StartPolicy::report:
      return "report";
    case StartPolicy::pass_over:
      return "pass_over";
  }
  return {};
}

// What is wanted; what is not asked for is not computed. The verdict (outcome and bracket) always is.
enum class Request : std::uint8_t { verdict = 0, normal = 1, witnesses = 2, proof = 4, everything = 7 };
[[nodiscard]] constexpr Request operator|(Request l, Request r) {
  return static_cast<Request>(static_cast<unsigned>(l) | static_cast<unsigned>(r));
}
[[nodiscard]] constexpr bool asks_for(Request request, Request what) {
  return (static_cast<unsigned>(request) & static_cast<unsigned>(what)) != 0;
}
// Of several: each, with a comma between them.
[[nodiscard]] constexpr std::string_view to_text(Request request) {
  switch (request) {
    case Request::verdict:
      return "verdict";
    case Request::normal:
      return "normal";
    case Request::witnesses:
      return "witnesses";
    case Request::proof:
      return "proof";
    case Request::everything:
      return "everything";
  }
  if (request == (Request::normal | Request::witnesses)) return "normal, witnesses";
  if (request == (Request::normal | Request::proof)) return "normal, proof";
  if (request == (Request::witnesses | Request::proof)) return "witnesses, proof";
  return {};
}

// Why an input was refused.
enum class Invalid : std::uint8_t {
  none,
  not_finite,       // a NaN or an infinite coordinate, extent or displacement
  out_of_range,     // a magnitude outside the range of core/graze/validate.hpp
  empty_hull,       // a hull without a vertex
  negative_extent,  // a radius or a half extent below zero
  zero_quaternion,  // an orientation (0, 0, 0, 0)
  missing_part,     // a combinator without parts, or with one that has no shape
  too_complex,      // combinators nested deeper than 16, of more than 4096 parts or 2^32 - 1 vertices
  rounding_mode,    // the machine does not round to nearest
  unsafe_math,      // compiled with a part of -ffast-math (validate.hpp)
  bad_horizon,      // t_max below zero or NaN
  bad_target,       // target_distance below zero, infinite or NaN
  bad_tolerance,    // tolerance below zero, infinite or NaN, or a budget below one
  not_exact,        // tier exact asked for where it does not exist: a shape that is no polytope, a hull of
                    // shapes, a target distance, a rotation that is seen
  not_linear,       // a visible rotation with an infinite t_max
  not_followed,  // the start policy pass_over with a visible rotation: the method does not follow the contact of the
                 // start, or tier certified cannot prove what becomes of it
};
[[nodiscard]] constexpr std::string_view to_text(Invalid invalid) {
  switch (invalid) {
    case Invalid::none:
      return "nothing";
    case Invalid::not_finite:
      return "a NaN or an infinite number";
    case Invalid::out_of_range:
      return "a magnitude outside 1e-60 to 1e60";
    case Invalid::empty_hull:
      return "a hull without a vertex";
    case Invalid::negative_extent:
      return "a radius or a half extent below zero";
    case Invalid::zero_quaternion:
      return "an orientation of (0, 0, 0, 0)";
    case Invalid::missing_part:
      return "a combinator without parts";
    case Invalid::too_complex:
      return "combinators nested deeper than 16, of more than 4096 parts or 2^32 - 1 vertices, or, in tier "
             "exact, too many nested rotations";
    case Invalid::rounding_mode:
      return "another rounding mode than to nearest";
    case Invalid::unsafe_math:
      return "compiled with a part of -ffast-math";
    case Invalid::bad_horizon:
      return "a t_max below zero";
    case Invalid::bad_target:
      return "a target distance below zero or out of range";
    case Invalid::bad_tolerance:
      return "a tolerance below zero or beyond the scalar's range, or a budget below one";
    case Invalid::not_exact:
      return "a curved or rounded shape, a hull of shapes, a target distance or a rotation that is seen, "
             "which tier exact does not know";
    case Invalid::not_linear:
      return "an infinite t_max with a visible rotation: it is for linear motions";
    case Invalid::not_followed:
      return "the start policy pass_over with a visible rotation, where this method does not follow the "
             "contact of the start, or tier certified cannot prove what becomes of it";
  }
  return {};
}

// Whose input it was; none: the options', the machine's, or both bodies'.
enum class InvalidBody : std::uint8_t { none, a, b };
[[nodiscard]] constexpr std::string_view to_text(InvalidBody body) {
  switch (body) {
    case InvalidBody::none:
      return "neither body";
    case InvalidBody::a:
      return "body a";
    case InvalidBody::b:
      return "body b";
  }
  return {};
}

// Which number it was: a body's, a shape's, or an option.
enum class InvalidField : std::uint8_t {
  none,
  shape,  // as a whole
  position,
  orientation,
  displacement,
  rotation,
  pivot,
  radius,
  radii,
  half_height,
  half_extents,
  vertex,  // of a segment, a triangle or a hull
  part,    // of a combinator that has none
  t_max,
  target_distance,
  tolerance,
  max_iterations,
  time_steps,
  tier,
  start_policy,
  direction,  // of penetration_along
};
[[nodiscard]] constexpr std::string_view to_text(InvalidField field) {
  switch (field) {
    case InvalidField::none:
      return "nothing";
    case InvalidField::shape:
      return "shape";
    case InvalidField::position:
      return "position";
    case InvalidField::orientation:
      return "orientation";
    case InvalidField::displacement:
      return "displacement";
    case InvalidField::rotation:
      return "rotation";
    case InvalidField::pivot:
      return "pivot";
    case InvalidField::radius:
      return "radius";
    case InvalidField::radii:
      return "radii";
    case InvalidField::half_height:
      return "half_height";
    case InvalidField::half_extents:
      return "half_extents";
    case InvalidField::vertex:
      return "vertex";
    case InvalidField::part:
      return "part";
    case InvalidField::t_max:
      return "t_max";
    case InvalidField::target_distance:
      return "target_distance";
    case InvalidField::tolerance:
      return "tolerance";
    case InvalidField::max_iterations:
      return "max_iterations";
    case InvalidField::time_steps:
      return "time_steps";
    case InvalidField::tier:
      return "tier";
    case InvalidField::start_policy:
      return "start_policy";
    case InvalidField::direction:
      return "direction";
  }
  return {};
}

// Where an input was refused: the first place that is wrong. In words: graze/invalid_text.hpp.
struct InvalidAt {
  Invalid why = Invalid::none;
  InvalidBody body = InvalidBody::none;
  InvalidField field = InvalidField::none;
  // Whose field it is: -1 the body's own; 0 its shape's; k the k-th part's of a shape that is a combinator,
  // each part counted before its own parts.
  int part = -1;
  int index = -1;  // the vertex, or the component of a vector; -1: the field has none, or all are meant
};

template <Scalar S>
struct CastOptions {
  Tier tier = Tier::standard;
  // Of tier standard; the others have one each. None: mpr_sweep for points, segments, triangles, boxes and hulls
  // without a target distance, and for ellipsoids, cylinders and cones beside each other or any of these, spheres
  // and capsules; gjk_ray_cast for every other pair. Measured, time of gjk over mpr: 1.0 to 2.2 on polytopes
  // (1.3 random, 2.2 grazing); 0.05 to 0.5 on spheres, capsules and rounded shapes.
  std::optional<Method> method = {};
  Request request = Request::normal | Request::witnesses;
  S t_max = 1;            // T; infinity makes it a ray
  S target_distance = 0;  // m: contact is when the distance reaches m (length)
  // Convergence target (length over scale): the search may stop once the path is this near to contact.
  // 0 stops at the rounding bound of the method, where nothing is left to gain.
  S tolerance = 0;
  StartPolicy start_policy = StartPolicy::report;
  // Support evaluations of the search: typically 5 to 20, the worst seen in certify's table.
  int max_iterations = 256;
};

// How much was done. Nothing here depends on timing; equal inputs give equal counts.
struct Counters {
  int iterations = 0;       // steps of the method's outer loop
  int supports = 0;         // support evaluations of the CSO, all stages
  int gjk_iterations = 0;   // closest-point solves
  int portal_steps = 0;     // portal discovery and refinement steps
  int exact_decisions = 0;  // tier exact: signs that pairs of doubles did not decide
  int poses = 0;            // rotating casts: times at which the turning bodies were placed

  Counters& operator+=(const Counters& more) {
    iterations += more.iterations;
    supports += more.supports;
    gjk_iterations += more.gjk_iterations;
    portal_steps += more.portal_steps;
    exact_decisions += more.exact_decisions;
    poses += more.poses;
    return *this;
  }
};

template <Scalar S>
struct CastResult {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;  // for invalid_input
  InvalidAt invalid_at = {};
  Method method = Method::gjk_ray_cast;
  // toi_lower <= TOI <= toi_upper in the sense of the tier (standard: true for some convex set within
  // kappa u scale of C). Both 0 for initially_overlapping; both infinite for miss; NaN for invalid_input.
  S toi_lower = std::numeric_limits<S>::quiet_NaN();
  S toi_upper = std::numeric_limits<S>::quiet_NaN();
  // hit, not_converged: at toi_lower the bodies' distance exceeds the target distance by no more (length). Of a tie
  // that tier certified leaves open it is at most kLinearCertifiedWidth of scale: the caller may take it for contact.
  S distance = 0;
  // miss, by StartPolicy::pass_over: in contact at t = 0, and leaving or sliding. Has no proof.
  bool passed_over = false;
  // hit, and not_converged of tier certified, when asked for: unit, from A to B, world axes, a supporting normal of C at
  // the contact.
  Vec3<S> normal = Vec3<S>::Zero();
  // The same outcomes, when asked for: world points of A and of B at toi_lower.
  Vec3<S> point_a = Vec3<S>::Zero(), point_b = Vec3<S>::Zero();
  // hit, miss, not_converged, when asked for; bounds are absent where rounding leaves nothing unconditional.
  std::optional<Proof> proof;
  Counters counters;
};

}}  // namespace graze::GRAZE_LINKAGE
