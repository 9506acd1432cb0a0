// Hulls large enough for a map of directions (direction_map.hpp), with adjacency, met where the map may be wrong.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// A hull of kMapFrom vertices or a few more, of one of these kinds:
//
// - on an ellipsoid, thin or not
// - on a lattice, with many vertices in one plane
// - two rings, or one and an apex
// - clusters that are one point to a float
// - pairs that change places, as the farthest, at a border of the map's squares
//
// Some are far from their origin. The hull meets the face of a box that is turned to it, a point, a ball, a triangle, a
// box or another such hull. They meet head on, obliquely, or sliding over its top by next to nothing. A pure function
// of the random bits.
[[nodiscard]] corpus::Case draw_large_hull(corpus::Random& random);

// The same, and one or both of them rotate.
[[nodiscard]] corpus::Case draw_turning_large_hull(corpus::Random& random);

}  // namespace graze::law
