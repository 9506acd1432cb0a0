// Our rotating casts as engines: a case in, an answer in doubles out.
#include "engines/rotating.hpp"

#include <array>
#include <cmath>
#include <graze/rotating_cast.hpp>

#include "engines/convert.hpp"
#include "engines/timing.hpp"

namespace graze::engine {
namespace {

// What a name stands for: a method of tier standard, the plan's choice, or the plan's in tier certified.
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
RotatingOptions<S> options_for(const corpus::Case& problem, const RotatingAsk& ask, Way way) {
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
RotatingAnswer widened(const RotatingResult<S>& result) {
  return {.outcome = result.outcome,
          .invalid = result.invalid,
          .plan = result.plan,
          .toi_lower = result.toi_lower,
          .toi_upper = result.toi_upper,
          .distance = result.distance,
          .passed_over = result.passed_over,
          .hidden_motion = result.hidden_motion,
          .normal = result.normal.template cast<double>(),
          .point_a = result.point_a.template cast<double>(),
          .point_b = result.point_b.template cast<double>(),
          .proof = result.proof,
          .counters = result.counters};
}

template <Scalar S, Name kName>
RotatingAnswer cast_case(const corpus::Case& problem, const RotatingAsk& ask) {
  if (!unsupported_rotating(problem).empty()) {
    return {.outcome = Outcome::invalid_input, .toi_lower = std::nan(""), .toi_upper = std::nan("")};
  }
  return widened(graze::cast(round_to<S>(problem.a, problem.spin_a), round_to<S>(problem.b, problem.spin_b),
                             options_for<S>(problem, ask, way_of(kName))));
}

template <Scalar S, Name kName>
Plan plan_case(const corpus::Case& problem, const RotatingAsk& ask) {
  return graze::plan(round_to<S>(problem.a, problem.spin_a), round_to<S>(problem.b, problem.spin_b),
                     options_for<S>(problem, ask, way_of(kName)));
}

template <Scalar S, Name kName>
double time_case(const corpus::Case& problem, const RotatingAsk& ask, int repeats) {
  const RotatingBody<S> a = round_to<S>(problem.a, problem.spin_a),
                        b = round_to<S>(problem.b, problem.spin_b);
  const RotatingOptions<S> options = options_for<S>(problem, ask, way_of(kName));
  return median_ns([&] { return graze::cast(a, b, options); }, repeats);
}

template <Scalar S, Name kName>
RotatingEngineMethod engine_of() {
  return {.name = kNames[static_cast<std::size_t>(kName)],
          .scalar = std::same_as<S, float> ? "float" : "double",
          .tier = way_of(kName).tier == Tier::certified ? "certified" : "standard",
          .unit_roundoff = kUnitRoundoff<S>,
          .cast = &cast_case<S, kName>,
          .plan = &plan_case<S, kName>,
          .seen = &rounded_case<S>,
          .time_ns = &time_case<S, kName>};
}

template <Scalar S>
std::array<RotatingEngineMethod, kNames.size()> engines_in() {
  return {engine_of<S, Name::steps>(),
          engine_of<S, Name::spheres>(),
          engine_of<S, Name::ca>(),
          engine_of<S, Name::bilateral>(),
          engine_of<S, Name::bilateral_published>(),
          engine_of<S, Name::plan>(),
          engine_of<S, Name::certified>()};
}

}  // namespace

std::span<const RotatingEngineMethod> rotating_methods() {
  static const std::vector<RotatingEngineMethod> kMethods = [] {
    std::vector<RotatingEngineMethod> out;
    for (RotatingEngineMethod& method : engines_in<double>()) out.push_back(std::move(method));
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
    for (RotatingEngineMethod& method : engines_in<float>()) out.push_back(std::move(method));
#endif
    return out;
  }();
  return kMethods;
}

const RotatingEngineMethod* find_rotating_method(std::string_view name) {
  for (const RotatingEngineMethod& method : rotating_methods()) {
    if (name == method.name || name == method.full_name()) return &method;
  }
  return nullptr;
}

bool turns(const corpus::Case& problem) {
  // Written so that a NaN counts as a rotation, too.
  return !(problem.spin_a.rotation == Vec3<double>::Zero() &&
           problem.spin_b.rotation == Vec3<double>::Zero());
}

std::string unsupported_rotating(const corpus::Case& problem) {
  return problem.query == corpus::Query::cast ? "" : "a query other than cast";
}

}  // namespace graze::engine
