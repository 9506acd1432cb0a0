// The laws, kind by kind: law.cpp puts them into one list.
#pragma once

#include <vector>

#include "properties/laws/law.hpp"

namespace graze::law {

[[nodiscard]] std::vector<Law> linear_laws();
[[nodiscard]] std::vector<Law> query_laws();
[[nodiscard]] std::vector<Law> rotating_laws();

}  // namespace graze::law
