// Rounding errors of bodies that lie far out in their own frames, or whose parts do, beyond those that the scale covers
// (docs/reference/guarantees.md).
#pragma once

#include "corpus/case.hpp"

namespace graze::law {

// A length: the sum of all lengths that define the two shapes, once for each of their numbers, and twice more.
[[nodiscard]] double weight_of_own_frames(const corpus::Case& problem);

// A length, kOwnFramesOfCertified times that. Points of tier certified are known within 2^-95 of the lengths that
// define a shape, for each of its nodes (named_point.hpp). A portal's corners across the line are known within e, four
// times that. The portal needs a triangle whose area is 16 times the 3 * 8 e m that its sides of length m may be off by
// (proving/certified_portal.hpp): one that is 2^9 e high. Axes of proofs lose less: 2^-90 of those lengths (prove.hpp).
[[nodiscard]] double unseen_of_own_frames(const corpus::Case& problem);

// Error bound (a length) on the position of a rotating body: 2^-89 times the sum of its distances from the origin, its
// pivot and its centre, and of its travel (moving_pair.hpp). Each end of a bracket and both sides of a graze have twice
// that.
[[nodiscard]] double unseen_of_turns(const corpus::Case& problem);

// A length, for the standard tier: positions under k rotations within a combinator round by 23 k u of a double, both in
// the place of a point and in the choice of the point (tree.hpp). `scale`: the part that kappa counts already.
[[nodiscard]] double unseen_of_trees(const corpus::Case& problem, double scale);

}  // namespace graze::law
