// Bytes to a case, for every sequence of bytes, and a case to bytes.
//
//   byte 0       one bit each: A turned (bit 0), B turned, t_max given, target distance given, more given
//   more         if given, a byte, one bit each: A's rotation (bit 0), A's pivot, B's rotation, B's pivot,
//                the policy pass_over, a query, a direction.
//   body         A, then B: shape, position, orientation (w, x, y, z) if turned, displacement.
//   shape        a byte, its low four bits the kind, in the order of graze::Shape, then the kind's numbers,
//                in the order of its fields. A hull has a byte first: its low seven bits are the vertex count
//                less 1, the high one requests adjacency. A sum or a hull of several has a byte first: the
//                number of parts less 1, modulo 3. Parts are shapes. Kinds 14 and 15 are a point and a
//                sphere. Four high bits that are all set make it invalid: a hull of no vertex, a combinator
//                without parts, a missing part for any other kind of part. Three combinators deep there are
//                leaves alone: kinds 10 to 13 are 0 to 3 there.
//   t_max, target distance, if given (else 1 and 0)
//   rotations, pivots, query (a byte, modulo 7), direction, if given
//   tail         the remaining bytes: the target's own choices (target.hpp)
//
// A scalar is a tag and the bytes that follow it. Bytes beyond the end are 0. Tags are chosen so that a mutation of
// one byte is a small step, a copy, or a neighbour of an earlier number. Raw doubles never reach these ties and
// near-ties.
//   00-7f  tag - 64
//   80-8f  the scalar that came (tag & 15) + 1 before        90-9f, a0-af  its next double up, down
//   b0-bf  the next byte as a signed integer, times 2^-(tag & 15)
//   c0-cf  float, 4 bytes, little-endian, the exponent of infinities and NaNs lowered by one
//   d0-de  double, 8 bytes, little-endian, its exponent field f brought to f modulo 384, less 192
//   df ff  double, 8 bytes, as it is. It is the only way to a NaN, an infinity, or a magnitude outside of 2^-192 to
//          2^192, so that nearly every input is a question that the library answers.
//   df     followed by any other byte: as d0
//   e0-ff  as d0, its exponent brought to -16..15
// An extent, a distance and t_max lose their sign, except by df ff.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "corpus/case.hpp"

namespace graze::fuzz {

using Bytes = std::vector<std::uint8_t>;

// Total: NaN, infinities, negative extents, empty hulls, missing parts and q = 0 are decoded too, but rarely.
[[nodiscard]] corpus::Case decode(std::span<const std::uint8_t> bytes);

// Do hulls that request adjacency get it? Its exact arithmetic is most of the cost of decoding a large hull, and
// callers that only change numbers do not need it.
enum class Adjacency : std::uint8_t { derived, left_out };

struct Decoded {
  corpus::Case problem;
  std::span<const std::uint8_t> tail;  // of the bytes given
  bool asks_adjacency = false;         // some hull does
};
[[nodiscard]] Decoded decode_with_tail(std::span<const std::uint8_t> bytes,
                                       Adjacency adjacency = Adjacency::derived);

// decode(encode(c)) has c's numbers, bit for bit. Returns nothing for a hull of more than 128 vertices, and for a
// combinator of more than three parts or more than three deep. A hull's adjacency is derived anew. `ask_adjacency` also
// requests it for hulls that have none.
[[nodiscard]] std::optional<Bytes> encode(const corpus::Case& problem, bool ask_adjacency = false);

}  // namespace graze::fuzz
