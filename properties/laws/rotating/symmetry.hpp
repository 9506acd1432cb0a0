// Laws that ask a rotating method twice, the second time about the same bodies and motion described in
// another way: exact edits of a case (edit/turning.hpp) that keep the times of contact.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult turning_swapping(const corpus::Case&, const engine::Method&);
LawResult turning_scaling(const corpus::Case&, const engine::Method&);
LawResult turning_translating(const corpus::Case&, const engine::Method&);
LawResult turning_both(const corpus::Case&, const engine::Method&);
LawResult pivot_is_a_line(const corpus::Case&, const engine::Method&);
LawResult idle_pivot_is_nothing(const corpus::Case&, const engine::Method&);
LawResult turning_drifting(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
