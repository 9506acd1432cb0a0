// Tier certified of spheres, capsules and polytopes at a distance: a bracket from the answer of the round walk.
//
// The walk (search/fast/round_walk.hpp, whose notation this is) ends with a feature F of K, a time s and an axis n. From
// these the bracket is proved in plain doubles, as its width leaves room for thousands of roundings:
//   lower   n.(s r) >= h(n) + R |n| at s = lower, and 0 > h(n) + R |n|: n.(s r) is linear in s, so no s before
//           lower is in contact
//   upper   |x - p| <= R for a point p of F's hull, x = upper r
//   width   |lower r - p| - R, and the depth before upper, h(n) + R |n| - n.(upper r) over |n|
// Miss: as the walk proves it. Contact at t = 0: |p| <= R at x = 0.
//
// Rounding, internal length, u in double. Axes: margin of the walk over |n|_1. Lengths: a corner of F is within
// sqrt(3) point_error of one of K; the weights are >= 0 and sum up to 1 within 4 u, and p's own sums round by 4 u M;
// x within 2 u |s r| of the path, r being rounded once; |x - p| is up to 4 u of itself, R 3 u. As |s r| <= M + R
// where there is contact,
//   predicate_error = 2 point_error + 32 u (M + R)
// bounds what |x - p| - R is off by. Tested as a bound: tests/core/certified/round_bracket_test.cpp.
#pragma once

#include <graze/detail/casts/round_cast.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/search/exact/exact_answer.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The largest S not above t >= 0, and the least not below: no subnormal ones, which machines may flush.
template <Scalar S>
S time_down(double t) {
  return t < double(std::numeric_limits<S>::min()) ? S(0) : exact::round_down<S>(t);
}
template <Scalar S>
S time_up(double t) {
  return t > 0 ? std::max(exact::round_up<S>(t), std::numeric_limits<S>::min()) : S(0);
}

template <Scalar S>
[[nodiscard]] double round_predicate_error(const PreparedPair<S>& pair) {
  return 2 * point_error(pair) + 32 * kUnitRoundoff<double> * (pair.extent() + pair.radius());
}

struct RoundBracket {
  bool proved = false;
  double lower = 0, upper = 0;  // of s
  double apart = 0;             // not below the bodies' distance at lower, internal length
};

// Of a hit that the walk found.
template <Scalar S>
[[nodiscard]] RoundBracket bracket_round(const PreparedPair<S>& pair, const RoundWalk<S>& walk,
                                         const RoundSweep& found, double horizon) {
  RoundBracket out;
  const Triple &n = found.n, &r = pair.direction();
  const double rate = dot(n, r), predicate_error = round_predicate_error(pair), radius = pair.radius();
  // The pair's scale is not below half its size (round_walk.hpp).
  const double width = kLinearCertifiedWidth / 4 * pair.size();
  const double h = found.reach + radius * found.length + 2 * pair.ball_margin() * sum(magnitude(n));
  if (!(rate < 0) || !(h < 0)) return out;
  out.lower = h / rate;
  std::array<double, 3> lambda;
  const auto apart_at = [&](double s) {
    const Triple y = s * r - walk.nearest(s * r, lambda);
    return std::sqrt(dot(y, y)) - radius;
  };
  out.apart = std::max(apart_at(out.lower) + predicate_error, 0.0);
  // As much deeper as makes it sure.
  const double deeper = 4 * predicate_error * found.length / -rate;
  out.upper = std::max(found.upper, out.lower) + deeper;
  const double depth = (h - dot(n, out.upper * r)) / found.length + predicate_error;
  out.proved = out.lower > 0 && out.upper <= horizon && apart_at(out.upper) + predicate_error <= 0 &&
               out.apart <= width && depth <= width;
  return out;
}

// A hit's times and distance, k and j the exponents of length and speed. False, and nothing is set, for times that have
// no normal number: they are left to the wider search.
template <Scalar S>
[[nodiscard]] bool hand_out(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                            const RoundBracket& bracket, int k, int j, CastResult<S>& out) {
  const double lower = bracket.lower * power_of_two(k - j);
  const S toi_lower = time_down<S>(lower);
  const S toi_upper = std::min(time_up<S>(bracket.upper * power_of_two(k - j)), options.t_max);
  if (!(toi_lower > 0 && toi_upper < kInfinity<S>)) return false;
  out.outcome = Outcome::hit;
  out.toi_lower = toi_lower;
  out.toi_upper = toi_upper;
  // At the time as rounded down, v within 8 u of itself.
  const Vec3<double> v = wide(b.displacement) - wide(a.displacement);
  const double way = v.norm() * (lower - double(toi_lower));
  out.distance = exact::round_up<S>((bracket.apart * power_of_two(k) + way) * (1 + 0x1p-48));
  return true;
}

// False: nothing is claimed, and of `out` only the counters have changed. The bodies have passed validate().
template <Scalar S>
[[nodiscard]] bool round_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                   CastResult<S>& out) {
  if (options.start_policy == StartPolicy::pass_over || !(options.t_max > 0)) return false;
  const PreparedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves() || !(pair.radius() > 0)) return false;
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  const double horizon = double(options.t_max) * power_of_two(j - k);
  RoundWalk<S> walk(pair, horizon, 0, options.max_iterations, out.counters, kUnitRoundoff<double>);
  const RoundSweep& found = walk.run();
  switch (found.outcome) {
    case Outcome::miss:
      out.outcome = Outcome::miss;
      out.toi_lower = out.toi_upper = kInfinity<S>;
      return true;
    case Outcome::initially_overlapping:
      if (!(found.length + round_predicate_error(pair) <= pair.radius())) return false;
      out.outcome = Outcome::initially_overlapping;
      out.toi_lower = out.toi_upper = 0;
      return true;
    case Outcome::hit: {
      const RoundBracket bracket = bracket_round(pair, walk, found, horizon);
      if (!bracket.proved) return false;
      if (!hand_out(a, b, options, bracket, k, j, out)) return false;
      // Witnesses at toi_lower are of what is nearest then: on a path nearly along C's border the feature slides by more
      // than the bodies are apart. The normal is the axis of the lower bound.
      RoundSweep then = found;
      const Triple x = (double(out.toi_lower) * power_of_two(j - k)) * pair.direction();
      then.n = x - walk.nearest(x, then.lambda);
      then.length = std::sqrt(dot(then.n, then.n));
      if (!(then.length > 0)) return false;
      fill_round_contact(a, b, options, pair, walk, (1 / found.length) * found.n, then, double(out.toi_lower),
                         out);
      return true;
    }
    default:
      return false;
  }
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
