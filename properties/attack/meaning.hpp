// What a proof record says, so that two of them can be asked whether they say the same: case, claim, and
// chain or axis and portal, each in a normal form.
//
// The normal form forgets what has no meaning. Of the case: id and comments, the pivot of a body that does
// not turn, the length and the sign of a quaternion. Of a chain: the length of axes, slices of no duration,
// cuts between slices of one axis, the frame of a body that does not turn or that turns about the axis
// itself. Of a contact or a portal: the order of pairs, pairs of weight zero, the sum of the weights,
// everything where no upper bound is claimed. Of a linear axis: its length, the order of a cross product's
// factors up to the sign, everything where no lower bound is claimed.
#pragma once

#include <vector>

#include "corpus/format/proof_io.hpp"

namespace graze::attack {

// Numbers in a fixed order; those of directions and of weights are the same within kSameDirection.
struct Meaning {
  struct Part {
    double x = 0;
    bool rounded = false;
  };
  std::vector<Part> parts;
};

// A direction is divided by its largest component, weights by their sum, with a rounding each: two of either
// are told apart beyond some units in the last place only.
inline constexpr double kSameDirection = 0x1p-50;

// with_statement: is what the record states beside its proof, outcome, bracket and tier, part of the claim?
[[nodiscard]] Meaning meaning_of(const corpus::ProofRecord& record, bool with_statement);
[[nodiscard]] bool same(const Meaning& one, const Meaning& other);

// Is there a first contact, at some time or never within the step, that is as the record states, by its
// outcome and by its bracket, and as its proof proves? If there is none, one of them is false whatever the
// case is.
[[nodiscard]] bool has_a_time(const corpus::ProofRecord& record);

}  // namespace graze::attack
