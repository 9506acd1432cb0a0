// Laws about what an answer of a rotating method says of itself, and how it changes with what is asked: the
// options, the shapes, the method.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult turning_methods_meet(const corpus::Case&, const engine::Method&);
LawResult turning_superset(const corpus::Case&, const engine::Method&);
LawResult tolerance_is_kept(const corpus::Case&, const engine::Method&);
LawResult turning_requesting(const corpus::Case&, const engine::Method&);
LawResult turning_answer_is_consistent(const corpus::Case&, const engine::Method&);
LawResult turning_budget(const corpus::Case&, const engine::Method&);
LawResult turning_scalars_meet(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
