// The third opinion on a solid CSO: CGAL's Minkowski sum of Nef polyhedra, A + (-B).
#pragma once

#include <optional>
#include <utility>

#include "corpus/case.hpp"
#include "oracles/rational.hpp"

namespace graze::oracle {

struct NefCso {
  struct HalfSpace {  // {x : normal.x <= offset}
    RationalPoint normal;
    Rational offset;
  };
  std::vector<RationalPoint> vertices;  // the extreme points, sorted
  std::vector<HalfSpace> half_spaces;   // one a face

  // {t in R : t v in C}, v != 0; nothing if it is empty.
  [[nodiscard]] std::optional<std::pair<Rational, Rational>> clip(const RationalPoint& v) const;
};

// For two solid polytopes of few vertices; std::invalid_argument for anything else.
[[nodiscard]] NefCso nef_cso(const corpus::Case& problem);

}  // namespace graze::oracle
