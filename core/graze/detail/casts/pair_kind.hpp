// The kind of a pair of shapes, which decides on the searches of its cast (ladder.hpp).
#pragma once

#include <graze/detail/search/fast/curved_walk.hpp>
#include <graze/detail/search/fast/round_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

enum class PairKind : std::uint8_t {
  polytopes,  // points, segments, triangles, boxes and hulls, without a target distance
  round,      // those, spheres, capsules and roundings of those, with a target distance or one that is round
  curved,     // a cylinder, a cone or an ellipsoid, with any of the above
  other,      // posed, sum, hull of, roundings of these and of the curved
};
inline constexpr std::size_t kPairKinds = 4;

template <Scalar S>
[[nodiscard]] PairKind kind_of(const Body<S>& a, const Body<S>& b, S target_distance) {
  if (!(target_distance > 0) && has_fast_search(a.shape) && has_fast_search(b.shape)) [[likely]]
    return PairKind::polytopes;
  if (is_round(a.shape) && is_round(b.shape)) return PairKind::round;
  return is_curved_or_round(a.shape) && is_curved_or_round(b.shape) ? PairKind::curved : PairKind::other;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
