/// @file
/// Input validation: what a query accepts. Every query validates its own input, so call this only to find errors
/// early.
//
// The solvers and the proofs form products of three lengths, two quaternion components and a time. With numbers in the
// range below, such a product stays far from both ends of double's exponent range.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The least magnitude of a number other than 0. Every float is in the range.
inline constexpr double kLeastMagnitude = 1e-60;
/// The greatest magnitude of a number.
inline constexpr double kGreatestMagnitude = 1e60;

/// Invalid::none, or why a query would refuse this body. A result's `invalid_at` also says where. It takes the time
/// of the shape's parts.
///
/// @code
/// assert(graze::validate(graze::Body<double>{.shape = graze::Sphere<double>{-1}}) == graze::Invalid::negative_extent);
/// assert(graze::validate(graze::Body<double>{.position = {1e70, 0, 0}}) == graze::Invalid::out_of_range);
/// @endcode
template <Scalar S>
Invalid validate(const Body<S>& body);
/// Invalid::none, or why a cast would refuse these options.
template <Scalar S>
Invalid validate(const CastOptions<S>& options);
/// Invalid::none, or why a cast would refuse its input. It also checks the arithmetic: the thread must round to
/// nearest, and the compiler must have kept IEEE 754.
template <Scalar S>
Invalid validate(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options);

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/shapes/validation.hpp>
#endif
