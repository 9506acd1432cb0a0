// Our linear casts as engines: a case in, an answer in doubles out.
#include <graze/cast.hpp>

#include "engines/convert.hpp"
#include "engines/ours.hpp"
#include "engines/timing.hpp"

namespace graze::engine {
namespace {

// The tiers above standard have one method each, whatever the name given here.
template <Scalar S>
CastOptions<S> options_for(const corpus::Case& problem, const Ask& ask, Tier tier, graze::Method method) {
  CastOptions<S> options;
  if (tier == Tier::standard) options.method = method;
  options.tier = tier;
  options.request = ask.request;
  options.t_max = static_cast<S>(problem.t_max);
  options.target_distance = static_cast<S>(problem.target_distance);
  options.tolerance = static_cast<S>(ask.tolerance);
  options.start_policy = problem.start_policy;
  if (ask.max_iterations > 0) options.max_iterations = ask.max_iterations;
  return options;
}

template <Scalar S>
Answer widened(const CastResult<S>& result) {
  return {.outcome = result.outcome,
          .invalid = result.invalid,
          .invalid_at = result.invalid_at,
          .toi_lower = result.toi_lower,
          .toi_upper = result.toi_upper,
          .normal = result.normal.template cast<double>(),
          .point_a = result.point_a.template cast<double>(),
          .point_b = result.point_b.template cast<double>(),
          .distance = result.distance,
          .passed_over = result.passed_over,
          .proof = result.proof,
          .counters = result.counters};
}

template <Scalar S, Tier kTier, graze::Method kMethod>
Answer cast_case(const corpus::Case& problem, const Ask& ask) {
  if (!unsupported(Kind::linear, problem).empty()) return not_taken();
  return widened(graze::cast(round_to<S>(problem.a), round_to<S>(problem.b),
                             options_for<S>(problem, ask, kTier, kMethod)));
}

template <Scalar S, Tier kTier, graze::Method kMethod>
double time_case(const corpus::Case& problem, const Ask& ask, int repeats) {
  const Body<S> a = round_to<S>(problem.a), b = round_to<S>(problem.b);
  const CastOptions<S> options = options_for<S>(problem, ask, kTier, kMethod);
  return median_ns([&] { return graze::cast(a, b, options); }, repeats);
}

template <Scalar S, Tier kTier, graze::Method kMethod>
Method engine_of(const char* name) {
  return {.kind = Kind::linear,
          .name = name,
          .scalar = std::same_as<S, float> ? "float" : "double",
          .tier = kTier == Tier::exact       ? "exact"
                  : kTier == Tier::certified ? "certified"
                                             : "standard",
          .unit_roundoff = kUnitRoundoff<S>,
          .ask = &cast_case<S, kTier, kMethod>,
          .seen = &rounded_case<S>,
          .time_ns = &time_case<S, kTier, kMethod>};
}

template <Scalar S>
void add_casts(std::vector<Method>& out) {
  using By = graze::Method;
  out.push_back(engine_of<S, Tier::standard, By::conservative_advancement>("ca"));
  out.push_back(engine_of<S, Tier::standard, By::gjk_ray_cast>("gjk"));
  out.push_back(engine_of<S, Tier::standard, By::mpr_sweep>("mpr"));
  out.push_back(engine_of<S, Tier::certified, By::mpr_sweep>("certified"));
  out.push_back(engine_of<S, Tier::exact, By::exact_portal>("exact"));
}

}  // namespace

void add_linear_methods(std::vector<Method>& out) {
  add_casts<double>(out);
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
  add_casts<float>(out);
#endif
}

}  // namespace graze::engine
