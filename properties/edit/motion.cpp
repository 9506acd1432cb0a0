#include "properties/edit/motion.hpp"

#include <cmath>
#include <iterator>

#include "properties/edit/case.hpp"

namespace graze::law {

using corpus::Case;

std::optional<Case> started_at(const Case& problem, double s) {
  Case other = problem;
  other.expect.reset();
  for (Body<double>* body : {&other.a, &other.b}) {
    for (int i = 0; i < 3; ++i) {
      const auto step = exact_product(s, body->displacement[i]);
      const auto there = step ? exact_sum(body->position[i], *step) : std::nullopt;
      if (!there) return std::nullopt;
      body->position[i] = *there;
    }
  }
  return other;
}

std::optional<Case> reversed(const Case& problem) {
  if (!(problem.t_max > 0) || std::isinf(problem.t_max)) return std::nullopt;
  std::optional<Case> other = started_at(problem, problem.t_max);
  if (!other) return std::nullopt;
  for (Body<double>* body : {&other->a, &other->b}) body->displacement = -body->displacement;
  return in_domain(*other) ? other : std::nullopt;
}

std::optional<Extended> extended(const Case& problem, std::uint64_t salt) {
  const bool endless = std::isinf(problem.t_max);
  const double unit = endless || problem.t_max == 0 ? 1 : problem.t_max;
  const double factors[] = {1024, 1, 32, 0.25, 4};
  const std::uint64_t first = mix(salt ^ 0x65787465u);
  for (std::size_t j = 0; j < std::size(factors); ++j) {
    const auto s = exact_product(factors[(j + first) % std::size(factors)], unit);
    const auto horizon = !s        ? std::nullopt
                         : endless ? std::optional(problem.t_max)
                                   : exact_sum(problem.t_max, *s);
    if (!horizon) continue;
    std::optional<Case> longer = started_at(problem, -*s);
    if (!longer) continue;
    longer->t_max = *horizon;
    if (in_domain(*longer)) return Extended{*s, std::move(*longer)};
  }
  return std::nullopt;
}

std::optional<Case> moved_together(const Case& problem, std::uint64_t salt) {
  // Large first: a common motion of the bodies must cost no accuracy. The last two bring one of them to rest.
  const double pool[] = {0x1p20, -4096, 100, -7, 1, 0.25};
  constexpr std::size_t kPool = std::size(pool);
  Case other = problem;
  other.expect.reset();
  bool changed = false;
  for (int i = 0; i < 3; ++i) {
    const std::uint64_t pick = mix(salt + 7 * static_cast<std::uint64_t>(i));
    double &a = other.a.displacement[i], &b = other.b.displacement[i];
    const double tail[] = {-a, -b};
    for (std::size_t j = 0; j < kPool + 2; ++j) {
      const double more = j < kPool ? pool[(j + pick) % kPool] : tail[j - kPool];
      const auto of_a = exact_sum(a, more), of_b = exact_sum(b, more);
      if (more == 0 || !of_a || !of_b) continue;
      a = *of_a;
      b = *of_b;
      changed = true;
      break;
    }
  }
  if (!changed || !in_domain(other)) return std::nullopt;
  return other;
}

}  // namespace graze::law
