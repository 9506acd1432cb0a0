// Both ends of an exact search, casts and queries alike: what is refused before it, and the normal that it
// ends with.
#pragma once

#include <graze/exact/answer.hpp>
#include <graze/support/validate.hpp>

namespace graze::inline GRAZE_LINKAGE::exact {

// What tier exact refuses beyond the door.
template <Scalar S>
Invalid refusal(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  const Invalid invalid = validate(a, b, options);
  if (invalid != Invalid::none) return invalid;
  const bool known = is_exact(a.shape) && is_exact(b.shape) && !(options.target_distance > 0);
  return known ? Invalid::none : Invalid::not_exact;
}

// Unit, from A to B: -(f_1 x f_2) at an entry, f_1 x f_2 at an exit, as the facet's n.v > 0.
template <Scalar S>
Vec3<S> outward_normal(const Scene<S>& scene, const Facet& facet, bool entry) {
  const Vec3<double> n = unit_normal(scene, facet);
  return (entry ? Vec3<double>(-n) : n).template cast<S>();
}

}  // namespace graze::inline GRAZE_LINKAGE::exact
