// Recommends a method for a game, a robot and a CAD tool, and says why. Each user's requirement is a rule.
// The advice is the cheapest contender of a run that keeps the rule on every case.
#pragma once

#include <string>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

// The rules are fixed, whatever a run measured. There is a line for each user and kind of bodies.
//   game   every verdict decided, no answer off by more than 1e-3 of scale, float is enough
//   robot  never late by even one bit, no contact missed, every verdict decided, and a tier that guarantees this
//   CAD    the same, and a time to 1e-15 of scale for polytopes, 1e-12 for other shapes, 1e-9 for rotating bodies
// Contenders that the rounds cannot tell from the cheapest (5 %) count as equally cheap. Two of those are preferred: the
// plan, because cast() follows it without a method, and tier exact, because its time is correctly rounded.
[[nodiscard]] std::vector<Advice> advice_of(const Document& document);

// The call of that contender in C++: "graze::cast(a, b, {.tolerance = 1e-06})", with a line above that describes the
// bodies.
[[nodiscard]] std::string call_of(const Row& row);

}  // namespace graze::price
