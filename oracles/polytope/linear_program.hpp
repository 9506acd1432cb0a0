// The second opinion on a polytope's TOI and distance: programs over the vertices as given, no CSO, no hull.
#pragma once

#include <optional>
#include <utility>

#include "corpus/case.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

// The least t in [0, T] with t v in C, or nothing for a miss. The bodies must be ones that exact_body.hpp
// represents, with radii of zero and no target distance. Otherwise it throws std::invalid_argument.
[[nodiscard]] std::optional<Rational> toi_by_linear_program(const corpus::Case& problem);

// The least and the greatest t in R with t v in C, or nothing if there is no such t. v = 0 throws
// std::invalid_argument.
[[nodiscard]] std::optional<std::pair<Rational, Rational>> contact_times_by_linear_program(
    const corpus::Case& problem);

// The squared distance of t v from the hull of the differences (radii and target distance not counted), t
// finite.
[[nodiscard]] Rational distance_sq_by_quadratic_program(const corpus::Case& problem, const Rational& t);

}  // namespace graze::oracle
