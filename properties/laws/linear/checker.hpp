// The law of the checker of proofs itself, by proofs that claim too much. What each says and when it does not
// apply: checker.cpp and the table in linear.cpp.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult overclaims_are_refused(const corpus::Case& problem, const engine::Method& method);

}  // namespace graze::law
