// Both ends of an exact search, casts and queries alike: what is refused before it, and the normal that it
// ends with.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/search/exact/exact_answer.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// Does tier exact take the shape? A polytope, or one with a ball about it.
template <Scalar S>
bool takes(const Shape<S>& shape) {
  return has_fast_search(shape) || is_exact(shape, true);
}
// Does tier exact refuse this valid input? If so, `out` says where.
template <class Result, Scalar S>
bool refused(Result& out, const Body<S>& a, const Body<S>& b) {
  if (takes(a.shape) && takes(b.shape)) return false;
  out.invalid = Invalid::not_exact;
  out.invalid_at = {.why = Invalid::not_exact,
                    .body = is_exact(a.shape, true) ? InvalidBody::b : InvalidBody::a,
                    .field = InvalidField::shape,
                    .part = 0};
  return true;
}
// A number outgrew its room (dyadic.hpp): no body alone is to blame.
template <class Result>
void refuse_as_too_complex(Result& out) {
  out.invalid = Invalid::too_complex;
  out.invalid_at = {.why = Invalid::too_complex};
}

// Unit, from A to B: -(f_1 x f_2) at an entry, f_1 x f_2 at an exit, as the facet's n.v > 0.
template <Scalar S>
Vec3<S> outward_normal(const Scene<S>& scene, const Facet& facet, bool entry) {
  const Vec3<double> n = unit_normal(scene, facet);
  return (entry ? Vec3<double>(-n) : n).template cast<S>();
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
