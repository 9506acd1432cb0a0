// The laws of the queries beside the cast: overlap, distance, penetration, penetration along a direction,
// the line, swept overlap.
//
// A law is called with any linear case; what is asked of a method is question_for (query_case.hpp): the same
// bodies at rest where their path has them, or the motion as it is. Judged by rows of docs/guarantees.md: an
// answer is right for some C' within kappa u scale of C, so two right answers to one question differ by
// twice that at most.
#pragma once

#include <span>
#include <string_view>

#include "corpus/case.hpp"
#include "engines/queries.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

struct QueryLaw {
  std::string_view name;
  std::string_view sentence;
  Needs needs;
  // Not applicable: the method's query is not one that the law is about.
  LawResult (*check)(const corpus::Case&, const engine::QueryMethod&);
};

[[nodiscard]] std::span<const QueryLaw> query_laws();
[[nodiscard]] const QueryLaw* find_query_law(std::string_view name);  // nullptr if there is none

}  // namespace graze::law
