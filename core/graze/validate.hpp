// Input validation: what a query accepts. The solvers behind it may assume finite numbers in range.
//
// Range of a magnitude: 0, or kLeastMagnitude to kGreatestMagnitude. Every finite float is in it. The solvers
// and the proofs form products of three lengths, two quaternion components and a time: of numbers in this
// range such a product stays far from both ends of double's exponent range.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

inline constexpr double kLeastMagnitude = 1e-60;
inline constexpr double kGreatestMagnitude = 1e60;

// What every query does first: Invalid::none, or why the input is refused. Where: the result's invalid_at.
template <Scalar S>
Invalid validate(const Body<S>& body);
template <Scalar S>
Invalid validate(const CastOptions<S>& options);
// Also of the arithmetic: the machine must round to nearest, and the compiler must have kept IEEE 754.
template <Scalar S>
Invalid validate(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options);

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/shapes/validation.hpp>
#endif
