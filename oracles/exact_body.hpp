// A body as exact rationals: its posed vertices at t = 0 in world axes, its radius, its displacement.
#pragma once

#include "corpus/case.hpp"
#include "oracles/rational.hpp"

namespace graze::oracle {

struct ExactBody {
  // position + R(q) x, R(q) x = q x conj(q) / |q|^2. Order: a hull's as given, a box's by the bits of its
  // index (bit i set: +half_extents_i), one point for points and spheres.
  std::vector<RationalPoint> vertices;
  Rational radius;  // zero but for spheres
  RationalPoint displacement;
};

// Throws std::invalid_argument for a NaN, an infinite number, an empty hull, a negative extent or a zero
// quaternion.
[[nodiscard]] ExactBody exact_body(const Body<double>& body);

}  // namespace graze::oracle
