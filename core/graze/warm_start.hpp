/// @file
/// Warm starts: the part of an answer about a pair that makes the next query about it cheaper.
#pragma once

#include <array>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The state in which a search ended. Pass the `warm` of a result to the next query about the pair.
///
/// A stale, unrelated or NaN warm start never invalidates a guarantee. It is a guess that is tried: a good one saves
/// support evaluations, a bad one costs one or a few. The last bits of an answer may depend on it, as they depend on
/// the order of A and B. It is a value, and nothing is kept anywhere else.
///
/// @code
/// graze::WarmStart warm;  // empty
/// assert(!warm.has_axis() && warm.size == 0);
/// warm.axis = {0, 0, 1};  // a guess of your own
/// assert(warm.has_axis());
/// @endcode
struct WarmStart {
  /// A direction in world axes, of a length near 1. 0 if there is no such direction.
  Vec3<double> axis = Vec3<double>::Zero();
  int size = 0;                             ///< The number of vertices of C = A - B that follow, 0 to 4.
  std::array<std::uint32_t, 4> vertex_a{};  ///< Their indices in the core of A.
  std::array<std::uint32_t, 4> vertex_b{};  ///< Their indices in the core of B.

  /// True if a search can take the axis: it is finite, and its largest component is between 2^-20 and 2^20.
  [[nodiscard]] bool has_axis() const {
    const double most = axis.cwiseAbs().maxCoeff();
    return most > 0x1p-20 && most < 0x1p20 && axis.allFinite();
  }
};

}}  // namespace graze::GRAZE_LINKAGE
