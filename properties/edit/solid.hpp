// Has a shape an inside? For what makes cases small, and is to leave bodies what they were.
#pragma once

#include "corpus/case.hpp"

namespace graze::law {

// True of balls, boxes and curved shapes none of whose extents is 0, of hulls of which four vertices span a tetrahedron
// whose height is no less than 1e-6 of its size, and of combinators that have a part or a radius with an inside. Flat
// parts that span a solid together count as none: of them nothing is said.
[[nodiscard]] bool is_solid(const Shape<double>& shape);

}  // namespace graze::law
