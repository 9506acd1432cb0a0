/// @file
/// Proofs of linear casts: an axis bounds the time of impact from below, and a portal bounds it from above.
///
/// Notation, in world axes at t = 0: C = A - B + ball(m) with m the target distance. v = v_B - v_A, exact. h(n) = max
/// over C of n.c. The bodies touch at t if t v is in C, and the TOI is the least such t in [0, T], or infinity.
///
/// **Axis** n, not 0 and not normalised. It is a triple of doubles, or symbolic: plus or minus the cross product of
/// two factors, or the direction from the cores to a point of the path. The axis of an exact answer is rarely a triple
/// of doubles. It proves
///
/// - TOI >= h(n) / (n.v) if n.v < 0: every earlier t v is outside the half-space n.c <= h(n).
/// - TOI = infinity, a miss, if h(n) < min(0, T n.v), with T 0 = 0 for T = infinity too.
///
/// **Portal**: k support pairs (a_i, b_i), k <= 4. If some convex combination of the a_i - b_i is s v (within m of it)
/// with 0 <= s <= T, then TOI <= s. In a portal of cores, the points have no offsets, and the combination is within
/// R = r_A + r_B + m of s v, with the radii r of the balls around the cores.
///
/// A point against an ellipsoid, a cylinder or a cone needs neither, if m = 0: whether the point is in contact at a
/// given time is the sign of a polynomial, so that the checker decides a claim without an axis or a portal itself.
///
/// Every number is a double, whatever scalar made the proof. A proof states only bounds that hold without condition
/// for the true shapes. The checker shares no code with the search.
#pragma once

#include <array>
#include <graze/scalar.hpp>
#include <string_view>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The most curved parts that a feature can name.
inline constexpr std::size_t kCurvedParts = 2;

/// A point of a posed body at t = 0, named so that it is exact: position + R(orientation) x + offset, where x is the
/// vertex of the shape's core with that index (shape.hpp).
struct Feature {
  std::uint32_t vertex = 0;  ///< The index of a vertex of the shape's core.
  /// World axes. Its length is at most the radius there: that of a sphere or a capsule, and of every rounding and
  /// sphere on the way to the vertex of a combinator. Otherwise it is 0.
  Vec3<double> offset = Vec3<double>::Zero();
  /// If the way to the vertex ends in ellipsoids, cylinders or cones: a point of each in its own frame, in the order
  /// of the parts. A feature with more than kCurvedParts of them cannot be named.
  std::array<Vec3<double>, kCurvedParts> curved = {Vec3<double>::Zero(), Vec3<double>::Zero()};
};

/// A point of A and a point of B. Their difference is a point of C = A - B.
struct SupportPair {
  Feature a;  ///< The point of A.
  Feature b;  ///< The point of B.
};

/// One factor of a symbolic axis.
///
/// @code
/// // Two boxes meet face to face. The exact axis is a cross product of two differences.
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> cube{.shape = graze::Box<double>{{1, 1, 1}}, .displacement = {20, 1, 0}};
/// const graze::CastResult<double> r =
///     graze::cast(wall, cube, {.tier = graze::Tier::exact, .request = graze::Request::proof});
/// assert(r.proof->symbolic && r.proof->nearest.size == 0);
/// for (const graze::AxisFactor& factor : r.proof->factor) assert(to_text(factor.kind) == "difference");
/// @endcode
struct AxisFactor {
  /// The source of the factor.
  enum class Kind : std::uint8_t {
    given,   ///< A triple of doubles.
    motion,  ///< The relative motion v.
    difference,  ///< (a_to - b_to) - (a_from - b_from). One offset or both may stand for a curved or rounded point.
  };
  Kind kind = Kind::given;                    ///< Kind of the factor.
  Vec3<double> given = Vec3<double>::Zero();  ///< For Kind::given.
  SupportPair from;                           ///< For Kind::difference.
  SupportPair to;                             ///< For Kind::difference.
};
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(AxisFactor::Kind kind) {
  switch (kind) {
    case AxisFactor::Kind::given:
      return "given";
    case AxisFactor::Kind::motion:
      return "motion";
    case AxisFactor::Kind::difference:
      return "difference";
  }
  return {};
}

