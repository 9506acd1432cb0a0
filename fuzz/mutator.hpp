// Mutations that know geometry: bytes to a case, a move of the case, and back to bytes.
//
// Raw mutations of bytes hardly ever make two bodies touch, a face flat or two coordinates neighbours. These moves do
// little else. Each is a pure function of the case and the random bits, and keeps a question a question: no number
// becomes NaN, infinite or out of range, no extent negative, no quaternion zero.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "corpus/random.hpp"
#include "fuzz/codec.hpp"

namespace graze::fuzz {

enum class Move : std::uint8_t {
  one_ulp,    // a number to its next double
  copy,       // a number to where another is, of either sign
  scale,      // every length by a power of two, or a body's shape, or the motion
  snap,       // B moved, or a vertex of B: onto a vertex, an edge or a plane of A
  touch,      // B moved by the gap to the nearest point of A, or along the path to first contact
  duplicate,  // a vertex once more, or once more and one unit in the last place apart
  drop,       // a vertex less
  flatten,    // the shape along an axis, or its curved extent
  align,      // poses, positions, or the motion, with axes or with each other
  start,      // t_max, target distance, start policy: 0, 1, infinity, the time of contact
  turn,       // the spin of a body: none, a quarter, the other's, a pivot at a vertex
  swap_in,    // the shape, or all of a body, of a curated case or of a family's
};
inline constexpr std::array<std::string_view, 12> kMoveNames = {"one_ulp", "copy",      "scale", "snap",
                                                                "touch",   "duplicate", "drop",  "flatten",
                                                                "align",   "start",     "turn",  "swap_in"};

// The case after the move. Nothing if the move does not apply (no vertex to drop) or would leave the domain.
[[nodiscard]] std::optional<corpus::Case> moved(Move move, const corpus::Case& problem,
                                                corpus::Random& random);

// One to three moves of the case in the bytes. The tail stays, except that one time in four a byte of it changes.
// Returns nothing if no move applies or the result is longer than `most`.
[[nodiscard]] std::optional<Bytes> mutated(std::span<const std::uint8_t> bytes, std::size_t most,
                                           std::uint64_t seed);
// A child of two: a body, the motions, or all but the bodies of one, the rest of the other.
[[nodiscard]] std::optional<Bytes> crossed(std::span<const std::uint8_t> one,
                                           std::span<const std::uint8_t> other, std::size_t most,
                                           std::uint64_t seed);

}  // namespace graze::fuzz
