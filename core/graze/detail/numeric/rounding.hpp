// A double rounded outward to the caller's scalar: lengths and coordinates of any sign, and times.
#pragma once

#include <bit>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The largest S not above x, and the least not below.
template <Scalar S>
S round_down(double x) {
  GRAZE_ASSERT(x == x);
  if constexpr (std::same_as<S, double>) {
    return x;
  } else {
    const float near = static_cast<float>(x);
    if (!(static_cast<double>(near) > x)) return near;
    // The next float below, which is finite: infinity is above a finite x, and -infinity above nothing.
    if (near == 0) return -std::numeric_limits<float>::denorm_min();
    return detail::bit_cast<float>(detail::bit_cast<std::uint32_t>(near) + (near > 0 ? ~0u : 1u));
  }
}
template <Scalar S>
S round_up(double x) {
  return -round_down<S>(-x);
}

// Times t >= 0 without subnormal numbers, which some machines flush to 0.
template <Scalar S>
S time_down(double t) {
  return t < double(std::numeric_limits<S>::min()) ? S(0) : round_down<S>(t);
}
template <Scalar S>
S time_up(double t) {
  return t > 0 ? std::max(round_up<S>(t), std::numeric_limits<S>::min()) : S(0);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
