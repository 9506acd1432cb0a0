/// @file
/// The options and the result of a cast. Each is one aggregate, and every field says when it is valid.
///
/// Every enumeration of graze has a `to_text`. It returns the enumerator's name, or a reason in words. A value that
/// is no enumerator has an empty text.
#pragma once

#include <graze/proof.hpp>
#include <optional>
#include <string_view>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The outcome of a query. T is `t_max`, and TOI the time of impact.
enum class Outcome : std::uint8_t {
  initially_overlapping,  ///< Contact at t = 0, touching included. TOI = 0.
  hit,                    ///< First contact at a TOI in (0, T].
  miss,                   ///< No contact in [0, T].
  /// Neither contact nor a miss is shown. The bracket is what is known. A linear cast of the certified tier answers
  /// so only for a tie: at `toi_lower` the bodies are within the guaranteed width of contact.
  not_converged,
  invalid_input,  ///< The input was refused: `invalid` says why, and `invalid_at` where.
};
/// The enumerator's name.
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

/// The search that answers a linear cast.
enum class Method : std::uint8_t {
  conservative_advancement,  ///< Advances by distance over speed. A baseline, slow if the bodies graze.
  gjk_ray_cast,              ///< GJK along the ray of the motion.
  mpr_sweep,                 ///< Portals along the ray of the motion. The fastest for polytopes.
  exact_portal,              ///< The search of the exact tier.
  certified_portal,          ///< The search of the certified tier, if that is not the exact one.
};
/// The enumerator's name.
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

/// How much an answer guarantees. cast.hpp says what scale is. u is the unit roundoff.
enum class Tier : std::uint8_t {
  /// True for some convex set within kappa u scale of C = A - B. The table of guarantees has kappa for each method.
  standard,
  certified,  ///< A bracket that is proved for the true shapes and motions, rounding included.
  exact,      ///< The answer for the true shapes, correctly rounded. Polytopes and rounded ones.
};
/// The enumerator's name.
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

/// The treatment of a start in contact.
enum class StartPolicy : std::uint8_t {
  report,  ///< It is the answer: initially_overlapping.
  /// A start that the motion leaves, or along which it slides, does not count.
  ///
  /// *Linear casts*: the start is passed over if the bodies touch without depth, and B moves away from A or along it.
  /// In formulas, n.v >= 0 for some n != 0 with h(n) <= 0. Here v is B's motion less A's, and h the support function
  /// of C without the target distance. Any other start in contact is reported.
  ///
  /// *Rotating casts* follow a start that is no deeper than kappa u scale. The hit is where the contact gets deeper,
  /// or where the bodies touch again after they were apart by more than rounding. Without either, the answer is a
  /// miss. A deeper start is reported.
  pass_over,
};
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(StartPolicy policy) {
  switch (policy) {
    case StartPolicy::report:
      return "report";
    case StartPolicy::pass_over:
      return "pass_over";
  }
  return {};
}

/// The results to compute, joined by |. The verdict (outcome and bracket) is always computed. A cast that needs
/// nothing else is cheaper.
///
/// @code
/// const graze::Request request = graze::Request::normal | graze::Request::proof;
/// assert(graze::asks_for(request, graze::Request::proof));
/// assert(!graze::asks_for(request, graze::Request::witnesses));
/// @endcode
enum class Request : std::uint8_t {
  verdict = 0,     ///< Outcome and bracket alone.
  normal = 1,      ///< The normal at the contact.
  witnesses = 2,   ///< The contact points `point_a` and `point_b`.
  proof = 4,       ///< A proof of the bracket, which a checker can verify.
  everything = 7,  ///< All of these.
};
/// Both requests together.
[[nodiscard]] constexpr Request operator|(Request l, Request r) {
  return static_cast<Request>(static_cast<unsigned>(l) | static_cast<unsigned>(r));
}
/// True if `request` and `what` have a part in common.
[[nodiscard]] constexpr bool asks_for(Request request, Request what) {
  return (static_cast<unsigned>(request) & static_cast<unsigned>(what)) != 0;
}
/// The names of all that is requested, with a comma between them.
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

