// What rounding does not see of bodies that lie far out in their own frames, or whose parts do, beyond what
// the scale says (docs/guarantees.md).
#pragma once

#include "corpus/case.hpp"

namespace graze::law {

// A length: the sum of all lengths that the two shapes are given by, once for each number of theirs, and twice more.
[[nodiscard]] double weight_of_own_frames(const corpus::Case& problem);

// A length, kOwnFramesOfCertified of that. Points of tier certified are known within 2^-95 of the lengths that a shape is made of, for each
// of its nodes (named_point.hpp), a portal's corners across the line within e, four times that, and it takes
// a triangle whose area is 16 times the 3 * 8 e m that its sides of length m may be off by
// (proving/certified_portal.hpp): one that is 2^9 e high. Axes of proofs lose less: 2^-90 of those lengths
// (prove.hpp).
[[nodiscard]] double unseen_of_own_frames(const corpus::Case& problem);

// A length. Where a turning body is, is known within 2^-89 of its distance from the origin, its pivot and its
// centre, and of its way (moving_pair.hpp); each end of a bracket, and both sides of a graze, twice that.
[[nodiscard]] double unseen_of_turns(const corpus::Case& problem);

// A length. Of the standard tier: positions under k rotations within a combinator round by 23 k u of a
// double, both where a point lies and which one is chosen (tree.hpp). `scale`: what kappa counts
// already.
[[nodiscard]] double unseen_of_trees(const corpus::Case& problem, double scale);

}  // namespace graze::law
