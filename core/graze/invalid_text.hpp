/// @file
/// Messages: why and where an input was refused, in one line.
//
// It is apart from result.hpp because it makes strings. A cast without messages does not need it.
#pragma once

#include <graze/result.hpp>
#include <string>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// The reason for the refusal, worded for the field.
[[nodiscard]] constexpr std::string_view predicate_of(const InvalidAt& at) {
  switch (at.why) {
    case Invalid::none:
      return "";
    case Invalid::not_finite:
      return " is NaN or infinite";
    case Invalid::out_of_range:
      if (at.field == InvalidField::rotation && at.index < 0) return " is a turn of more than 2^30 radians";
      if (at.field == InvalidField::direction && at.index < 0) return " is zero";
      return " is neither 0 nor of a magnitude from 1e-60 to 1e60";
    case Invalid::empty_hull:
      return " has no vertex";
    case Invalid::negative_extent:
      return " is negative";
    case Invalid::zero_quaternion:
      return " is (0, 0, 0, 0)";
    case Invalid::missing_part:
      return at.field == InvalidField::part ? " has no parts" : " is missing";
    case Invalid::too_complex:
      if (at.body == InvalidBody::none) return "the shapes nest too many rotations for tier exact";
      return " is nested deeper than 16, or has more than 4096 parts or 2^32 - 1 vertices";
    case Invalid::rounding_mode:
      return "the machine does not round to nearest";
    case Invalid::unsafe_math:
      return "graze is compiled with a part of -ffast-math";
    case Invalid::bad_horizon:
      return " is negative or NaN";
    case Invalid::bad_target:
      return " is negative, NaN or out of range";
    case Invalid::bad_tolerance:
      return at.field == InvalidField::tolerance ? " is negative, NaN or infinite" : " is below one";
    case Invalid::not_exact:
      if (at.field == InvalidField::tier) return " is exact, which knows no rotation that can be seen";
      return " is curved or a hull of shapes, which tier exact does not know";
    case Invalid::not_linear:
      return " is infinite, and a rotation can be seen";
    case Invalid::not_followed:
      return " is pass_over, a rotation can be seen, and what becomes of the contact at the start is not "
             "found by this "
             "method, or not proved";
  }
  return {};
}

}  // namespace detail

/// Why and where an input was refused, in one line. It is empty if nothing is wrong. It allocates.
///
/// @code
/// const graze::InvalidAt at{.why = graze::Invalid::negative_extent,
///                           .body = graze::InvalidBody::b,
///                           .field = graze::InvalidField::half_extents,
///                           .part = 0,
///                           .index = 1};
/// assert(to_text(at) == "body b: shape.half_extents[1] is negative");
/// @endcode
[[nodiscard]] inline std::string to_text(const InvalidAt& at) {
  std::string text;
  if (at.body != InvalidBody::none) text.append(to_text(at.body)).append(": ");
  const bool whole = at.field == InvalidField::shape || at.field == InvalidField::part;
  if (at.part > 0) {
    text.append("part ").append(std::to_string(at.part)).append(" of its shape");
    if (!whole) text.append(": ");
  } else if (at.part == 0 || whole) {
    text.append(whole ? "shape" : "shape.");
  }
  if (!whole && at.field != InvalidField::none) text.append(to_text(at.field));
  if (at.index >= 0) text.append("[").append(std::to_string(at.index)).append("]");
  return text.append(detail::predicate_of(at));
}

}}  // namespace graze::GRAZE_LINKAGE
