// Parallel projection along a direction r: the line {s r} becomes the origin of a plane, and "does the line
// meet C" becomes "is the origin in the projected C". Axes e1, e2 across, e3 = r / |r|, so that a point c has
// the coordinates (e1.c, e2.c, e3.c), and the line's point s r has (0, 0, s |r|).
//
// |e_i.e_j - delta_ij| <= 4 u: the tilt moves a point of the line by at most 4 u of its distance from 0.
#pragma once

#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct Frame {
  Vec3<S> e1, e2, e3;
  S length;  // |r|

  // r != 0.
  explicit Frame(const Vec3<S>& r) : e3(r), length(1) {
    // Squares of less vanish, or lose bits.
    if (const S most = r.cwiseAbs().maxCoeff(); most < kShort) {
      e3 /= most;
      length = most;
    }
    const S rest = norm(e3);
    GRAZE_ASSERT(rest > 0 && rest < kInfinity<S>);
    e3 /= rest;
    length *= rest;
    // Across the two larger coordinates: an axis-aligned r gives axis-aligned e1, e2, and ties stay ties.
    int least = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::abs(e3[i]) < std::abs(e3[least])) least = i;
    }
    Vec3<S> across = Vec3<S>::Zero();
    across[(least + 1) % 3] = -e3[(least + 2) % 3];
    across[(least + 2) % 3] = e3[(least + 1) % 3];
    e1 = across / norm(across);
    e2 = cross(e3, e1);
  }

  static constexpr S kShort = sizeof(S) == 8 ? S(0x1p-480) : S(0x1p-48);
  [[nodiscard]] Vec3<S> to_frame(const Vec3<S>& c) const { return {dot(e1, c), dot(e2, c), dot(e3, c)}; }
  [[nodiscard]] Vec3<S> to_world(const Vec3<S>& n) const { return n[0] * e1 + n[1] * e2 + n[2] * e3; }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
