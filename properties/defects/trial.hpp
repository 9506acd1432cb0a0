// The laws of a kind, tried on cases in a process of their own. A defect may crash a method or keep it in an endless
// loop, and either is a way to be noticed.
#pragma once

#include <vector>

#include "properties/defects/sample.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

// All laws of a kind, cheap ones first.
[[nodiscard]] std::vector<Law> laws_of(Kind kind);

// Prints the result for each law (driver.cpp). A law stops at its first broken case. Returns true if one breaks.
bool try_laws(const std::vector<Law>& laws, const Sample& sample, bool with_reasons);

}  // namespace graze::law
