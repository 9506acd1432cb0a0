// A round body that is met on its flank. There both rims of a cylinder, or the apex of a cone and a point of its rim,
// are as far along the normal, and the rounding of a rotation decides which of them is named.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::law {

// The round part is rotated inside its body, and the body itself is rotated. B, a point or a ball, comes at it from
// anywhere above the flank and meets it between its ends, up to rounding. A pure function of the random bits, the same
// everywhere.
[[nodiscard]] corpus::Case draw_round_tie(corpus::Random& random);

}  // namespace graze::law
