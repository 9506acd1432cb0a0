// The law that takes a rotating cast at its word: the bodies where the motion has them at a moment, and asked
// a static query.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult turning_stands_as_said(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
