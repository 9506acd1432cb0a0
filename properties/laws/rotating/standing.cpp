#include "properties/laws/rotating/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engines/queries.hpp"
#include "properties/edit/turning.hpp"
#include "properties/judge/linear.hpp"
#include "properties/laws/rotating/question.hpp"

namespace graze::law {

using corpus::Case;
using engine::RotatingAnswer;
using engine::RotatingEngineMethod;

namespace {

// How far the bodies are apart at a moment, less the target distance; below 0: how deep in each other.
struct Gap {
  double low = 0, high = 0;
};

// The answer of one query in double, widened by its row.
std::optional<engine::QueryAnswer> asked(const Case& still, corpus::Query query, double& row) {
  for (const engine::QueryMethod& method : engine::query_methods()) {
    if (method.query != query || method.scalar != "double" || method.is_exact()) continue;
    const engine::Guarantee* found = engine::find_guarantee(engine::guarantees(), method);
    if (found == nullptr) continue;
    row = found->kappa(still) * kUnitRoundoff<double> * scale_of(still);
    const engine::QueryAnswer answer = method.ask(still, Request::verdict);
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
  if (!apart || !apart->distance) return std::nullopt;
  if (apart->distance->lower > row)
    return Gap{apart->distance->lower - row - error - m, apart->distance->upper + row + error - m};
  const double touching = apart->distance->upper + row;
  const auto deep = asked(still, corpus::Query::penetration, row);
  if (!deep || !deep->depth) return Gap{-kInfinity<double>, touching + error - m};
  return Gap{-deep->depth->upper - row - error - m, std::min(touching, row - deep->depth->lower) + error - m};
}

constexpr double kMoments[] = {1, 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};

}  // namespace

LawResult turning_stands_as_said(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const RotatingAnswer answer = plain_answer(method, seen);
  const RotatingRow row = row_of(method, seen);
  LawResult result = holds({label_of(answer.outcome)});
  for (const double part : kMoments) {
    const double t = part * seen.t_max;
    if (!(t < answer.toi_lower)) continue;
    const std::optional<Gap> gap = gap_at(seen, t);
    if (gap && gap->high < -row.limit) {
      return broken(fmt::format("at {} the bodies are {} deep in each other: {}", hex(t), -gap->high,
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

}  // namespace graze::law