/// The axis of an exact answer about rounded polytopes: n = t v minus its foot on the plane, line or point through the
/// differences c_i of the pairs, and along v too if `motion`. Up to a positive factor, without division or roots:
///
/// - no direction: n = z
/// - one direction e: n = (e.e) z - (z.e) e
/// - two directions e and g: n = (z.N) N, with N = e x g
///
/// Here z = t v - c_0.
struct NearestAxis {
  int size = 0;  ///< The number of pairs: 1 to 3, with `motion` 1 or 2. 0: it is not the axis.
  std::array<SupportPair, 3> pair;  ///< Pairs of vertices of the cores, without offsets.
  double time = 0;                  ///< t. The foot along v does not depend on it.
  bool motion = false;              ///< True if v is one of the directions.
};

/// The proof of a linear cast: its claims, and the axis and the portal that they rest on. CastResult::proof holds it,
/// if requested.
///
/// `graze cast --proof` writes it to a file, and `graze check` verifies it.
///
/// @code
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> ball{.shape = graze::Sphere<double>{1}, .displacement = {20, 0, 0}};
/// const graze::CastResult<double> r =
///     graze::cast(wall, ball, {.tier = graze::Tier::exact, .request = graze::Request::proof});
/// assert(r.proof && r.proof->toi_lower <= 0.4 && 0.4 <= r.proof->toi_upper);
///
/// // For a rounded shape, the axis of an exact answer is symbolic: here two corners of the wall, and the time.
/// const graze::NearestAxis& nearest = r.proof->nearest;
/// assert(r.proof->symbolic && nearest.size == 2 && std::abs(nearest.time - 0.4) < 1e-15);
/// @endcode
///
/// @code
/// // Reads the proof of a ray that meets the wall at t = 9 / 20.
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> ray{.displacement = {20, 0, 0}};
/// const graze::CastResult<double> r = graze::cast(wall, ray, {.request = graze::Request::proof});
/// const graze::Proof& proof = *r.proof;
///
/// // From below: C is the wall, and its least x is 9. For this axis h(n) = 9 n_x, so TOI >= h(n) / (n.v) = 0.45.
/// assert(proof.has_axis && !proof.symbolic && proof.axis[0] < 0 && proof.axis[1] == 0 && proof.axis[2] == 0);
///
/// // From above: three corners of the side at x = 9, which the ray crosses between them. Bit 0 of their index is 0.
/// assert(proof.portal_size == 3 && !proof.of_cores);
/// for (int i = 0; i < proof.portal_size; ++i) {
///   const graze::SupportPair& pair = proof.portal[static_cast<std::size_t>(i)];
///   const graze::Feature& corner = pair.a;
///   assert((corner.vertex & 1) == 0 && corner.offset.isZero() && pair.b.vertex == 0);
/// }
/// @endcode
struct Proof {
  /// The claim TOI >= toi_lower. Infinity claims a miss. 0 claims nothing and needs no axis.
  double toi_lower = 0;
  bool has_axis = false;  ///< True if there is an axis.
  /// True if the axis is n = axis_sign (factor[0] x factor[1]), or `nearest`. Then `axis` is not read.
  bool symbolic = false;
  Vec3<double> axis = Vec3<double>::Zero();  ///< n, if it is not symbolic.
  int axis_sign = 1;                         ///< 1 or -1, for a cross product.
  std::array<AxisFactor, 2> factor;          ///< The factors of a cross product.
  NearestAxis nearest;                       ///< The axis, if it is symbolic and the size is not 0.
  /// For a `nearest` axis across v: the axis is n + e n_2 for all small enough e > 0. n_2 is -v if factor[0] is the
  /// motion, otherwise n x factor[0]. A graze at a double needs it, because no single plane proves it.
  bool then = false;

  /// The claim TOI <= toi_upper. Infinity claims nothing and needs no portal.
  double toi_upper = kInfinity<double>;
  int portal_size = 0;                ///< The number of support pairs, 0 to 4.
  std::array<SupportPair, 4> portal;  ///< The support pairs.
  bool of_cores = false;              ///< True for a portal of cores.
};

}}  // namespace graze::GRAZE_LINKAGE
