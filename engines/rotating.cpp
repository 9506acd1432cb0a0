// Our rotating casts as engines: a case in, an answer in doubles out.
#include <array>
#include <graze/rotating_cast.hpp>

#include "engines/convert.hpp"
#include "engines/ours.hpp"
#include "engines/timing.hpp"

namespace graze::engine {
namespace {

// The meaning of a name: a method of tier standard, the plan's choice, or the plan's choice in tier
// certified.
struct Way {
  std::optional<RotatingMethod> method = {};
  Tier tier = Tier::standard;
};
enum class Name { steps, spheres, ca, bilateral, bilateral_published, plan, certified };
constexpr std::array<const char*, 7> kNames = {"steps", "spheres",  "ca", "bilateral", "bilateral_published",
                                               "plan",  "certified"};

constexpr Way way_of(Name name) {
  switch (name) {
    case Name::steps:
      return {.method = RotatingMethod::time_steps};
    case Name::spheres:
      return {.method = RotatingMethod::bounding_spheres};
    case Name::ca:
      return {.method = RotatingMethod::conservative_advancement};
    case Name::bilateral:
      return {.method = RotatingMethod::bilateral_advancement};
    case Name::bilateral_published:
      return {.method = RotatingMethod::bilateral_published};
    case Name::certified:
      return {.tier = Tier::certified};
    case Name::plan:
      break;
  }
  return {};
}

template <Scalar S>
RotatingOptions<S> options_for(const corpus::Case& problem, const Ask& ask, Way way) {
  RotatingOptions<S> options;
  options.tier = ask.tier.value_or(way.tier);
  options.method = way.method;
  options.economies = ask.economies;
  options.request = ask.request;
  options.t_max = static_cast<S>(problem.t_max);
  options.target_distance = static_cast<S>(problem.target_distance);
  options.tolerance = static_cast<S>(ask.tolerance);
  options.start_policy = problem.start_policy;
  if (ask.max_iterations > 0) options.max_iterations = ask.max_iterations;
  if (ask.time_steps > 0) options.time_steps = ask.time_steps;
  return options;
}

template <Scalar S>
Answer widened(const RotatingResult<S>& result) {
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
          .counters = result.counters,
          .plan = result.plan,
          .hidden_motion = result.hidden_motion,
          .rotating_proof = result.proof};
}

template <Scalar S, Name kName>
Answer cast_case(const corpus::Case& problem, const Ask& ask) {
  if (!unsupported(Kind::rotating, problem).empty()) return not_taken();
  return widened(graze::cast(round_to<S>(problem.a, problem.spin_a), round_to<S>(problem.b, problem.spin_b),
                             options_for<S>(problem, ask, way_of(kName))));
}

template <Scalar S, Name kName>
Plan plan_case(const corpus::Case& problem, const Ask& ask) {
  return graze::plan(round_to<S>(problem.a, problem.spin_a), round_to<S>(problem.b, problem.spin_b),
                     options_for<S>(problem, ask, way_of(kName)));
}

template <Scalar S, Name kName>
double time_case(const corpus::Case& problem, const Ask& ask, int repeats) {
  const RotatingBody<S> a = round_to<S>(problem.a, problem.spin_a),
                        b = round_to<S>(problem.b, problem.spin_b);
  const RotatingOptions<S> options = options_for<S>(problem, ask, way_of(kName));
  return median_ns([&] { return graze::cast(a, b, options); }, repeats);
}

template <Scalar S, Name kName>
Method engine_of() {
  return {.kind = Kind::rotating,
          .name = kNames[static_cast<std::size_t>(kName)],
          .scalar = std::same_as<S, float> ? "float" : "double",
          .tier = way_of(kName).tier == Tier::certified ? "certified" : "standard",
          .unit_roundoff = kUnitRoundoff<S>,
          .ask = &cast_case<S, kName>,
          .seen = &rounded_case<S>,
          .time_ns = &time_case<S, kName>,
          .plan = &plan_case<S, kName>};
}

template <Scalar S>
void add_rotating(std::vector<Method>& out) {
  out.push_back(engine_of<S, Name::steps>());
  out.push_back(engine_of<S, Name::spheres>());
  out.push_back(engine_of<S, Name::ca>());
  out.push_back(engine_of<S, Name::bilateral>());
  out.push_back(engine_of<S, Name::bilateral_published>());
  out.push_back(engine_of<S, Name::plan>());
  out.push_back(engine_of<S, Name::certified>());
}

}  // namespace

void add_rotating_methods(std::vector<Method>& out) {
  add_rotating<double>(out);
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
  add_rotating<float>(out);
#endif
}

}  // namespace graze::engine
