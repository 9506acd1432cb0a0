// Laws that need no oracle: what an answer says must be consistent in itself, its proof must be accepted, and
// bad input must be refused at the door.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

// The same for an answer already at hand (`seen` as the method saw it); empty, or what is wrong.
[[nodiscard]] std::string consistency_fault(const corpus::Case& seen, const engine::Method& method,
                                            const engine::Answer& answer, Request request);
[[nodiscard]] std::string proof_fault(const corpus::Case& seen, const engine::Answer& answer);

}  // namespace graze::law
