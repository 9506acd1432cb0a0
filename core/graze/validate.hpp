// The door: what a query accepts. Everything behind it may assume finite numbers in range.
//
// Range of a magnitude: 0, or kLeastMagnitude to kGreatestMagnitude. It holds every finite float, and leaves
// the products of three lengths, two quaternion components and a time that the solvers and the proofs form
// far from both ends of double's exponent range.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze::inline GRAZE_LINKAGE {

inline constexpr double kLeastMagnitude = 1e-60;
inline constexpr double kGreatestMagnitude = 1e60;

// What every query does first: Invalid::none, or why the input is refused.
template <Scalar S>
Invalid validate(const Body<S>& body);
template <Scalar S>
Invalid validate(const CastOptions<S>& options);
// Of the arithmetic, too: is the machine rounding to nearest, and was this compiled to keep it?
template <Scalar S>
Invalid validate(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options);

}  // namespace graze::inline GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/support/validate.hpp>
#endif
