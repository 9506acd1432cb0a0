// Selects the searches that answer a linear cast. There is one ladder for each tier or method and kind of pair, and
// the first rung that answers counts.
//
//   kind of pair   MPR                  GJK ray              certified                              exact
//   ray            ray_cast             ray_cast             ray_bracket                            ray_exact
//   polytopes      fast_cast            fast_ray_cast        exact_walk                             exact_walk
//                  robust_mpr_sweep     robust_gjk_ray
//   round          robust_mpr_sweep     round_cast           exact_walk_if_flat                     exact_round_cast
//                                       robust_gjk_ray       exact_round_bracket
//                                                            certified_search
//   curved         curved_cast          robust_gjk_ray       exact_walk_if_flat                     exact_or_refused
//                  robust_mpr_sweep                          curved_bracket
//                                                            certified_search
//   other          robust_mpr_sweep     robust_gjk_ray       exact_walk_if_flat                     exact_or_refused
//                                                            certified_search
//
// A ray is a point against one of seven shapes. If its rung leaves it open, the row of its kind decides. ray_exact
// decides every ray at an ellipsoid, a cylinder or a cone, unless it has a target distance. Conservative advancement has
// the one rung robust_advancement. Without a method, tier standard takes MPR for polytopes and curved pairs, and the GJK
// ray for the rest. fast_cast and fast_ray_cast pass the cases that rounding decides to the exact walk. The table is also
// in docs/explanation/architecture.md, and a test compares the two.
#pragma once

#include <graze/cast.hpp>
#include <graze/detail/casts/certified_cast.hpp>
#include <graze/detail/casts/curved_cast.hpp>
#include <graze/detail/casts/degenerate_round.hpp>
#include <graze/detail/casts/exact_cast.hpp>
#include <graze/detail/casts/pair_kind.hpp>
#include <graze/detail/casts/polytope_cast.hpp>
#include <graze/detail/casts/ray_cast.hpp>
#include <graze/detail/casts/robust_cast.hpp>
#include <graze/detail/casts/round_cast.hpp>
#include <graze/detail/shapes/validation.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// False: the rung claims nothing, and only the counters of the result have changed. The bodies have passed validate().
template <Scalar S>
using Rung = bool (*)(const Body<S>&, const Body<S>&, const CastOptions<S>&, CastResult<S>&);
// Up to three rungs, then null.
template <Scalar S>
using Ladder = std::array<Rung<S>, 3>;
template <Scalar S>
struct Ladders {
  Rung<S> ray;                                // or null
  std::array<Ladder<S>, kPairKinds> of_kind;  // by PairKind
};

template <Scalar S>
inline constexpr Ladders<S> kMprLadders{ray_cast<S>,
                                        {{{fast_cast<S>, robust_mpr_sweep<S>},
                                          {robust_mpr_sweep<S>},
                                          {curved_cast<S>, robust_mpr_sweep<S>},
                                          {robust_mpr_sweep<S>}}}};
template <Scalar S>
inline constexpr Ladders<S> kGjkLadders{ray_cast<S>,
                                        {{{fast_ray_cast<S>, robust_gjk_ray<S>},
                                          {round_cast<S>, robust_gjk_ray<S>},
                                          {robust_gjk_ray<S>},
                                          {robust_gjk_ray<S>}}}};
template <Scalar S>
inline constexpr Ladders<S> kAdvancementLadders{
    nullptr,
    {{{robust_advancement<S>}, {robust_advancement<S>}, {robust_advancement<S>}, {robust_advancement<S>}}}};
template <Scalar S>
inline constexpr Ladders<S> kCertifiedLadders{
    ray_bracket<S>,
    {{{exact_walk<S>},
      {exact_walk_if_flat<S>, exact_round_bracket<S>, certified_search<true, S>},
      {exact_walk_if_flat<S>, curved_bracket<S>, certified_search<true, S>},
      {exact_walk_if_flat<S>, certified_search<false, S>}}}};
template <Scalar S>
inline constexpr Ladders<S> kExactLadders{
    ray_exact<S>, {{{exact_walk<S>}, {exact_round_cast<S>}, {exact_or_refused<S>}, {exact_or_refused<S>}}}};

template <Scalar S>
[[nodiscard]] CastResult<S> climb(Method method, const Ladders<S>& ladders, const Body<S>& a,
                                  const Body<S>& b, const CastOptions<S>& options) {
  CastResult<S> out;
  out.method = method;
  out.invalid = validate(a, b, options);
  if (refused(out, a, b, options)) return out;
  if (ladders.ray && is_ray(a, b) && ladders.ray(a, b, options, out)) return out;
  for (const Rung<S> rung : ladders.of_kind[static_cast<std::size_t>(kind_of(a, b, options.target_distance))])
    if (rung(a, b, options, out)) break;
  return out;
}

}  // namespace detail

template <Scalar S>
CastResult<S> cast_conservative_advancement(const Body<S>& a, const Body<S>& b,
                                            const CastOptions<S>& options) {
  return detail::climb(Method::conservative_advancement, detail::kAdvancementLadders<S>, a, b, options);
}
template <Scalar S>
CastResult<S> cast_gjk_ray(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  return detail::climb(Method::gjk_ray_cast, detail::kGjkLadders<S>, a, b, options);
}
template <Scalar S>
CastResult<S> cast_mpr_sweep(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  return detail::climb(Method::mpr_sweep, detail::kMprLadders<S>, a, b, options);
}
template <Scalar S>
CastResult<S> cast_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  return detail::climb(Method::certified_portal, detail::kCertifiedLadders<S>, a, b, options);
}
template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  return detail::climb(Method::exact_portal, detail::kExactLadders<S>, a, b, options);
}

template <Scalar S>
CastResult<S> cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  if (options.tier == Tier::exact) return cast_exact(a, b, options);
  if (options.tier == Tier::certified) return cast_certified(a, b, options);
  const auto best = [&] {
    const detail::PairKind kind = detail::kind_of(a, b, options.target_distance);
    return kind == detail::PairKind::polytopes || kind == detail::PairKind::curved ? Method::mpr_sweep
                                                                                   : Method::gjk_ray_cast;
  };
  switch (options.method ? *options.method : best()) {
    case Method::exact_portal:
      return cast_exact(a, b, options);
    case Method::certified_portal:
      return cast_certified(a, b, options);
    case Method::conservative_advancement:
      return cast_conservative_advancement(a, b, options);
    case Method::gjk_ray_cast:
      return cast_gjk_ray(a, b, options);
    case Method::mpr_sweep:
      break;
  }
  return cast_mpr_sweep(a, b, options);
}

}}  // namespace graze::GRAZE_LINKAGE
