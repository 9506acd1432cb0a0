// Our casts as engines: a case in, an answer in doubles out.
#include <algorithm>
#include <array>
#include <cmath>
#include <graze/cast.hpp>

#include "engines/convert.hpp"
#include "engines/method.hpp"
#include "engines/timing.hpp"

namespace graze::engine {
namespace {

// The tiers above standard have one method each, whatever the name given here.
template <Scalar S>
CastOptions<S> options_for(const corpus::Case& problem, const Ask& ask, Tier tier, Method method) {
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

template <Scalar S, Tier kTier, Method kMethod>
Answer cast_case(const corpus::Case& problem, const Ask& ask) {
  if (!unsupported(problem).empty()) {
    return {.outcome = Outcome::invalid_input, .toi_lower = std::nan(""), .toi_upper = std::nan("")};
  }
  return widened(graze::cast(round_to<S>(problem.a), round_to<S>(problem.b),
                             options_for<S>(problem, ask, kTier, kMethod)));
}

template <Scalar S, Tier kTier, Method kMethod>
double time_case(const corpus::Case& problem, const Ask& ask, int repeats) {
  const Body<S> a = round_to<S>(problem.a), b = round_to<S>(problem.b);
  const CastOptions<S> options = options_for<S>(problem, ask, kTier, kMethod);
  return median_ns([&] { return graze::cast(a, b, options); }, repeats);
}

template <Scalar S, Tier kTier, Method kMethod>
EngineMethod engine_of(const char* name) {
  return {.name = name,
          .scalar = std::same_as<S, float> ? "float" : "double",
          .tier = kTier == Tier::exact       ? "exact"
                  : kTier == Tier::certified ? "certified"
                                             : "standard",
          .unit_roundoff = kUnitRoundoff<S>,
          .cast = &cast_case<S, kTier, kMethod>,
          .seen = &rounded_case<S>,
          .time_ns = &time_case<S, kTier, kMethod>};
}

}  // namespace

std::span<const EngineMethod> methods() {
  static const auto kMethods = std::to_array<EngineMethod>({
      engine_of<double, Tier::standard, Method::conservative_advancement>("ca"),
      engine_of<double, Tier::standard, Method::gjk_ray_cast>("gjk"),
      engine_of<double, Tier::standard, Method::mpr_sweep>("mpr"),
      engine_of<double, Tier::certified, Method::mpr_sweep>("certified"),
      engine_of<double, Tier::exact, Method::exact_portal>("exact"),
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
      engine_of<float, Tier::standard, Method::conservative_advancement>("ca"),
      engine_of<float, Tier::standard, Method::gjk_ray_cast>("gjk"),
      engine_of<float, Tier::standard, Method::mpr_sweep>("mpr"),
      engine_of<float, Tier::certified, Method::mpr_sweep>("certified"),
      engine_of<float, Tier::exact, Method::exact_portal>("exact"),
#endif
  });
  return kMethods;
}

const EngineMethod* find_method(std::string_view name) {
  for (const EngineMethod& method : methods()) {
    if (name == method.name || name == method.full_name()) return &method;
  }
  return nullptr;
}

namespace {

bool is_polytope(const Shape<double>& shape) {
  return std::visit(
      []<class T>(const T& s) {
        if constexpr (std::same_as<T, Posed<double>>) {
          return s.shape && is_polytope(s.shape->shape);
        } else if constexpr (std::same_as<T, Sum<double>>) {
          return std::all_of(s.shapes.begin(), s.shapes.end(), [](const SharedShape<double>& part) {
            return part && is_polytope(part->shape);
          });
        } else {
          return std::same_as<T, Point<double>> || std::same_as<T, Segment<double>> ||
                 std::same_as<T, Triangle<double>> || std::same_as<T, Box<double>> ||
                 std::same_as<T, Hull<double>>;
        }
      },
      shape);
}

}  // namespace

bool is_exact_question(const corpus::Case& seen) {
  return is_polytope(seen.a.shape) && is_polytope(seen.b.shape) && seen.target_distance == 0;
}

std::string unsupported(const corpus::Case& problem) {
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (spin->rotation != Vec3<double>::Zero()) return "a rotating motion";
  }
  if (problem.query != corpus::Query::cast) return "a query other than cast";
  return {};
}

}  // namespace graze::engine
