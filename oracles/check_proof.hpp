// The checker of linear proofs: exact, and it shares nothing with the search (it includes core's input types
// and the proof value, and none of core's algorithms).
//
// What it decides: whether the claims of a Proof hold for the true shapes of a case, exactly: in double with
// a running error bound, what is open then in double-double, what is still open in GMP. What it costs: about
// 1 microsecond at 8 to 16 vertices a shape, 2.5 with rotated poses (bench/check_proof_bench.cpp), without
// allocating unless it refuses or needs GMP. Where it does not decide: a case with a magnitude outside
// 1e-60 .. 1e60 is refused as out_of_range; the proof's own numbers may be any finite doubles. Upper bounds
// under the policy pass_over are unsupported (a leaving start makes them void).
#pragma once

#include <graze/proof.hpp>
#include <string>

#include "corpus/case.hpp"

namespace graze::oracle {

// The first claim that fails, in the order in which they are checked.
enum class Refusal {
  none,                  // accepted
  malformed,             // NaN, a portal size out of 0..4, an index beyond the vertices, a bound below zero
  unsupported,           // a case that this checker does not know (rotation, an unknown shape)
  out_of_range,          // a non-zero magnitude of the case outside 1e-60 .. 1e60
  offset_too_long,       // |offset| > radius
  axis_missing,          // toi_lower > 0 without an axis, or a zero axis
  axis_not_approaching,  // 0 < toi_lower < infinity, and n.v >= 0
  lower_not_proved,      // toi_lower > h(n)/(n.v)
  miss_not_proved,       // toi_lower infinite, and h(n) >= min(0, T n.v)
  portal_missing,        // toi_upper finite without a portal
  portal_off_path,       // no convex combination of the pairs lies on the line (within m of it)
  upper_not_proved,      // the combination lies at s v with s > toi_upper, or s < 0, or s > T
};

[[nodiscard]] const char* to_string(Refusal refusal);

struct Verdict {
  Refusal refusal = Refusal::none;
  std::string detail;  // one line: the claim, and what is true instead; empty when accepted
  [[nodiscard]] bool accepted() const { return refusal == Refusal::none; }
};

// How much of the work the filters settled (for the cost table); filled when given.
struct CheckCost {
  long long double_decisions = 0, extended_decisions = 0, exact_decisions = 0;
};

[[nodiscard]] Verdict check_proof(const corpus::Case& problem, const Proof& proof, CheckCost* cost = nullptr);

}  // namespace graze::oracle
