// A line that an engine answers with, graze.answer/1, read into an answer about the case.
#pragma once

#include <string>
#include <string_view>

#include "certify/external/terms.hpp"

namespace graze::external {

// The answer to the question `id`, its lengths in the unit of the case, its bodies those of the case. A line
// that is none is an answer with a failure: garbage, another's answer, no number, out of range. Nothing
// throws.
[[nodiscard]] engine::Answer read_answer(std::string_view line, std::string_view id, const Offer& offer,
                                         const Terms& terms);

// By itself: what it says of the question that it answers. Empty where the line does not say.
[[nodiscard]] std::string id_of_answer(std::string_view line);

}  // namespace graze::external
