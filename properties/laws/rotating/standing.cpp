// The law that checks a rotating cast by static queries of the bodies at their places at a moment of the motion.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engines/method.hpp"
#include "properties/edit/turning.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

// The distance of the bodies at a moment, less the target distance. Below 0, it is their depth in each other.
struct Gap {
  double low = 0, high = 0;
};

// The answer of one query in double, widened by its guarantee.
std::optional<engine::Answer> asked(const Case& still, corpus::Query query, double& row) {
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    if (method.query != query || method.scalar != "double" || method.is_exact()) continue;
    const engine::Guarantee* found = method.guarantee;
    if (found == nullptr) continue;
    row = found->kappa(still) * kUnitRoundoff<double> * scale_of(still);
    const engine::Answer answer = method.ask(still, {});
    if (answer.stalled || answer.outcome == Outcome::invalid_input) return std::nullopt;
    return answer;
  }
  return std::nullopt;
}

std::optional<Gap> gap_at(const Case& seen, double t) {
  const std::optional<Standing> standing = standing_at(seen, t);
  if (!standing) return std::nullopt;
  const double m = seen.target_distance, error = standing->error;
  Case still = standing->still;
  still.target_distance = 0;
  double row = 0;
  const auto apart = asked(still, corpus::Query::distance, row);
  if (!apart || !apart->separation) return std::nullopt;
  if (apart->separation->lower > row)
    return Gap{apart->separation->lower - row - error - m, apart->separation->upper + row + error - m};
  const double touching = apart->separation->upper + row;
  const auto deep = asked(still, corpus::Query::penetration, row);
  if (!deep || !deep->depth) return Gap{-kInfinity<double>, touching + error - m};
  return Gap{-deep->depth->upper - row - error - m, std::min(touching, row - deep->depth->lower) + error - m};
}

constexpr double kMoments[] = {1, 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};

LawResult turning_stands_as_said(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const Answer answer = plain_answer(method, seen);
  const Limits row = limits_of(method, seen, scale_of(seen));
  LawResult result = holds({label_of(answer.outcome)});
  for (const double part : kMoments) {
    const double t = part * seen.t_max;
    if (!(t < answer.toi_lower)) continue;
    const std::optional<Gap> gap = gap_at(seen, t);
    if (gap && gap->high < -row.limit) {
      return broken(fmt::format("at {} the bodies are {} deep in each other: {}", decimal(t), -gap->high,
                                describe(answer)));
    }
  }
  if (answer.outcome != Outcome::hit && answer.outcome != Outcome::not_converged) return result;
  const std::optional<Gap> gap = gap_at(seen, answer.toi_lower);
  if (!gap) return labelled(std::move(result), {"no query"});
  if (gap->low > answer.distance + row.limit) {
    return broken(fmt::format("at toi_lower the bodies are {} apart, not {}: {}", gap->low, answer.distance,
                              describe(answer)));
  }
  if (gap->high < -row.limit - row.rounding_at(answer.toi_lower)) {
    return broken(
        fmt::format("at toi_lower the bodies are {} deep in each other: {}", -gap->high, describe(answer)));
  }
  return result;
}

}  // namespace

std::vector<Law> rotating_standing_laws() {
  return {
      {"turning_stands_as_said",
       "Placed at a moment, bodies do not overlap before toi_lower, and are as near there as is said.",
       Needs::metamorphic, &turning_stands_as_said},
  };
}

}  // namespace graze::law
