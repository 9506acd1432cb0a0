// The law of the door of rotating casts: what no method may take.
#pragma once

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

LawResult bad_turn_is_refused(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
