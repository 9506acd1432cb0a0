// The meaning of a proof record, by which two of them can be compared: case, claim, and chain or axis and portal, each
// in a normal form.
//
// The normal form drops everything without a meaning:
//
// - in the case: id and comments, the pivot of a body that does not rotate, the length and the sign of a quaternion
// - in a chain: the length of axes, slices of no duration, cuts between slices of one axis, the frame of a body that
//   does not rotate or that rotates about the axis itself
// - in a contact or a portal: the order of pairs, pairs of weight zero, the sum of the weights, everything if no
//   upper bound is claimed
// - in a linear axis: its length, the order of a cross product's factors up to the sign, everything if no lower bound
//   is claimed
#pragma once

#include <vector>

#include "corpus/format/proof_io.hpp"

namespace graze::attack {

// Numbers in a fixed order. Directions and weights are equal within kSameDirection.
struct Meaning {
  struct Part {
    double x = 0;
    bool rounded = false;
  };
  std::vector<Part> parts;
};

// A direction is divided by its largest component, weights by their sum, with one rounding each. Two values count as
// different only beyond some units in the last place.
inline constexpr double kSameDirection = 0x1p-50;

// with_statement: includes the record's statement beside its proof (outcome, bracket and tier) in the claim.
[[nodiscard]] Meaning meaning_of(const corpus::ProofRecord& record, bool with_statement);
[[nodiscard]] bool same(const Meaning& one, const Meaning& other);

// Is there a time of first contact, possibly never within the step, that agrees with the record's outcome and bracket
// and with its proof? If no such time exists, one of them is false whatever the case is.
[[nodiscard]] bool has_a_time(const corpus::ProofRecord& record);

}  // namespace graze::attack
