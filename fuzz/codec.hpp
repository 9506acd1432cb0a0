// Bytes to a case, for every sequence of bytes, and a case to bytes.
//
//   byte 0       one bit each: A turned (bit 0), B turned, t_max given, target distance given
//   body         A, then B: shape; position; orientation (w, x, y, z) if turned; displacement
//   shape        a byte, its low four bits the kind, in the order of graze::Shape; then the kind's numbers,
//   in the
//                order of its fields. Of a hull first its vertex count modulo 65; of a sum or a hull of
//                several first a byte, its low two bits the number of parts; parts are shapes. Kinds 14 and
//                15 are a missing part, or a body's point. Three combinators deep there are leaves alone:
//                kinds 10 to 13 are 0 to 3 there.
//   t_max, target distance, if given (else 1 and 0)
//
// A scalar is a tag and what follows it; bytes beyond the end are 0. Tags are chosen so that a mutation of
// one byte is a small step, a copy, or a neighbour of an earlier number: ties and near-ties, which raw
// doubles never reach.
//   00-7f  tag - 64
//   80-8f  the scalar that came (tag & 15) + 1 before        90-9f, a0-af  its next double up, down
//   b0-bf  the next byte as a signed integer, times 2^-(tag & 15)
//   c0-cf  float, 4 bytes, little-endian
//   d0-df  double, 8 bytes, little-endian
//   e0-ff  as d0, its exponent brought to -16..15
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "corpus/case.hpp"

namespace graze::fuzz {

// Total: NaN, infinities, negative extents, empty hulls, missing parts and q = 0 come out too.
[[nodiscard]] corpus::Case decode(std::span<const std::uint8_t> bytes);
// decode(encode(c)) has c's numbers, bit for bit. Nothing for a hull of more than 64 vertices, a combinator
// of more than three parts or more than three deep, or a case that is more than its two bodies, t_max and
// target distance.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> encode(const corpus::Case& problem);

}  // namespace graze::fuzz
