// Declares the functions that a file of this library calls and another one compiles.
//
// Tier certified calls tier exact, and cast() calls every tier. Without these lines exact.cpp would be compiled
// once more in certified.cpp, and both of them in standard.cpp.
#pragma once

#include <graze/detail/casts/ladder.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_ELSEWHERE(S)                                                                         \
  extern template bool detail::exact_walk(const Body<S>&, const Body<S>&, const CastOptions<S>&,   \
                                          CastResult<S>&);                                         \
  extern template CastResult<S> cast_exact(const Body<S>&, const Body<S>&, const CastOptions<S>&); \
  extern template CastResult<S> cast_certified(const Body<S>&, const Body<S>&, const CastOptions<S>&);

GRAZE_ELSEWHERE(float)
GRAZE_ELSEWHERE(double)

#undef GRAZE_ELSEWHERE

}}  // namespace graze::GRAZE_LINKAGE
