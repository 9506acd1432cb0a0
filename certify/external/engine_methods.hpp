// Turns a question that a third-party engine declares into a method that can be judged. The function that asks is added
// elsewhere.
#pragma once

#include <functional>
#include <optional>

#include "certify/external/declaration.hpp"
#include "certify/external/terms.hpp"
#include "engines/guarantees.hpp"

namespace graze::external {

// Limits from the command line. If one is given, the limits that the engine declares are ignored.
struct Held {
  std::optional<double> tolerance = {}, relative_tolerance = {}, kappa = {};
  bool measure = false;  // no error limit: errors are measured, and only invalid answers are faults
};

// The limit of an engine that declares none and is given none, over scale: what a game still shows as touching. A wrong
// verdict by more than that is a fault whoever made no promise.
inline constexpr double kAssumedRelativeTolerance = 1e-3;

[[nodiscard]] engine::Guarantee guarantee_of(const Declaration& engine, const Offer& offer, const Held& held);

// The answer to a case in the engine's terms, which are not refused.
using Answering = std::function<engine::Answer(const Offer&, const Terms&, const corpus::Case&)>;

// The method without `time_ns`. The arguments must outlive it. With `beyond` it also takes cases beyond documented
// limits.
[[nodiscard]] engine::Method method_of(const Declaration& engine, const Offer& offer,
                                       const engine::Guarantee& row, bool beyond, Answering answering);

// The answer to a case that is not asked.
[[nodiscard]] engine::Answer declined(const Terms& terms);

}  // namespace graze::external
