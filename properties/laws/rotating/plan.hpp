// The laws of the plan: what it spares changes no answer, and is not done.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult plan_changes_nothing(const corpus::Case&, const engine::Method&);
LawResult plan_spares_the_work(const corpus::Case&, const engine::Method&);
LawResult plan_is_monotone(const corpus::Case&, const engine::Method&);
LawResult unseen_turn_is_none(const corpus::Case&, const engine::Method&);
LawResult as_one_stands_still(const corpus::Case&, const engine::Method&);
LawResult unturned_is_linear(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
