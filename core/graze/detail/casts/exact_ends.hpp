// Both ends of an exact search, casts and queries alike: what is refused before it, and the normal that it
// ends with.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/search/exact/exact_answer.hpp>
#include <graze/detail/shapes/validation.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// What tier exact refuses beyond the door.
template <Scalar S>
Invalid refusal(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  const Invalid invalid = validate(a, b, options);
  if (invalid != Invalid::none) return invalid;
  const auto takes = [](const Shape<S>& shape) { return has_fast_search(shape) || is_exact(shape); };
  const bool known = takes(a.shape) && takes(b.shape) && !(options.target_distance > 0);
  return known ? Invalid::none : Invalid::not_exact;
}

// Was it refused, and if so, where?
template <class Result, Scalar S>
bool refused(Result& out, const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  if (out.invalid != Invalid::not_exact) return refused(out, a, b, options);
  const bool of_a = !is_exact(a.shape), of_b = !of_a && !is_exact(b.shape);
  out.invalid_at = {.why = Invalid::not_exact,
                    .body = of_a   ? InvalidBody::a
                            : of_b ? InvalidBody::b
                                   : InvalidBody::none,
                    .field = of_a || of_b ? InvalidField::shape : InvalidField::target_distance,
                    .part = of_a || of_b ? 0 : -1};
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
