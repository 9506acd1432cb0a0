// The law of input validation of rotating casts: input that no method may accept.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engines/method.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Ask;
using engine::Method;

namespace {

LawResult bad_turn_is_refused(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  std::string fault;
  const auto expect_refusal = [&](const Case& bad, const Ask& ask, const std::string& what) {
    const Answer answer = method.ask(bad, ask);
    if (answer.outcome == Outcome::invalid_input && answer.invalid != Invalid::none &&
        answer.counters.iterations == 0 && std::isnan(answer.toi_lower) && std::isnan(answer.toi_upper)) {
      return;
    }
    if (fault.empty()) fault = fmt::format("{} is let in: {}", what, describe(answer));
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = kInfinity<double>;
  for (const auto spin : {&Case::spin_a, &Case::spin_b}) {
    for (const auto given : {&corpus::Spin::rotation, &corpus::Spin::pivot}) {
      for (const double poison : {kNan, kInf, -kInf, std::numeric_limits<double>::max()}) {
        Case bad = seen;
        (bad.*spin.*given)[static_cast<int>(hash_of(seen) % 3)] = poison;
        expect_refusal(bad, {}, fmt::format("{} in a turn", poison));
      }
    }
    Case fast = seen;
    fast.t_max = 1;
    (fast.*spin).rotation = Vec3<double>(0, 0x1p31, 0);
    expect_refusal(fast, {}, "a turn by 2^31 radians");
  }
  for (const double t_max : {kNan, -1.0}) {
    Case bad = seen;
    bad.t_max = t_max;
    expect_refusal(bad, {}, fmt::format("a t_max of {}", t_max));
  }
  for (const double tolerance : {kNan, kInf, -1.0}) {
    expect_refusal(seen, {.tolerance = tolerance}, fmt::format("a tolerance of {}", tolerance));
  }
  // A visible rotation, as a ray.
  Case rod = seen;
  rod.a.shape = Segment<double>{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0)};
  rod.a.orientation = {};
  rod.spin_a = {Vec3<double>(0, 0, 1), Vec3<double>::Zero()};
  rod.b = {};
  rod.spin_b = {};
  rod.b.position = rod.a.position;
  rod.b.displacement = rod.a.displacement;
  rod.t_max = kInf;
  expect_refusal(rod, {}, "a seen turn without an end");
  if (!fault.empty()) return broken(fault);
  return holds({label_of(plain_answer(method, seen).outcome)});
}

}  // namespace

std::vector<Law> rotating_validity_laws() {
  return {
      {"bad_turn_is_refused",
       "A NaN, an infinity, 2^31 radians, or a visible rotation without an end is refused.",
       Needs::metamorphic, &bad_turn_is_refused},
  };
}

}  // namespace graze::law
