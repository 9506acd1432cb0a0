// The claim that an axis n proves, over any of the checker's arithmetics. Notation as in
// core/graze/proof.hpp, and R = radius_A + radius_B + m, H = max over vertices of n.(a - b), so h(n) = H + R
// |n|, w = wA wB > 0.
//
//   TOI >= t > 0   iff  n.v < 0 and h(n) - t n.v <= 0
//   a miss         iff  h(n) - t n.v < 0  with t = T where n.v < 0 (T = infinity: never), else t = 0
// Both need the sign of D + w R |n|, D = w (H - t n.v). For R > 0 it is <= 0 iff D <= 0 and D^2 >= w^2 R^2
// |n|^2. The strict case is analogous. A symbolic n that is exactly zero is not an axis.
//
// A tilted axis n + e n_2 is decided over numbers with an infinitesimal e (Dual). Then h(n + e n_2) is exact up to
// e^2, and (n + e n_2).v is of size e at least. So n + e n_2 proves every bound below t, as e tends to 0, and hence t.
// For the same reason a strict inequality holds for all small enough e.
#pragma once

#include <graze/proof.hpp>
#include <optional>

#include "oracles/checker/symbolic_axis.hpp"

namespace graze::oracle {

struct AxisQuestion {
  const Solid& a;
  const Solid& b;
  const Proof& proof;
  double target_distance;

  [[nodiscard]] bool rounded() const { return a.radius > 0 || b.radius > 0 || target_distance > 0; }
};

struct Scans {
  Scan a, b;
};

// Does D + w R |n| lie below zero (or at zero, unless strict)? weighted_radius() is w R.
template <class N, class Radius>
[[nodiscard]] Answer below_zero(bool rounded, const Radius& weighted_radius, const Triple<N>& n, const N& d,
                                bool strict) {
  const Sign s = sign(d);
  const Answer side = strict ? is_negative(s) : at_most_zero(s);
  if (!rounded || side == Answer::no) return side;
  const N radius = weighted_radius();
  const Sign excess = sign(d * d - radius * radius * dot(n, n));
  return both(side, strict ? is_positive(excess) : at_least_zero(excess));
}

// w (H + offset part), the exact maximum up to N's error.
template <class N>
[[nodiscard]] N weighted_support(const AxisQuestion& ask, const Pair<N>& pair, const Triple<N>& n,
                                 Scans& scans) {
  const N of_a = support(ask.a.core, pair.a.into_body(n), scans.a);
  const N of_b = support(ask.b.core, pair.b.into_body(-n), scans.b);
  return pair.weigh(dot(n, pair.offset)) + (pair.b.rotated ? pair.b.weight * of_a : of_a) +
         (pair.a.rotated ? pair.a.weight * of_b : of_b);
}

enum class AxisFinding { holds, zero_axis, not_approaching, fails, unknown };

[[nodiscard]] constexpr AxisFinding finding(Answer answer) {
  return answer == Answer::yes  ? AxisFinding::holds
         : answer == Answer::no ? AxisFinding::fails
                                : AxisFinding::unknown;
}

// TOI >= t, for 0 < t < infinity. below(x, strict) answers whether h(n) - x < 0, or <= 0 unless strict.
template <class N, class Below>
[[nodiscard]] AxisFinding lower_finding(const Approach<N>& approach, double t, const Below& below) {
  if (approach.negative == Answer::no) return AxisFinding::not_approaching;
  const Answer held = below(approach.value * t, false);
  return approach.negative == Answer::unknown ? AxisFinding::unknown : finding(held);
}

// No contact in [0, T].
template <class N, class Below>
[[nodiscard]] AxisFinding miss_finding(const Approach<N>& approach, double horizon, const Below& below) {
  const Answer at_start = below(N(0), true);
  if (at_start == Answer::no) return AxisFinding::fails;
  if (approach.negative == Answer::no) return finding(at_start);
  if (horizon == kInfinity<double>)
    return approach.negative == Answer::yes ? AxisFinding::fails : AxisFinding::unknown;
  // With n.v < 0 the end of the path is the stronger demand. With n.v >= 0 it is implied by the start.
  return finding(both(at_start, below(approach.value * horizon, true)));
}

// The claim toi_lower of an axis on the path [0, T].
struct LowerClaim {
  double toi_lower, horizon;

  [[nodiscard]] bool is_miss() const { return toi_lower == kInfinity<double>; }
  // `zero`: is n zero? While that is open, so is every finding that a zero n would share.
  template <class N, class Below>
  [[nodiscard]] AxisFinding decide(Answer zero, const Approach<N>& approach, const Below& below) const {
    if (zero == Answer::yes) return AxisFinding::zero_axis;
    const AxisFinding found =
        is_miss() ? miss_finding(approach, horizon, below) : lower_finding(approach, toi_lower, below);
    return zero == Answer::unknown && found != AxisFinding::holds ? AxisFinding::unknown : found;
  }
};

// A claim, and whether the axis proves a second bound too, if one is asked about.
struct LowerClaims {
  LowerClaim claim;
  std::optional<double> raised = {};
};

struct AxisFindings {
  AxisFinding claim, raised = AxisFinding::fails;

  [[nodiscard]] friend bool is_open(const AxisFindings& found) {
    return found.claim == AxisFinding::unknown || found.raised == AxisFinding::unknown;
  }
};

template <class N, class Below>
[[nodiscard]] AxisFindings decide(const LowerClaims& claims, Answer zero, const Approach<N>& approach,
                                  const Below& below) {
  AxisFindings found{claims.claim.decide(zero, approach, below)};
  if (claims.raised)
    found.raised = LowerClaim{*claims.raised, claims.claim.horizon}.decide(zero, approach, below);
  return found;
}

template <class N>
[[nodiscard]] AxisFindings axis_claims(const AxisQuestion& ask, const LowerClaims& claims, Scans& scans) {
  const Pair<N> pair(ask.a, ask.b);
  const Triple<N> plain = axis_vector(ask.a, ask.b, pair, ask.proof);
  const Triple<N> n = tilted(ask.proof, plain, pair.velocity,
                             [&] { return factor_in_world(ask.a, ask.b, pair, ask.proof.factor[0]); });
  const N high = weighted_support(ask, pair, n, scans);
  const auto radius = [&] { return pair.weigh(N(ask.a.radius) + N(ask.b.radius) + N(ask.target_distance)); };
  return decide(claims, is_zero(plain), approach_along(ask.proof, n, pair.velocity),
                [&](const N& x, bool strict) {
                  return below_zero(ask.rounded(), radius, n, high - pair.weigh(x), strict);
                });
}

}  // namespace graze::oracle
