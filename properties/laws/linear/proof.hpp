// Laws that need no oracle: an answer must be consistent in itself, its proof must be accepted, and bad input must be
// refused by validation.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

// The same for a given answer (`seen` as the method saw it). Returns the fault, or empty.
[[nodiscard]] std::string consistency_fault(const corpus::Case& seen, const engine::Method& method,
                                            const engine::Answer& answer, Request request);
[[nodiscard]] std::string proof_fault(const corpus::Case& seen, const engine::Answer& answer);

}  // namespace graze::law
