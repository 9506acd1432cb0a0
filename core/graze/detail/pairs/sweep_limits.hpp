// Limits of a linear search: the end of its path, its budget, and the distance that rounding cannot tell from
// contact.
#pragma once

#include <graze/detail/pairs/cso.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct SweepLimits {
  S s_max = 1;
  S noise = 0;   // internal length: a distance that rounding cannot tell from contact
  S target = 0;  // internal length at which the caller lets the search stop, >= noise
  int budget = 256;

  // The accuracy at which searches by distance stop before they settle for the noise: an eighth of it, 4 u scale.
  [[nodiscard]] S fine() const { return noise / 8; }
};

// kContact u scale is contact: the rounding of a support point is 3 u to 24 u of the lengths in it (cso.hpp),
// a closest point adds as much again.
inline constexpr int kContact = 32;

template <Scalar S>
SweepLimits<S> sweep_limits(const Cso<S>& cso, const CastOptions<S>& options) {
  SweepLimits<S> out;
  out.s_max = cso.moves() ? cso.to_parameter(options.t_max) : S(0);
  out.noise = kContact * kUnitRoundoff<S> * cso.scale();
  out.target = std::max(out.noise, options.tolerance * cso.scale());
  out.budget = options.max_iterations;
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
