// cast(A, B) of turning bodies = when do two moving convex shapes first touch, turning included?
//
// Inputs: bodies in world axes, the caller's units, radians (rotating_body.hpp). Everything is
// computed in double whatever S is; times are rounded outward to S. Without a method the plan decides what is
// simulated; with one, that method runs whatever moves. No throw, no global state; nothing is allocated but a
// requested proof. What each method promises: docs/guarantees.md.
#pragma once

#include <graze/rotating_result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
RotatingResult<S> cast(const RotatingBody<S>& a, const RotatingBody<S>& b,
                       const RotatingOptions<S>& options = {});

// What cast() would simulate without a method; effects of an invalid input are of no meaning.
template <Scalar S>
Plan plan(const RotatingBody<S>& a, const RotatingBody<S>& b, const RotatingOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/rotating/rotating_search.hpp>
#endif
