// The laws of rotating casts that stand on the checker of proofs.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult turning_proof_is_accepted(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
