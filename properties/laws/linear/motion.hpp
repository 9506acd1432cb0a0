// Laws of the motion: the same bodies on a longer, slower, shared, reversed or farther path, or with a target
// distance between them. The true answer is known from the original's; where two answers differ, the oracle
// arbitrates (judge.hpp).
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult moving_the_horizon(const corpus::Case&, const engine::Method&);
LawResult keeping_distance(const corpus::Case&, const engine::Method&);
LawResult changing_the_clock(const corpus::Case&, const engine::Method&);
LawResult moving_together(const corpus::Case&, const engine::Method&);
LawResult reversing(const corpus::Case&, const engine::Method&);
LawResult extending(const corpus::Case&, const engine::Method&);
LawResult threshold_of_swept_overlap(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
