// Our methods, kind by kind: methods.cpp puts them into one list.
#pragma once

#include <vector>

#include "engines/method.hpp"

namespace graze::engine {

void add_linear_methods(std::vector<Method>& out);
void add_query_methods(std::vector<Method>& out);
void add_rotating_methods(std::vector<Method>& out);

}  // namespace graze::engine
