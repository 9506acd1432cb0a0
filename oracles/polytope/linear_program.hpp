// The second opinion on a polytope's TOI and distance: programs over the vertices as given, no CSO, no hull.
#pragma once

#include <optional>
#include <utility>

#include "corpus/case.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

// The least t in [0, T] with t v in C; nothing for a miss. Bodies that exact_body.hpp represents, with radii
// of zero, no target distance: std::invalid_argument otherwise.
[[nodiscard]] std::optional<Rational> toi_by_linear_program(const corpus::Case& problem);

// The least and the greatest t in R with t v in C, v != 0 (std::invalid_argument); nothing if there is none.
[[nodiscard]] std::optional<std::pair<Rational, Rational>> contact_times_by_linear_program(
    const corpus::Case& problem);

// The squared distance of t v from the hull of the differences (radii and target distance not counted), t
// finite.
[[nodiscard]] Rational distance_sq_by_quadratic_program(const corpus::Case& problem, const Rational& t);

}  // namespace graze::oracle