/// Why an input was refused. In words, with the place: to_text(const InvalidAt&) of invalid_text.hpp.
enum class Invalid : std::uint8_t {
  none,             ///< Nothing is wrong.
  not_finite,       ///< A NaN, or an infinite coordinate, extent or displacement.
  out_of_range,     ///< A magnitude other than 0 outside kLeastMagnitude to kGreatestMagnitude.
  empty_hull,       ///< A hull without a vertex.
  negative_extent,  ///< A radius or a half extent below zero.
  zero_quaternion,  ///< An orientation (0, 0, 0, 0).
  missing_part,     ///< A combinator without parts, or with one that has no shape.
  /// Combinators nested deeper than 16, or with more than 4096 parts or 2^32 - 1 vertices. In the exact tier also numbers
  /// whose exact products outgrow their room.
  too_complex,
  rounding_mode,  ///< The thread does not round to nearest.
  unsafe_math,    ///< graze was compiled with a part of -ffast-math.
  bad_horizon,    ///< `t_max` is below zero or NaN.
  bad_target,     ///< `target_distance` is below zero, infinite, NaN or out of range.
  bad_tolerance,  ///< `tolerance` is below zero, infinite or NaN, or a budget is below one.
  /// The exact tier does not support the input: a hull of shapes, a visible rotation, or an ellipsoid, a cylinder or a
  /// cone other than in the cast of a point.
  not_exact,
  not_linear,  ///< A visible rotation with an infinite `t_max`.
  /// The start policy pass_over with a visible rotation: the method does not follow the contact of the start, or the
  /// certified tier cannot prove what becomes of it.
  not_followed,
};
/// The reason in words, without the place.
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
      return "an ellipsoid, a cylinder, a cone, a hull of shapes or a rotation that is seen, which tier "
             "exact "
             "does not know";
    case Invalid::not_linear:
      return "an infinite t_max with a visible rotation: it is for linear motions";
    case Invalid::not_followed:
      return "the start policy pass_over with a visible rotation, where this method does not follow the "
             "contact of the start, or tier certified cannot prove what becomes of it";
  }
  return {};
}

/// Whose input was refused.
enum class InvalidBody : std::uint8_t {
  none,  ///< The options, the machine, or both bodies.
  a,     ///< The first body.
  b,     ///< The second body.
};
/// "body a", "body b" or "neither body".
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

/// The field that was refused: a body's, a shape's, or an option.
enum class InvalidField : std::uint8_t {
  none,             ///< No field: the machine or the compiler.
  shape,            ///< A shape as a whole.
  position,         ///< A body's or a part's position.
  orientation,      ///< A body's or a part's orientation.
  displacement,     ///< A body's displacement.
  rotation,         ///< A rotating body's rotation.
  pivot,            ///< A rotating body's pivot.
  radius,           ///< The radius of a round shape.
  radii,            ///< The radii of an ellipsoid.
  half_height,      ///< The half height of a capsule, a cylinder or a cone.
  half_extents,     ///< The half extents of a box.
  vertex,           ///< A vertex of a segment, a triangle or a hull.
  part,             ///< The missing part of a combinator.
  t_max,            ///< An option.
  target_distance,  ///< An option.
  tolerance,        ///< An option.
  max_iterations,   ///< An option.
  time_steps,       ///< An option of rotating casts.
  tier,             ///< An option.
  start_policy,     ///< An option.
  direction,        ///< The direction of penetration_along().
};
/// The field's name.
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

/// The first place at which an input was refused. invalid_text.hpp puts it in words.
struct InvalidAt {
  Invalid why = Invalid::none;              ///< The reason.
  InvalidBody body = InvalidBody::none;     ///< Whose input.
  InvalidField field = InvalidField::none;  ///< Which field.
  /// Whose field it is: -1 for the body's own, 0 for its shape's, and k for that of the k-th part of a combinator.
  /// Each part is counted before its own parts.
  int part = -1;
  int index = -1;  ///< The vertex, or the component of a vector. -1 if the field has none, or all are meant.
};

