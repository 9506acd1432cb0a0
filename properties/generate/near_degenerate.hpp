// Cases whose every decision is a near-tie, for filters and last supports.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// Polytopes: faces whose corners lie in one plane but for the rounding of their coordinates (boxes turned,
// then rounded), and a path aimed, up to rounding, at a point of an edge or a vertex that C shows along v, or
// at a point of such a face.
[[nodiscard]] corpus::Case draw_near_tie(corpus::Random& random);

// Two hulls at rest, face to face, which touch or are apart by as much as the corners of either face differ in height:
// what floats cannot tell, and doubles can. A vertex guessed by floats is not the farthest one, and whether the bodies
// touch hangs on it.
[[nodiscard]] corpus::Case draw_near_touch(corpus::Random& random);

}  // namespace graze::law
