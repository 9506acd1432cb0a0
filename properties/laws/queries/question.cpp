#include "properties/laws/queries/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "corpus/format/names.hpp"
#include "engines/convert.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;

Case question_for(Case problem, Query query, std::size_t pick) {
  constexpr std::array<double, 5> kTimes = {0, 0.375, 0.46875, 0.484375, 0.5},
                                  kHorizons = {1, 1, 1, 16, 0x1p20};
  problem.query = query;
  problem.expect.reset();
  problem.start_policy = StartPolicy::report;
  if (query == Query::swept_overlap) problem.t_max *= kHorizons[pick % kHorizons.size()];
  if (query == Query::line || query == Query::swept_overlap) return problem;
  const double t = kTimes[pick % kTimes.size()];
  problem.a.position += t * problem.a.displacement;
  problem.b.position += t * problem.b.displacement;
  if (query == Query::penetration_along) {
    const Vec3<double> v = problem.b.displacement - problem.a.displacement;
    problem.direction = v == Vec3<double>::Zero() ? Vec3<double>(1, 2, -3) : v;
  }
  problem.a.displacement.setZero();
  problem.b.displacement.setZero();
  problem.target_distance = 0;
  problem.id += fmt::format("/{}-{}", corpus::name_of(query), t);
  return problem;
}

Case seen_by(const engine::Method& method, const Case& problem) {
  return method.scalar == "float" ? engine::rounded_case<float>(problem) : problem;
}

const engine::Method& default_method(Query query, std::string_view scalar) {
  const std::span<const engine::Method> all = engine::methods(engine::Kind::query);
  return *std::find_if(all.begin(), all.end(),
                       [&](const engine::Method& one) { return one.query == query && one.scalar == scalar; });
}

}  // namespace graze::law
