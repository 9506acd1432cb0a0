// Which method to take for a game, a robot and a CAD tool, and why: what each asks of its answers is a rule,
// and the cheapest contender of a run that keeps the rule on every case is taken.
#pragma once

#include <string>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

// The rules, whatever a run measured: a line a user and a kind of bodies.
//   game   every verdict decided, no answer off by more than 1e-3 of scale; a float will do
//   robot  never late, not by a bit; no contact missed; every verdict decided; and a tier that promises it
//   CAD    that, and the time: of polytopes to 1e-15 of scale, of other shapes 1e-12, of turning bodies 1e-9
// Whatever the rounds cannot tell from the cheapest (5 %) is as cheap; of those the plan comes first, which
// cast() follows without a method, and tier exact, whose time is correctly rounded.
[[nodiscard]] std::vector<Advice> advice_of(const Document& document);

// How that contender is asked in C++: "graze::cast(a, b, {.tolerance = 1e-06})", with what the bodies
// are in a line above.
[[nodiscard]] std::string call_of(const Row& row);

}  // namespace graze::price
