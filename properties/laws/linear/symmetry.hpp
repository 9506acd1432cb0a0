// Laws of symmetry: the whole problem turned or mirrored, and the same bodies given by other numbers. Where
// two answers differ, the oracle arbitrates (judge.hpp).
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult permuting_the_axes(const corpus::Case&, const engine::Method&);
LawResult turning(const corpus::Case&, const engine::Method&);
LawResult reordering(const corpus::Case&, const engine::Method&);
LawResult redundant_points(const corpus::Case&, const engine::Method&);
LawResult describing_otherwise(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
