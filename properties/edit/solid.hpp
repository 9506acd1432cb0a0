// Has a shape an inside? For code that makes cases small and has to keep the nature of the bodies.
#pragma once

#include "corpus/case.hpp"

namespace graze::law {

// True in three cases:
//
// - balls, boxes and curved shapes with no extent of 0
// - hulls with four vertices that span a tetrahedron whose height is no less than 1e-6 of its size
// - combinators that have a part or a radius with an inside
//
// Flat parts that span a solid together do not count as solid: the function makes no claim about them.
[[nodiscard]] bool is_solid(const Shape<double>& shape);

}  // namespace graze::law
