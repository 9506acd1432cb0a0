// Rotations without rounding: a quaternion p of integers, and every length times N = |p|^2.
//
//   x -> p x conj(p) = N R x,   a matrix of integers.
//
// With N = 1, 2 or 4 and one, two or four components of one size, R permutes the axes with signs (24 of them, 48 with
// mirror images). The others are Pythagorean: (2, 1, 0, 0) rotates by the angle of the triangle 3, 4, 5.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "corpus/case.hpp"

namespace graze::law {

using IntegerQuaternion = std::array<int, 4>;  // w, x, y, z

// The k-th of the 24 that permute the axes, 0 the identity. k is taken modulo 24.
[[nodiscard]] IntegerQuaternion axis_permutation(std::uint64_t k);
// One of the others, with |p|^2 up to 54.
[[nodiscard]] IntegerQuaternion pythagorean(std::uint64_t k);

// Both bodies and their motion rotated by R and stretched by N, so that every time stays as it was. `in_place` rotates
// the vertices of a body that consists of vertices and has no orientation yet. Every other body's orientation is
// rotated. Nothing if a number would be rounded.
[[nodiscard]] std::optional<corpus::Case> turned_by(const corpus::Case& problem, const IntegerQuaternion& p,
                                                    bool in_place);

}  // namespace graze::law
