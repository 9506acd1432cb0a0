// Questions beside the cast, made from a linear case: the same bodies with another query.
#pragma once

#include <cstddef>

#include "corpus/case.hpp"
#include "engines/method.hpp"

namespace graze::law {

// A line queries the motion as it is. A swept overlap queries it, or one that continues in the same way far longer. The
// others are queried at rest, without a target distance: B stands at its place on the path at one of a few times,
// chosen by `pick`. Most of the families aim at t = 1/2, so the bodies are apart, near, just in each other or deep in
// each other. The direction of penetration_along is the motion's. Starts are reported, and nothing is expected.
[[nodiscard]] corpus::Case question_for(corpus::Case problem, corpus::Query query, std::size_t pick);

// The case in the scalar of the method, as doubles.
[[nodiscard]] corpus::Case seen_by(const engine::Method& method, const corpus::Case& problem);

// The first method of a query in a scalar.
[[nodiscard]] const engine::Method& default_method(corpus::Query query, std::string_view scalar);

}  // namespace graze::law
