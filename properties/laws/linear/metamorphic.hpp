// Laws that ask the method twice: an exact edit of the case, whose true answer is known from the original's.
// Where the two answers differ, the oracle arbitrates (judge.hpp).
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult swapping(const corpus::Case&, const engine::Method&);
LawResult scaling(const corpus::Case&, const engine::Method&);
LawResult translating(const corpus::Case&, const engine::Method&);
LawResult superset(const corpus::Case&, const engine::Method&);
LawResult ray_is_point_cast(const corpus::Case&, const engine::Method&);
LawResult splitting(const corpus::Case&, const engine::Method&);
LawResult methods_meet(const corpus::Case&, const engine::Method&);
LawResult requesting(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
