// A line that an engine answers with, graze.answer/1, read into an answer about the case.
#pragma once

#include <string>
#include <string_view>

#include "certify/external/terms.hpp"

namespace graze::external {

// The answer to the question `id`, with lengths in the unit of the case and the bodies of the case. An
// invalid line gives an answer with a failure: garbage, another question's answer, not a number, or out of
// range. Does not throw.
[[nodiscard]] engine::Answer read_answer(std::string_view line, std::string_view id, const Offer& offer,
                                         const Terms& terms);

// The id of the question that a line answers. Empty if the line has none.
[[nodiscard]] std::string id_of_answer(std::string_view line);

}  // namespace graze::external
