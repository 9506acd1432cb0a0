// A case in integers: its bodies, the hull P of the differences of their vertices, and the radii around it.
//
// Every length of the case is multiplied by one common denominator, `unit`. C = P + ball(R), R = r_A + r_B +
// m.
#pragma once

#include <optional>

#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/exact_distance.hpp"

namespace graze::oracle {

// Beyond this many differences of extreme points (they are all formed) a pair is refused.
inline constexpr std::size_t kMostDifferences = std::size_t{1} << 20;

// unit x, for a unit that is a multiple of every denominator in x.
[[nodiscard]] Integer times(const Integer& unit, const Rational& x);
[[nodiscard]] IntVec times(const Integer& unit, const RationalPoint& x);
// Makes `unit` such a multiple.
void fold_denominators(Integer& unit, const RationalPoint& x);
// x exactly, as integers over one denominator. x is finite.
[[nodiscard]] HomogeneousPoint homogeneous(const RationalPoint& x);
[[nodiscard]] RationalPoint rational(const Vec3<double>& x);

// max over the hull of n.c
[[nodiscard]] Integer support(const ConvexHull& hull, const IntVec& n);

class IntegerScene {
 public:
  // Throws std::invalid_argument for what exact_body refuses, a target distance below 0 or not finite, and
  // more than kMostDifferences.
  explicit IntegerScene(const corpus::Case& problem);

  ExactBody a, b;
  Integer unit = 1;
  IntVec v;                      // v_B - v_A
  Integer shape_radius, radius;  // r_A + r_B, and R
  std::optional<HullDistance> cso;

  // Lengths, back in the caller's unit.
  [[nodiscard]] Rational length(const Integer& x) const { return fraction(x, unit); }
  [[nodiscard]] Rational length_sq(const Rational& squared) const { return squared / (unit * unit); }
  // unit x, homogeneous.
  [[nodiscard]] HomogeneousPoint point(const RationalPoint& x) const;
  // The hull of the vertices of A ('a') or B ('b') at t = 0. Any other letter throws std::invalid_argument.
  [[nodiscard]] const HullDistance& body_hull(char body) const;
  // Distance of a world point from a body at time t. It is infinity for an argument that is not finite.
  [[nodiscard]] Enclosure distance_from_body(char body, double t, const Vec3<double>& world_point) const;

 private:
  mutable std::optional<HullDistance> body_a_, body_b_;
};

}  // namespace graze::oracle