/// The options of a linear cast. The defaults suit a first call.
///
/// @code
/// const graze::CastOptions<float> for_a_game{.request = graze::Request::normal, .tolerance = 1e-3F};
/// const graze::CastOptions<double> for_a_robot{.tier = graze::Tier::certified, .target_distance = 0.005};
/// const graze::CastOptions<double> for_a_ray{.t_max = graze::kInfinity<double>};
/// assert(for_a_game.t_max == 1 && for_a_robot.tolerance == 0 && for_a_ray.max_iterations == 256);
/// @endcode
template <Scalar S>
struct CastOptions {
  Tier tier = Tier::standard;  ///< Guarantee of the answer.
  /// The method of the standard tier. The other tiers have one each. Without a method, it is mpr_sweep for points,
  /// segments, triangles, boxes and hulls without a target distance, and for ellipsoids, cylinders and cones beside
  /// each other, or against any of these, a sphere or a capsule. For every other pair it is gjk_ray_cast.
  //
  // Measured, time of gjk over mpr: 1.0 to 2.2 on polytopes (1.3 random, 2.2 grazing), and 0.05 to 0.5 on spheres,
  // capsules and rounded shapes.
  std::optional<Method> method = {};
  Request request = Request::normal | Request::witnesses;  ///< The results to compute.
  S t_max = 1;            ///< T, the end of the cast. Infinity makes it a ray.
  S target_distance = 0;  ///< m, a length: contact is when the distance reaches m.
  /// Convergence target, a length over scale: the search may stop once the path is this near to contact. 0 stops at
  /// the rounding bound of the method, where nothing is left to gain.
  S tolerance = 0;
  StartPolicy start_policy = StartPolicy::report;  ///< Treatment of a start in contact.
  /// The largest number of support evaluations. A cast needs 5 to 20 typically. When they are used up, the outcome is
  /// not_converged, and the bracket is valid.
  int max_iterations = 256;
};

/// The work of a query. Equal inputs give equal counts. Nothing depends on timing.
struct Counters {
  int iterations = 0;       ///< Steps of the method's outer loop.
  int supports = 0;         ///< Support evaluations of C = A - B, in all stages.
  int gjk_iterations = 0;   ///< Closest-point solves.
  int portal_steps = 0;     ///< Steps of portal discovery and refinement.
  int exact_decisions = 0;  ///< Exact tier: signs that pairs of doubles did not decide.
  int poses = 0;            ///< Rotating casts: times at which the bodies were placed.

  /// Adds the work of another query.
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

/// The answer of a linear cast. After a hit, advance a simulation to `toi_lower`.
///
/// | outcome | what to do |
/// |---|---|
/// | hit | move both bodies to `toi_lower`, and respond along `normal` |
/// | miss | move both bodies to the end of the motion |
/// | initially_overlapping | ask penetration() for depth and direction, or cast again with StartPolicy::pass_over |
/// | not_converged | move to `toi_lower`. No contact comes before it. A certified tie: treat it as a hit |
/// | invalid_input | read `invalid_at`. Nothing else is set |
template <Scalar S>
struct CastResult {
  Outcome outcome = Outcome::invalid_input;  ///< Contact or no contact.
  Invalid invalid = Invalid::none;           ///< For invalid_input: the reason.
  InvalidAt invalid_at = {};                 ///< For invalid_input: the place.
  Method method = Method::gjk_ray_cast;      ///< The method that answered.
  /// The bracket, toi_lower <= TOI <= toi_upper, as the tier guarantees it. Both are 0 for initially_overlapping,
  /// infinite for miss, and NaN for invalid_input.
  S toi_lower = std::numeric_limits<S>::quiet_NaN();
  S toi_upper = std::numeric_limits<S>::quiet_NaN();  ///< The upper end of the bracket.
  /// For hit and not_converged, a length: the gap at `toi_lower`, from above. The gap is the distance of the bodies less
  /// the target distance.
  /// For a tie that the certified tier leaves open it is at most kLinearCertifiedWidth of scale, and a caller may
  /// treat it as contact.
  S distance = 0;
  /// For a miss by StartPolicy::pass_over: the bodies are in contact at t = 0, and leave or slide. It has no proof.
  bool passed_over = false;
  /// For hit, and not_converged of the certified tier, if requested: unit, from A to B, world axes. It is a
  /// supporting normal of C at the contact.
  Vec3<S> normal = Vec3<S>::Zero();
  /// For the same outcomes, if requested: the contact point of A at `toi_lower`, in world coordinates.
  Vec3<S> point_a = Vec3<S>::Zero();
  Vec3<S> point_b = Vec3<S>::Zero();  ///< The contact point of B.
  /// For hit, miss and not_converged, if requested. A bound that rounding leaves unproved claims nothing: its
  /// `toi_lower` is 0, or its `toi_upper` infinite.
  std::optional<Proof> proof;
  Counters counters;  ///< The work that was done.
};

}}  // namespace graze::GRAZE_LINKAGE
