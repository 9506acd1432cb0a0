// The laws of rotating casts and of the plan: sentences about every answer of every rotating method, as plain
// functions of a case and a method. What a law is, and what it answers: law.hpp.
//
// They speak of casts over a finite step; a case that turns in a way that is not seen may also be a ray. An
// edit of a case must survive the rounding to the method's scalar, or the law does not apply.
#pragma once

#include "engines/rotating.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

struct RotatingLaw {
  std::string_view name;
  std::string_view sentence;
  Needs needs;
  LawResult (*check)(const corpus::Case&, const engine::RotatingEngineMethod&);
};

[[nodiscard]] std::span<const RotatingLaw> rotating_laws();
[[nodiscard]] const RotatingLaw* find_rotating_law(std::string_view name);  // nullptr if there is none

}  // namespace graze::law
