// The third opinion on a solid CSO, its line and its depth: CGAL's Minkowski sum of Nef polyhedra, A + (-B).
#pragma once

#include <optional>
#include <utility>

#include "corpus/case.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

struct NefCso {
  struct HalfSpace {  // {x : normal.x <= offset}
    RationalPoint normal;
    Rational offset;
  };
  std::vector<RationalPoint> vertices;  // the extreme points, sorted
  std::vector<HalfSpace> half_spaces;   // one a face

  // {t in R : t v in C}, v != 0. Nothing if it is empty.
  [[nodiscard]] std::optional<std::pair<Rational, Rational>> clip(const RationalPoint& v) const;
  // The squared distance of the origin, which must be inside (std::logic_error), from the boundary.
  [[nodiscard]] Rational depth_sq() const;
};

// For two polytopes of few vertices and any dimension, whose CSO is solid. Anything else throws
// std::invalid_argument.
[[nodiscard]] NefCso nef_cso(const corpus::Case& problem);

}  // namespace graze::oracle
