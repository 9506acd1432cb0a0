// cast(A, B) = when do two linearly moving convex shapes first touch?
//
//   TOI = the least t in [0, t_max] with  A + t v_A  and  B + t v_B  in contact (touching counts), or none.
//
// Inputs: bodies in world axes, the caller's units. No throw, no allocation, no global state. A ray cast is
// the cast of a Point.
//
// Tier standard   the answer is true for some convex set within kappa u scale of C = A - B; kappa per method
//                 in docs/guarantees.md.
// Tier certified  toi_lower <= TOI <= toi_upper for the true shapes, rounding included, at most
//                 kLinearCertifiedWidth of scale wide.
// Tier exact      the TOI of the true shapes, correctly rounded: toi_lower the largest S not above it,
//                 toi_upper the least not below. Of points, segments, triangles, boxes, hulls, and what
//                 posed, sum and swept make of them, without a target distance (casts/exact_cast.hpp).
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

// By options.tier, and in tier standard by options.method, or the one that result.hpp says is best.
template <Scalar S>
CastResult<S> cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});

// The methods of tier standard, whatever tier and method the options name.
template <Scalar S>
CastResult<S> cast_conservative_advancement(const Body<S>& a, const Body<S>& b,
                                            const CastOptions<S>& options = {});
template <Scalar S>
CastResult<S> cast_gjk_ray(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});
template <Scalar S>
CastResult<S> cast_mpr_sweep(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});

// The tiers above it.
template <Scalar S>
CastResult<S> cast_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});
template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {});

// Convergence target of tier certified, over scale: 9,000 u. The rounding of support points, which limits it,
// is below 100 u for shapes whose numbers are of similar size.
inline constexpr double kLinearCertifiedWidth = 1e-12;

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/casts/standard_cast.hpp>
#endif
