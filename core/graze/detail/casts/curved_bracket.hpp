// Tier certified of cylinders, cones and ellipsoids: a bracket from the answer of the curved walk.
//
// The walk (search/fast/curved_walk.hpp, which defines the notation) ends with an axis n and a time. From these the
// bracket is proved in plain doubles, as its width leaves room for thousands of roundings.
//   lower   n.(s r) >= h(n) at s = lower, and 0 > h(n): n.(s r) is linear in s, so no s before lower is in contact.
//   upper   Three points of C that the path passes between, beyond predicate_error: support points along n and `tilt`
//           beside it. Their spacing is the tilt times the radius of curvature. Their depth below the surface is only
//           of the order of the tilt's square.
//   width   (upper - lower) |r|, and the depth before upper, h(n) - n.(upper r) over |n|.
// A miss is proved as in the walk. A start in contact is left to the wider search.
// Rounding, internal length, u in double. M + R bounds |w|. Axes: margin of the walk over |n|_1, as the point that it
// ends with is the farthest one in doubles. Seen along the path, e and f have length 1 within 4 u and are level
// within 6 u, and r is rounded once. A coordinate is then within sqrt(3) point_error + 11 u (M + R) <
// predicate_error. Here
//   predicate_error = 2 point_error + 16 u (M + R).
// The effect on the height of the plane at the line is derived in proving/prove.hpp, height_at_line.
#pragma once

#include <graze/detail/casts/certified_bracket.hpp>
#include <graze/detail/casts/curved_cast.hpp>
#include <graze/detail/proving/prove.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The bracket of a hit that the walk found.
template <Scalar S>
[[nodiscard]] CertifiedBracket bracket_curved(const CurvedPair<S>& pair, CurvedWalk<S>& walk,
                                              const CurvedSweep& found, double horizon) {
  constexpr double u = kUnitRoundoff<double>;
  // Tilts: of what is curved as the bodies are large, and of rims and edges a thousandth as large.
  constexpr double kTilt = 0x1p-25, kMoreTilt = 0x1p-20;
  CertifiedBracket out;
  const Triple n = found.n, &r = pair.direction();
  const double rate = dot(n, r), length = square_root(dot(n, n)), speed = square_root(dot(r, r));
  const double extent = pair.extent() + pair.radius(),
               predicate_error = 2 * point_error(pair) + fl(16 * u * extent);
  // The pair's scale is not below half its size (curved_walk.hpp).
  const double width = kLinearCertifiedWidth / 2 * (1 - 0x1p-20) * pair.size();
  const double h = found.reach + fl(pair.ball_margin() * sum(magnitude(n)));
  if (!(rate < 0) || !(h < 0)) return out;
  out.lower = h / rate * (1 - 8 * u);
  for (const double tilt : {kTilt, kMoreTilt}) {
    if (!walk.surround(n, tilt)) continue;
    const HeightAtLine at =
        height_at_line({walk.seen(0), walk.seen(1), walk.seen(2)}, predicate_error, extent);
    if (!at.sure) continue;
    out.upper = std::max((at.z + at.error) / speed * (1 + 8 * u), out.lower);
    out.apart = (out.upper - out.lower) * speed * (1 + 8 * u);
    const double depth = (h - dot(n, out.upper * r)) / length + predicate_error;
    out.proved = out.lower > 0 && out.upper <= horizon && out.apart <= width && depth <= width;
    if (out.proved) break;
  }
  return out;
}

// False: nothing is claimed, and of `out` only the counters have changed. The bodies have passed validate().
template <Scalar S>
[[nodiscard]] bool curved_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                    CastResult<S>& out) {
  if (options.start_policy == StartPolicy::pass_over || !(options.t_max > 0)) return false;
  const CurvedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves()) return false;
  const int k = pair.length_exponent(), j = pair.speed_exponent();
  const double horizon = double(options.t_max) * power_of_two(j - k);
  CurvedWalk<S> walk(pair, horizon, 0, options.max_iterations, out.counters, kUnitRoundoff<double>);
  const CurvedSweep found = walk.run();
  if (found.outcome == Outcome::miss) {
    out.outcome = Outcome::miss;
    out.toi_lower = out.toi_upper = kInfinity<S>;
    return true;
  }
  if (found.outcome != Outcome::hit) return false;
  const CertifiedBracket bracket = bracket_curved(pair, walk, found, horizon);
  if (!bracket.proved || !fill_bracket(a, b, options, bracket, k, j, out)) return false;
  fill_curved_contact(a, b, options, pair, found, double(out.toi_lower), out);
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
