// The laws of a kind, whatever they are laws of, tried on cases in a process of their own: a defect may
// crash a method, or keep it in a loop for ever, and either is a way to be noticed.
#pragma once

#include <vector>

#include "properties/defects/sample.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

// All laws of a kind, cheap ones first.
[[nodiscard]] std::vector<Law> laws_of(Kind kind);

// Prints what becomes of each law (driver.cpp); a law is left at its first broken case. True if one breaks.
bool try_laws(const std::vector<Law>& laws, const Sample& sample, bool with_reasons);

}  // namespace graze::law
