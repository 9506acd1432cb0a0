// A double rounded to the caller's scalar, outward.
#pragma once

#include <cmath>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// The largest S not above x, and the least not below.
template <Scalar S>
S round_down(double x) {
  GRAZE_ASSERT(x == x);
  if constexpr (std::same_as<S, double>) {
    return x;
  } else {
    const float near = static_cast<float>(x);
    return static_cast<double>(near) > x ? std::nextafter(near, -kInfinity<float>) : near;
  }
}
template <Scalar S>
S round_up(double x) {
  return -round_down<S>(-x);
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
