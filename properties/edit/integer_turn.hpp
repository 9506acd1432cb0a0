// Rotations that take no rounding: a quaternion p of integers, and every length times N = |p|^2.
//
//   x -> p x conj(p) = N R x,   a matrix of integers. With N = 1, 2 or 4 and one, two or four components of
// one size R permutes the axes with signs (24 of them, 48 with mirror images); the others are Pythagorean:
// (2, 1, 0, 0) turns by the angle of the triangle 3, 4, 5.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "corpus/case.hpp"

namespace graze::law {

using IntegerQuaternion = std::array<int, 4>;  // w, x, y, z

// The k-th of the 24 that permute the axes, 0 the identity; k is taken modulo 24.
[[nodiscard]] IntegerQuaternion axis_permutation(std::uint64_t k);
// One of the others, with |p|^2 up to 54.
[[nodiscard]] IntegerQuaternion pythagorean(std::uint64_t k);

// Both bodies and their motion turned by R and stretched by N, so that every time stays as it was. A body of
// vertices alone that is not turned yet has its vertices turned for `in_place`, every other its orientation.
// Nothing where a number would be rounded.
[[nodiscard]] std::optional<corpus::Case> turned_by(const corpus::Case& problem, const IntegerQuaternion& p,
                                                    bool in_place);

}  // namespace graze::law
