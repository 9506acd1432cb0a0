// What an engine of others says it can be asked, as a method that can be judged: all of it but the asking.
#pragma once

#include <optional>

#include "engines/guarantees.hpp"
#include "external/declaration.hpp"

namespace graze::external {

// Limits of the command line, to which an engine is held whatever it declares: where there is one, it declares none.
struct Held {
  std::optional<double> tolerance = {}, relative_tolerance = {}, kappa = {};
};

[[nodiscard]] engine::Guarantee guarantee_of(const Declaration& engine, const Offer& offer, const Held& held);

// Without `ask` and `time_ns`. What is given outlives it. `beyond`: asked beyond documented limits, too.
[[nodiscard]] engine::Method method_of(const Declaration& engine, const Offer& offer,
                                       const engine::Guarantee& row, bool beyond);

}  // namespace graze::external
