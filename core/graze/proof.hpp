// The proof of a linear answer: an axis bounds the time of impact from below, a portal from above.
//
// Notation (world axes, t = 0)   C = A - B + ball(m), m the target distance;   v = v_B - v_A, exact;
//   h(n) = max over C of n.c;   contact at t iff t v in C;   TOI = the least such t in [0, T], or infinity.
//
// Axis n != 0, not normalised: a triple of doubles or, as the axis of an exact answer rarely is one,
// symbolic: plus or minus the cross product of two factors. It proves
//   TOI >= h(n) / (n.v)          when n.v < 0 (every t below lies outside the half-space n.c <= h(n));
//   TOI = infinity, a miss       when h(n) < min(0, T n.v)  (T * 0 = 0, for T = infinity too).
// Portal: k support pairs (a_i, b_i), k <= 3, or <= 4 for contact at t = 0. If some convex combination of the
// a_i - b_i is s v (within m of it) with 0 <= s <= T, then TOI <= s.
//
// Every number is a double whatever scalar made the proof, so it says exactly what it says. A proof states
// only bounds that hold without condition for the true shapes; the checker lives in
// oracles/checker/check_proof.hpp and shares no code with the search.
#pragma once

#include <array>
#include <graze/scalar.hpp>
#include <string_view>

namespace graze { inline namespace GRAZE_LINKAGE {

// A point of a posed body at t = 0, named so that it is exact:
//   position + R(orientation) x + offset,    x the vertex of the shape's core with that index (shape.hpp).
// `offset` is in world axes; |offset| <= the radius there: of a sphere or a capsule, and of every rounding
// and sphere that was chosen on the way to the vertex of a combinator; otherwise it is zero. Where that way
// ends in ellipsoids, cylinders or cones, `curved` holds a point of each in its own frame, in the order of
// the parts; a feature with more than kCurvedParts of them cannot be named.
inline constexpr std::size_t kCurvedParts = 2;

struct Feature {
  std::uint32_t vertex = 0;
  Vec3<double> offset = Vec3<double>::Zero();
  std::array<Vec3<double>, kCurvedParts> curved = {Vec3<double>::Zero(), Vec3<double>::Zero()};
};

struct SupportPair {
  Feature a, b;
};

// One factor of a symbolic axis: a triple of doubles, v, or the difference of two support pairs,
// (a_to - b_to) - (a_from - b_from), where one offset or both may stand for a curved or rounded point.
struct AxisFactor {
  enum class Kind : std::uint8_t { given, motion, difference };
  Kind kind = Kind::given;
  Vec3<double> given = Vec3<double>::Zero();
  SupportPair from, to;
};
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

struct Proof {
  // Claim: TOI >= toi_lower. Infinity claims a miss. 0 claims nothing and needs no axis.
  double toi_lower = 0;
  bool has_axis = false;
  // Symbolic: n = axis_sign (factor[0] x factor[1]), axis_sign 1 or -1; and `axis` is not read.
  bool symbolic = false;
  Vec3<double> axis = Vec3<double>::Zero();
  int axis_sign = 1;
  std::array<AxisFactor, 2> factor;

  // Claim: TOI <= toi_upper. Infinity claims nothing and needs no portal.
  double toi_upper = kInfinity<double>;
  int portal_size = 0;
  std::array<SupportPair, 4> portal;
};

}}  // namespace graze::GRAZE_LINKAGE
