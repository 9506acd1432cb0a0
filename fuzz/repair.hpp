// Prepares a decoded case for a target: fields that its question has no room for are set aside, so that nearly every
// input is a question. Invalid cases stay invalid.
#pragma once

#include "corpus/case.hpp"

namespace graze::fuzz {

// A cast of bodies that do not rotate.
[[nodiscard]] corpus::Case as_linear(corpus::Case problem);

// A rotating cast over a finite step, with the policy report and at most kMostRadians, because the cost of every method
// grows with the angle. A larger spin loses whole powers of two.
inline constexpr double kMostRadians = 64;
[[nodiscard]] corpus::Case as_turning(corpus::Case problem);

// Cases that CGAL decides in a millisecond: identity poses, and polytopes of at most kFewVertices vertices. A hull
// keeps its first ones. A round shape becomes the box around it, a combinator its first part.
inline constexpr std::size_t kFewVertices = 8;
[[nodiscard]] corpus::Case as_few_vertices(corpus::Case problem);

}  // namespace graze::fuzz
