// A bracket that a fast search proves, and what a certified hit is filled with from it.
#pragma once

#include <graze/body.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/proving/prove.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct CertifiedBracket {
  bool proved = false;
  double lower = 0, upper = 0;  // of s
  double apart = 0;             // not below the bodies' distance at lower, internal length
};

// A hit's times and distance, k and j the exponents of length and speed. False, and nothing is set, for times that have
// no normal number: they are left to the wider search.
template <Scalar S>
[[nodiscard]] bool fill_bracket(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                const CertifiedBracket& bracket, int k, int j, CastResult<S>& out) {
  const double lower = bracket.lower * power_of_two(k - j);
  const S toi_lower = time_down<S>(lower);
  const S toi_upper = std::min(time_up<S>(bracket.upper * power_of_two(k - j)), options.t_max);
  if (!(toi_lower > 0 && toi_upper < kInfinity<S>)) return false;
  out.outcome = Outcome::hit;
  out.toi_lower = toi_lower;
  out.toi_upper = toi_upper;
  // At the time as rounded down, v within 8 u of itself.
  const Vec3<double> v = wide(b.displacement) - wide(a.displacement);
  const double way = norm(v) * (lower - double(toi_lower));
  out.distance = round_up<S>((fl(bracket.apart * power_of_two(k)) + way) * (1 + 0x1p-48));
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
