// The checker of rotating proofs: it shares nothing with the search (it includes core's input types and the
// proof value, and none of core's algorithms).
//
// Scope: decides whether the claims of a RotatingProof (graze/rotating_proof.hpp) hold for the true shapes
// and motions of a case.
//   - Every slice of the chain, including any part beyond toi_lower. The check uses the separation along the
//     axis at the ends of the slice and a bound on how far it sinks between them, from the points' second
//     derivatives or their speed (ball_motion.hpp). If that does not suffice, the slice is cut in halves, and
//     each is checked again. The arithmetic is double with a running error bound (slice_filter.hpp), then balls
//     of 128, 256 and 512 bits. The balls also use the cylinders that rotating bodies sweep in whole turns
//     (whole_turns.hpp).
//   - The chain. Its slices follow each other from t = 0 to toi_lower, and for a miss to t_max.
//   - The contact at toi_upper, which is at most t_max. Either the pairs' points where the bodies carry them,
//     by the weights or by strict containment, in balls. Or the crossing of the origin through the triangle of
//     three pairs between contact_from and toi_upper, by the sign of a volume at its two ends, and balls that
//     hold all times between (crossing_claim.hpp has the argument). It is cut in halves as a slice is.
//
// Cost (printed by tests/oracles/checker/rotating_trial_test.cpp, with balls, boxes, segments, all three
// frames): a slice takes 0.9 microseconds in double and 12 to 15 in balls, as often as it is cut. A proof
// takes 15 more, for reading its case. All of 10,745 tight slices up to 1e-9 of first contact were proved in
// double.
//
// Limits:
//   - A magnitude of the case outside 1e-60 .. 1e60 is out_of_range.
//   - A shape of more than 64 levels or 4,096 parts is unsupported, and so is an upper bound under the policy
//     pass_over without a lower one above 0.
//   - Points outside every ball that touch exactly (a rod that lies on a rod) prove no contact by weights while
//     a rotation makes their places irrational. The result is undecided.
//   - A crossing is examined along one direction, the triangle's normal in the middle of the time. A crossing
//     that only other directions show is refused.
#pragma once

#include <graze/rotating_proof.hpp>
#include <string>

#include "corpus/case.hpp"
#include "oracles/checker/stages.hpp"

namespace graze::oracle {

// The first claim that fails, in the order in which they are checked.
enum class RotatingRefusal {
  none,          // accepted
  malformed,     // NaN, a part without a shape, a contact_size out of 0..6, an index beyond the vertices, a
                 // feature with more than kCurvedParts curved parts, a crossing with an offset, a bound below
                 // zero, a slice that ends before it begins, a frame of no known kind; a crossing with other
                 // than three pairs, or a contact_from that is not in [0, toi_upper)
  unsupported,   // a case that this checker does not know
  out_of_range,  // a non-zero magnitude of the case outside 1e-60 .. 1e60
  chain_too_short,      // the last slice ends before toi_lower, of a miss before t_max
  axis_missing,         // a slice with a zero axis
  slice_false,          // at some time of a slice its axis does not separate the bodies by more than m
  slice_not_proved,     // neither that nor its separation is shown within kMostPieces pieces
  contact_missing,      // toi_upper finite without a pair
  upper_beyond_end,     // toi_upper beyond t_max, where nothing moves
  point_outside,        // a point of a curved part outside that part
  weights_missing,      // other than four pairs, and weights below zero or none above
  contact_not_proved,   // the weighted points stay apart, and no four hold the origin strictly inside
  crossing_not_proved,  // the line along the normal is not shown to stay inside the triangle, or the origin
                        // does not change its side
  undecided,            // too close for 512 bits
};

[[nodiscard]] const char* to_string(RotatingRefusal refusal);

struct RotatingVerdict {
  RotatingRefusal refusal = RotatingRefusal::none;
  std::string detail;  // one line with the claim and the true value, empty when accepted
  [[nodiscard]] bool accepted() const { return refusal == RotatingRefusal::none; }
};

// Pieces that one slice is cut into at most.
inline constexpr int kMostPieces = 4096;

// The amount of work. It is added to when given.
struct RotatingCheckCost {
  long long slices = 0;     // slices that were examined
  long long in_double = 0;  // slices that the filter proved
  long long pieces = 0;     // pieces that they were cut into, in double and in balls
  long long raised = 0;     // slices and contacts that 128 bits left open
};

[[nodiscard]] RotatingVerdict check_rotating_proof(const corpus::Case& problem, const RotatingProof& proof,
                                                   RotatingCheckCost* cost = nullptr,
                                                   Stages stages = Stages::all);

}  // namespace graze::oracle
