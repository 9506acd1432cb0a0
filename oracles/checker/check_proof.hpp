// The checker of linear proofs: exact, and it shares nothing with the search (it includes core's input types
// and the proof value, and none of core's algorithms).
//
// Scope: decides exactly whether the claims of a Proof hold for the true shapes of a case.
//   - Polytopes plus a ball (point, segment, triangle, sphere, capsule, box, hull) are decided in double with a
//     running error bound, open claims then in double-double, and claims that are still open in GMP.
//   - For every other shape, axes are decided in double, axes without square roots then in double-double, then
//     in balls of 128 to 4,096 bits, then with exact sums and products. Portals are decided as above.
// A symbolic axis is computed in the arithmetic at hand, so its result is exact too. The points of its
// factors may lie anywhere, as every vector but zero is an axis. A nearest axis and a portal of cores are about
// polytopes plus a ball, combined ones included, and take no square roots. Claims about a point and an ellipsoid, a
// cylinder or a cone that name no axis or no portal are decided in rational numbers (ray_claim.hpp).
//
// Cost: tight proofs, 8 to 16 vertices, median, in microseconds (bench/check_proof_bench.cpp).
//   proof                                                    identity poses   rotated poses
//   polytopes plus a ball                                    1.2              2.4
//   the same by the symbolic axis of a facet of C            1.4              2.7
//   the same, a ray's miss by v x edge                       0.2              0.3
//   any other shape                                          3 to 5           8 to 12
//   a hull swept along a segment, by its symbolic facet      3.2              6.1
// The checker allocates nothing unless it refuses or needs GMP. No tight claim of 2,773 random facets needed
// GMP (tests/oracles/checker/symbolic_proof_test.cpp).
//
// Limits:
//   - A case with a magnitude outside 1e-60 .. 1e60 is refused as out_of_range. The proof's own numbers may be
//     any finite doubles.
//   - A shape of more than 64 levels or 4,096 parts is unsupported.
//   - An upper bound under the policy pass_over without a lower one above 0 is unsupported, because a start
//     that leaves makes it void.
//   - A claim that 4,096 bits leave open is undecided. It is never a tie (tree_support.hpp), only roots that
//     differ by less.
#pragma once

#include <graze/proof.hpp>
#include <string>

#include "corpus/case.hpp"
#include "oracles/checker/stages.hpp"

namespace graze::oracle {

// The first claim that fails, in the order in which they are checked.
enum class Refusal {
  none,             // accepted
  malformed,        // NaN, a part without a shape, a portal size out of 0..4, an index beyond the vertices,
                    // a feature with more than kCurvedParts curved parts, a bound below zero, an axis_sign
                    // other than 1 and -1, a factor of no known kind, a nearest axis of three directions
                    // or more, a pair of cores with an offset
  unsupported,      // a case that this checker does not know (rotation, a shape of too many parts), or
                    // cores of a curved shape or of a hull of shapes
  out_of_range,     // a non-zero magnitude of the case outside 1e-60 .. 1e60
  offset_too_long,  // |offset| > the sum of the radii on the way to the vertex
  point_outside,    // a point of a curved part outside that part
  axis_missing,     // toi_lower > 0 without an axis, or a zero axis, exactly
  axis_not_approaching,  // 0 < toi_lower < infinity, and n.v >= 0
  lower_not_proved,      // toi_lower > h(n)/(n.v)
  miss_not_proved,       // toi_lower infinite, and h(n) >= min(0, T n.v)
  portal_missing,        // toi_upper finite without a portal
  portal_off_path,       // no convex combination of the pairs lies on the line (within m of it)
  upper_not_proved,      // the combination lies at s v with s > toi_upper, or s < 0, or s > T
  undecided,             // the axis's claim is too close for the precision that is tried
};

[[nodiscard]] const char* to_string(Refusal refusal);

struct Verdict {
  Refusal refusal = Refusal::none;
  std::string detail;  // one line with the claim and the true value, empty when accepted
  [[nodiscard]] bool accepted() const { return refusal == Refusal::none; }
};

// The share of the work that the filters settled (for the cost table). It is filled when given.
struct CheckCost {
  long long double_decisions = 0, extended_decisions = 0, exact_decisions = 0;
  long long ball_decisions = 0;  // by balls of 128 to 4,096 bits
};

[[nodiscard]] Verdict check_proof(const corpus::Case& problem, const Proof& proof, CheckCost* cost = nullptr,
                                  Stages stages = Stages::all);

// For an accepted proof with toi_lower < toi_upper < infinity: would it be accepted with either bound moved
// to the other? A proof with tight bounds would not. False for any other proof.
struct MovedBounds {
  bool lower_accepted = false;  // toi_lower raised to toi_upper
  bool upper_accepted = false;  // toi_upper lowered to toi_lower
};

// The verdict of check_proof on the proof and on these two, for hardly more than the cost of one check.
[[nodiscard]] Verdict check_bracket(const corpus::Case& problem, const Proof& proof, MovedBounds& moved,
                                    CheckCost* cost = nullptr);

}  // namespace graze::oracle
