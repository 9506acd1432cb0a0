// A case in the terms of an engine: the question it is asked, and the case that it sees as a result.
//
//   asked = the case, in the engine's unit of length (a power of two), shapes that it does not take as hulls
//           of their vertices, relative motion and pivots as it wants them, unit quaternions, every number
//           rounded to its scalar
//   seen  = what the engine answers about, in the unit of the case: asked, its margin added to the target
//           distance, taken back by the power of two (exactly)
// Errors are measured against `seen`.
#pragma once

#include <optional>
#include <string>

#include "certify/external/declaration.hpp"
#include "corpus/case.hpp"

namespace graze::external {

struct Terms {
  // The reason why the engine is not asked. If it is empty, the other fields are valid.
  std::string refused = {};
  bool beyond_limits = false;  // beyond a documented limit, refused for that reason or asked anyway

  corpus::Case asked = {}, seen = {};
  int exponent = 0;      // lengths of `asked` are those of the case times 2^exponent
  bool swapped = false;  // for a ray: A of the case is the point, and B takes A's place
  // The engine decides how the margin is divided between the bodies, so either may be rounded by up to all of it. These
  // are the lengths by which each body may reach beyond the one that is seen, in the unit of the case.
  double reach_a = 0, reach_b = 0;
};

// `beyond`: also ask cases beyond documented limits.
[[nodiscard]] Terms in_terms_of(const Declaration& engine, const Offer& offer, const corpus::Case& problem,
                                bool beyond);

// graze.question/1, one line without its end. `repeat` > 0 asks for a time.
[[nodiscard]] std::string write_question(const Offer& offer, const Terms& terms, std::string_view id,
                                         int repeat = 0);

}  // namespace graze::external
