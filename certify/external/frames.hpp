// Questions to the host of a shared library as bytes, and its answers (engines/adapter/host_frames.hpp): the same questions as
// lines ask, held to the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "certify/external/terms.hpp"

namespace graze::external {

[[nodiscard]] std::string write_question_frame(const Offer& offer, const Terms& terms, std::uint64_t id,
                                               int repeat = 0);

// How many bytes an answer has.
[[nodiscard]] std::size_t answer_frame_size();

// As read_answer() reads a line.
[[nodiscard]] engine::Answer read_answer_frame(std::string_view bytes, std::uint64_t id, const Offer& offer,
                                               const Terms& terms);

}  // namespace graze::external
