/// @file
/// Proofs of rotating casts: a chain of axes, each with its slice of time, and proved contact at its end.
///
/// **Slice** (t_0, t_1, n): for every t in [t_0, t_1] the bodies are more than the target distance m apart along
/// n(t),
///
///     max over a in A(t) of n(t).a  +  m |n|  <  min over b in B(t) of n(t).b.
///
/// n(t) is n itself (frame world), or rotates with a body: n(t) = R(t rotation_A) n (frame a), and likewise for b.
/// The slices follow each other from t = 0. Together they say that there is no contact before toi_lower.
///
/// **Contact** at toi_upper: k <= 6 support pairs (a_i, b_i) with weights l_i >= 0, not all 0. Let c_i = a_i - b_i at
/// that time, offsets included. Let r_i be the part of the radii of the two cores' vertices (sphere, capsule, rounded)
/// that the offsets do not use up. Contact is proved in one of these ways:
///
/// - |sum l_i c_i| <= sum l_i (r_i + m).
/// - k >= 4, and four points hold the origin strictly inside their hull. They are c_0, c_1, c_2, and c_3, or for k >
///   4 the mean of c_3 .. c_(k-1) by their weights. (The middle of an octahedron needs all six corners, a point below
///   its tip five.) For four pairs no weights are read.
/// - toi_upper = 0, where nothing has rotated and all is exact: the hull of k <= 4 points, grown by m, or by the balls
///   about vertices of the cores as well, holds the origin, boundary included. No weights are read.
/// - A crossing, for a flat A - B, which holds nothing strictly inside: three pairs, and a time contact_from. Seen
///   along some direction, the triangle of the c_i has the origin inside at every t in [contact_from, toi_upper]. The
///   origin is on one side of the triangle at the beginning, and on the other at the end.
///
/// Every number is a double, whatever scalar made the proof. The checker shares no code with the search.
#pragma once

#include <graze/proof.hpp>
#include <vector>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The frame in which the axis of a slice is fixed.
enum class AxisFrame : std::uint8_t {
  world,  ///< It does not rotate.
  a,      ///< It rotates with A.
  b,      ///< It rotates with B.
};
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(AxisFrame frame) {
  switch (frame) {
    case AxisFrame::world:
      return "world";
    case AxisFrame::a:
      return "a";
    case AxisFrame::b:
      return "b";
  }
  return {};
}

/// A slice of time in which an axis separates the bodies.
struct TimeSlice {
  /// The time at which it ends. It begins where the slice before it ends, the first at 0.
  double end = 0;
  Vec3<double> axis = Vec3<double>::Zero();  ///< World axes, at t = 0 if it rotates. Not normalised.
  AxisFrame frame = AxisFrame::world;        ///< Frame in which the axis is fixed.
};

/// The most support pairs that prove contact.
inline constexpr std::size_t kContactPairs = 6;

/// The proof of a rotating cast: its claims, and the slices and the contact that they rest on. RotatingResult::proof
/// holds it, if requested.
///
/// @code
/// // A blade of half length 2 rotates by half a turn beside a post that it does not reach.
/// const graze::RotatingBody<double> blade{
///     .body = {.shape = graze::Box<double>{{2, 0.1, 0.1}}}, .rotation = {0, 0, 3.14}};
/// const graze::RotatingBody<double> post{
///     .body = {.shape = graze::Cylinder<double>{0.1, 5}, .position = {0, 2.5, 0}}};
/// const graze::RotatingResult<double> r =
///     graze::cast(blade, post, {.tier = graze::Tier::certified, .request = graze::Request::proof});
/// assert(r.outcome == graze::Outcome::miss && r.proof && r.proof->toi_lower == graze::kInfinity<double>);
///
/// // Slices follow each other from 0 to t_max. Here every axis is fixed in the world, and leads to the post.
/// const graze::RotatingProof& proof = *r.proof;
/// double begin = 0;
/// for (const graze::TimeSlice& slice : proof.chain) {
///   assert(slice.end > begin && slice.frame == graze::AxisFrame::world && slice.axis[1] > 0);
///   begin = slice.end;
/// }
/// assert(begin >= 1 && proof.contact_size == 0);
/// @endcode
struct RotatingProof {
  /// The claim TOI >= toi_lower. Infinity claims a miss: no contact in [0, t_max]. 0 claims nothing.
  double toi_lower = 0;
  std::vector<TimeSlice> chain;  ///< The last slice ends at toi_lower or later, for a miss at t_max or later.

  /// The claim of contact at toi_upper, or by then for a crossing, so TOI <= toi_upper. Infinity claims nothing and
  /// needs no pairs.
  double toi_upper = kInfinity<double>;
  bool crossing = false;    ///< True if contact is proved by a crossing.
  double contact_from = 0;  ///< For a crossing: when it begins.
  int contact_size = 0;     ///< The number of support pairs.
  /// The support pairs, placed at toi_upper as the body moves. An offset, in world axes, is within the ball about the
  /// placed point. It is 0 for a crossing.
  std::array<SupportPair, kContactPairs> contact;
  std::array<double, kContactPairs> weight = {};  ///< The weights l_i.
};

}}  // namespace graze::GRAZE_LINKAGE
