// Laws that ask a rotating method twice, the second time about other times: a longer or a shorter step, a
// part of it, the way back.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult stretching_time(const corpus::Case&, const engine::Method&);
LawResult turning_horizon(const corpus::Case&, const engine::Method&);
LawResult turning_splitting(const corpus::Case&, const engine::Method&);
LawResult turning_backwards(const corpus::Case&, const engine::Method&);
LawResult whole_turn_is_all(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
