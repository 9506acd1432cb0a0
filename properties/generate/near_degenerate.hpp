// Cases whose every decision is a near-tie, for filters and last supports.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Polytopes with faces whose corners lie in one plane within the rounding of their coordinates (boxes rotated, then
// rounded). The path is aimed, up to rounding, at a point of an edge or a vertex that C shows along v, or at a point of
// such a face.
[[nodiscard]] corpus::Case draw_near_tie(corpus::Random& random);

// Two hulls at rest, face to face. They touch or are apart by as much as the corners of either face differ in height.
// Floats cannot tell these cases apart, and doubles can. A vertex guessed by floats is not the farthest one, and the
// contact depends on it.
[[nodiscard]] corpus::Case draw_near_touch(corpus::Random& random);

}  // namespace graze::law
