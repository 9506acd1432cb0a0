// Laws of what a search may be told and what it leaves behind: budgets that end too soon, tolerances, another
// scalar or tier, and the same question again.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult interrupting(const corpus::Case&, const engine::Method&);
LawResult tightening(const corpus::Case&, const engine::Method&);
LawResult interrupted_is_right(const corpus::Case&, const engine::Method&);
LawResult every_iterate_is_proved(const corpus::Case&, const engine::Method&);
LawResult tolerance_bounds_the_error(const corpus::Case&, const engine::Method&);
LawResult scalars_meet(const corpus::Case&, const engine::Method&);
LawResult tiers_nest(const corpus::Case&, const engine::Method&);
LawResult asking_again(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
