// What a linear cast says of the bodies' distance at toi_lower.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult distance_is_stated(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
