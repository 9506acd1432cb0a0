// The laws of rotating casts that stand on the oracle: an answer's errors, each within the method's row
// (judge/judge_rotating.cpp).
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult turning_verdict_is_right(const corpus::Case&, const engine::Method&);
LawResult turning_is_never_late(const corpus::Case&, const engine::Method&);
LawResult turning_claims_no_contact_early(const corpus::Case&, const engine::Method&);
LawResult turning_bracket_is_narrow(const corpus::Case&, const engine::Method&);
LawResult turning_contact_is_right(const corpus::Case&, const engine::Method&);
LawResult turning_distance_is_stated(const corpus::Case&, const engine::Method&);
LawResult turning_certified_decides(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
