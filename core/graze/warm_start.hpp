// What the caller may keep of one answer about a pair for the next: where its search ended.
//
// A value: every result of a query that knows it hands one out, and the options of the next take it. Nothing is kept
// anywhere else. It is a guess, and tried like any other: whatever it says (of another pair, out of date, NaN, vertices
// that the shapes do not have), the guarantee is the same; a good one saves supports, a bad one costs one or a few. The
// bits of an answer may depend on it, as they depend on the order of A and B.
#pragma once

#include <array>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

struct WarmStart {
  Vec3<double> axis = Vec3<double>::Zero();  // world axes, any length; 0: none
  int size = 0;                              // vertices of C = A - B that follow: 0 to 4
  std::array<std::uint32_t, 4> vertex_a{}, vertex_b{};

  // An axis that a search can take: not 0, not NaN, of a length near 1 or any that its squares allow.
  [[nodiscard]] bool has_axis() const {
    const double most = axis.cwiseAbs().maxCoeff();
    return most > 0x1p-20 && most < 0x1p20 && axis.allFinite();
  }
};

}}  // namespace graze::GRAZE_LINKAGE
