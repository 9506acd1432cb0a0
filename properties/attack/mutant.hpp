// Mutants of true proofs: the changes, by class.
//
// Small changes keep a proof true often enough to be accepted. Large ones should be refused. Both kinds are made, one
// to a few on one mutant, so that accepted mutants are not only those with tiny changes.
#pragma once

#include <array>
#include <bitset>
#include <string_view>

#include "corpus/format/proof_io.hpp"
#include "corpus/random.hpp"

namespace graze::attack {

// The classes. Changes of the case under the proof:
enum class Edit : std::uint8_t {
  pivot,          // of a rotating body
  resting_pivot,  // of a body at rest: without meaning, so such a mutant counts by its other changes
  placing,        // position, orientation
  motion,         // displacement, rotation vector
  extent,         // radii, half extents, vertices, parts
  horizon,        // t_max, target distance, start policy
  shape,          // another shape of the same bounding box, or the same set written otherwise
  // Changes of the proof:
  frame,    // of a slice
  end,      // of a slice: earlier, later, merged, dropped
  axis,     // of a slice or of a linear proof
  index,    // the vertices and points that contact, portal and symbolic axis name
  order,    // slices exchanged, reversed, repeated
  weights,  // of the contact; crossing and its beginning
  // Changes of the claim:
  bracket,
  outcome,  // and the rest of the record's statement beside its proof: bracket, tier
};
inline constexpr std::size_t kEdits = 15, kCaseEdits = 7;
inline constexpr std::array<std::string_view, kEdits> kEditNames = {
    "pivot", "resting_pivot", "placing", "motion", "extent",  "horizon", "shape",  "frame",
    "end",   "axis",          "index",   "order",  "weights", "bracket", "outcome"};
using Edits = std::bitset<kEdits>;

struct Mutant {
  corpus::ProofRecord record;
  Edits edits;  // the classes in which something changed
};

// Applies one change of that class, if the record has anything of the kind, and marks it where it changed the
// meaning (meaning.hpp), or the number, of a resting pivot.
void edit(Mutant& mutant, Edit kind, corpus::Random& random);
// The claim made weaker: what a changed case or chain may still prove.
void loosen(Mutant& mutant, corpus::Random& random);
// The claim that the chain, as long as it is now, would make.
void claim_what_the_chain_reaches(Mutant& mutant, corpus::Random& random);
// The shortest chain there is, for the largest claim: a miss, by one axis in one frame.
void claim_a_miss_by_one_slice(Mutant& mutant, corpus::Random& random);

// x, a little or a lot off.
[[nodiscard]] double beside(double x, corpus::Random& random);

// The parts, each in a file of its own.
void edit_case(corpus::ProofRecord& record, Edit kind, corpus::Random& random);
void edit_chain(corpus::ProofRecord& record, Edit kind, corpus::Random& random);
void edit_named_points(corpus::ProofRecord& record, Edit kind, corpus::Random& random);
[[nodiscard]] Shape<double> written_otherwise(const Shape<double>& shape, corpus::Random& random);

}  // namespace graze::attack
