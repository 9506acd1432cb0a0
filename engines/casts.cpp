// Our casts as engines: a case in, an answer in doubles out.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <graze/cast.hpp>

#include "engines/convert.hpp"
#include "engines/method.hpp"

namespace graze::engine {
namespace {

template <Scalar S>
CastOptions<S> options_for(const corpus::Case& problem, const Ask& ask, Method method) {
  CastOptions<S> options;
  options.method = method;
  options.tier = method == Method::exact_portal ? Tier::exact : Tier::standard;
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

template <Scalar S, Method kMethod>
Answer cast_case(const corpus::Case& problem, const Ask& ask) {
  if (!unsupported(problem).empty()) {
    return {.outcome = Outcome::invalid_input, .toi_lower = std::nan(""), .toi_upper = std::nan("")};
  }
  return widened(
      graze::cast(round_to<S>(problem.a), round_to<S>(problem.b), options_for<S>(problem, ask, kMethod)));
}

// Keeps the optimiser from dropping a cast whose result nobody reads.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

template <Scalar S, Method kMethod>
double time_case(const corpus::Case& problem, const Ask& ask, int repeats) {
  using Clock = std::chrono::steady_clock;
  const Body<S> a = round_to<S>(problem.a), b = round_to<S>(problem.b);
  const CastOptions<S> options = options_for<S>(problem, ask, kMethod);
  const auto time_batch = [&](int casts) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < casts; ++i) keep(graze::cast(a, b, options));
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  };
  // A batch of 20 microseconds or more: reading the clock (about 25 ns) stays below 1 part in 500.
  constexpr double kBatchNs = 20e3;
  const double first = std::max(time_batch(2) / 2, 1.0);  // also warms the caches
  const int casts = static_cast<int>(std::clamp(kBatchNs / first, 1.0, 1e4));
  std::vector<double> times(static_cast<std::size_t>(std::max(repeats, 1)));
  for (double& t : times) t = time_batch(casts) / casts;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

template <Scalar S, Method kMethod>
EngineMethod engine_of(const char* name) {
  return {.name = name,
          .scalar = std::same_as<S, float> ? "float" : "double",
          .tier = kMethod == Method::exact_portal ? "exact" : "standard",
          .unit_roundoff = kUnitRoundoff<S>,
          .cast = &cast_case<S, kMethod>,
          .seen = &rounded_case<S>,
          .time_ns = &time_case<S, kMethod>};
}

}  // namespace

std::span<const EngineMethod> methods() {
  static const std::array<EngineMethod, 8> kMethods = {
      engine_of<double, Method::conservative_advancement>("ca"),
      engine_of<double, Method::gjk_ray_cast>("gjk"),
      engine_of<double, Method::mpr_sweep>("mpr"),
      engine_of<double, Method::exact_portal>("exact"),
      engine_of<float, Method::conservative_advancement>("ca"),
      engine_of<float, Method::gjk_ray_cast>("gjk"),
      engine_of<float, Method::mpr_sweep>("mpr"),
      engine_of<float, Method::exact_portal>("exact"),
  };
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
