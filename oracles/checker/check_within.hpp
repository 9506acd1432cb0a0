// Checks a proof that is true except for its writer's rounding: is it true of shapes near the given ones?
//
// Notation   as in graze/proof.hpp: C = A - B + ball(m), v, h(n).   lower, upper: the proof's bounds.
//   r   a length, how near.   A convex set S is within r of C if every point of either lies within r of the other.
//
// The claim that is decided: there is one convex set S within r of C for which the whole proof holds. S has
// no t v with 0 <= t < lower (for a miss, none in [0, T]), and some s v with 0 <= s <= min(T, upper).
// It is accepted if either of these is shown, exactly, by the checker (check_proof.hpp) on a case made for it:
//
//   1  the proof is accepted as it is. S = C.
//   2  each half that it claims is accepted, for its own set,
//        lower   by the same axis of C + d, d a vector no longer than r: against the axis, or against the time, along v, if
//                the axis is symbolic and claims a bound of t. S = S0 = C + d.
//        upper   by the same portal of C + ball(r): a combination of its pairs lies within m + r of s v, with
//                lower <= s <= min(T, upper). Points of it that lie outside of their ball or their curved part are
//                pulled inwards first, by at most r/16 each, and lie inside then.   S = S1 = C + ball(r).
//
// Both halves together are claims about one set. Let H be the half-space {c : n.c <= lower (n.v)}: the axis
// shows S0 within H, and n.v < 0. Let p = s v, the portal's point of S1, with s >= lower. Then n.p = s (n.v)
// <= lower (n.v), so p lies in H as well. Take S = conv(S0 and p). It lies in H, which holds no t v with t <
// lower, and it has p = s v. It is within r of C: S0 <= S <= S1, each point of S1 lies within r of C, and
// each point of C within r of S0. Without lower <= s, the two halves may be claims about sets with no common
// S between them: a path that grazes C is claimed to meet it later. A miss has one half, and so has a start
// in contact.
//
// Every number that is made here is exact, or rounded so that less is granted. An accepted proof is therefore
// accepted without rounding. A symbolic axis of a miss gets no slack, and neither do rotating proofs.
#pragma once

#include "corpus/format/proof_io.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/check_record.hpp"

namespace graze::oracle {

// `length`: r, not negative. The reason of a refusal is that of the exact checker.
[[nodiscard]] Verdict check_proof_within(const corpus::Case& problem, const Proof& proof, double length);

// kappa u scale, u the unit roundoff of the scalar that the record names, rounded down.
[[nodiscard]] double rounding_granted(const corpus::ProofRecord& record, double kappa);

// The slack granted to a record, in units of u scale. One value is for its proof, which its writer may have
// rounded. The other is for the bracket that it states in tier standard, which its method's guarantee grants.
// A bracket is granted the larger of the two.
struct Kappas {
  double of_proof = 0, of_bracket = 0;
};

// check_record with that granted. `exactly`: whether the proof needed none of it.
[[nodiscard]] RecordVerdict check_record_within(const corpus::ProofRecord& record, Kappas kappa,
                                                bool* exactly = nullptr);

// The scale of docs/reference/guarantees.md from below, in doubles: by no more than a hundredth, unless the bodies' coordinates are
// 1e13 times as large.
[[nodiscard]] double scale_from_below(const corpus::Case& problem);

}  // namespace graze::oracle
