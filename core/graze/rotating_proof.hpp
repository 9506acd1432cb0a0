// The proof of a rotating answer: a chain of axes, each with its slice of time, and proved contact at its
// end.
//
// Slice (t_0, t_1, n): for every t in [t_0, t_1] the bodies are more than the target distance m apart along
// n(t),
//   max over a in A(t) of n(t).a  +  m |n|  <  min over b in B(t) of n(t).b,
// where n(t) is n itself (frame world) or turns with a body: n(t) = R(t rotation_A) n (frame a), and so b.
// The chain's slices follow each other from t = 0, so together they say: no contact before toi_lower.
//
// Contact at toi_upper: k <= 6 support pairs (a_i, b_i) with weights l_i >= 0, not all 0. With c_i = a_i -
// b_i at that time, offsets included, and r_i what the offsets leave of the radii that the vertices of the
// two cores carry (sphere, capsule, rounded), contact is proved if either
//   |sum l_i c_i| <= sum l_i (r_i + m),
// or k >= 4 and four points hold the origin strictly inside their hull: c_0, c_1, c_2, and c_3 or, of more, the mean of
// c_3 .. c_(k-1) by their weights (the middle of an octahedron needs all six corners, a point below its tip five), or at
// toi_upper 0, where nothing has turned and all is exact, the hull of k <= 4 points, grown by m, holds it, boundary
// included; of four pairs no weights are read.
// A flat A - B holds nothing strictly: there contact is a crossing. Three pairs, and a time contact_from:
// seen along some direction the triangle of the c_i has the origin inside at every t in [contact_from,
// toi_upper], and the origin is on one side of it at the beginning, on the other at the end.
//
// Every number is a double whatever scalar made the proof, so it says exactly what it says; the checker lives
// in oracles/checker/check_rotating_proof.hpp and shares no code with the search.
#pragma once

#include <graze/proof.hpp>
#include <vector>

namespace graze { inline namespace GRAZE_LINKAGE {

enum class AxisFrame : std::uint8_t { world, a, b };
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

struct TimeSlice {
  double end = 0;                            // the slice begins where the one before it ends, the first at 0
  Vec3<double> axis = Vec3<double>::Zero();  // world axes (of t = 0, where it turns); not normalised
  AxisFrame frame = AxisFrame::world;
};

inline constexpr std::size_t kContactPairs = 6;

struct RotatingProof {
  // Claim: TOI >= toi_lower. Infinity claims a miss: no contact in [0, t_max]. 0 claims nothing.
  double toi_lower = 0;
  std::vector<TimeSlice> chain;  // the last slice ends at toi_lower or later; of a miss, at t_max or later

  // Claim: contact at toi_upper, or by it (crossing), so TOI <= toi_upper. Infinity claims nothing and needs
  // no pairs.
  double toi_upper = kInfinity<double>;
  bool crossing = false;
  double contact_from = 0;  // of a crossing
  int contact_size = 0;
  // Placed at toi_upper as the body moves; an offset, in world axes, is of the ball about the placed point,
  // and of a crossing zero.
  std::array<SupportPair, kContactPairs> contact;
  std::array<double, kContactPairs> weight = {};
};

}}  // namespace graze::GRAZE_LINKAGE
