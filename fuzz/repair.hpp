// What a target makes of a decoded case before it asks: the fields that its question has no room for are set
// aside, so that nearly every input is a question. What must be refused stays what it is.
#pragma once

#include "corpus/case.hpp"

namespace graze::fuzz {

// A cast of bodies that do not turn.
[[nodiscard]] corpus::Case as_linear(corpus::Case problem);

// A rotating cast over a finite step, by the policy report, by no more than kMostRadians: the cost of every
// method grows with the angle. A spin beyond loses whole powers of two.
inline constexpr double kMostRadians = 64;
[[nodiscard]] corpus::Case as_turning(corpus::Case problem);

// What CGAL decides in a millisecond: identity poses, and polytopes of at most kFewVertices vertices. Of a
// hull the first ones; a round shape becomes the box around it, a combinator its first part.
inline constexpr std::size_t kFewVertices = 8;
[[nodiscard]] corpus::Case as_few_vertices(corpus::Case problem);

}  // namespace graze::fuzz
