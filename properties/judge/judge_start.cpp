#include "properties/judge/judge_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engines/guarantees.hpp"
#include "oracles/truth/bracket_truth.hpp"

namespace graze::law {

using engine::Answer;
using oracle::Enclosure;

namespace {

// The bodies at t = 0, the target distance a part of A.
corpus::Case standing(corpus::Case problem) {
  problem.query = corpus::Query::cast;
  problem.start_policy = StartPolicy::report;
  for (Body<double>* body : {&problem.a, &problem.b}) body->displacement.setZero();
  problem.spin_a = problem.spin_b = {};
  if (problem.target_distance > 0)
    problem.a.shape = rounded<double>(std::move(problem.a.shape), problem.target_distance);
  problem.target_distance = 0;
  return problem;
}

// h(n) - depth, from below, or nothing if contact is not proved.
std::optional<double> beyond_least_penetration(const corpus::Case& problem, const Vec3<double>& n) {
  const corpus::Case rest = standing(problem);
  if (is_exactly_decided(rest)) {
    const oracle::PenetrationTruth truth(rest);
    if (!truth.in_contact()) return {};
    return truth.normal_error(n).low;
  }
  const oracle::BracketTruth truth(rest);
  if (truth.outcome() != Outcome::initially_overlapping) return {};
  return truth.normal_error(n).low - truth.penetration().distance.high;
}

// Distance of a world point from a body at t = 0, by whichever oracle takes the case.
double distance_from_body(Truth& truth, const engine::Method& method, char body, const Vec3<double>& point) {
  return method.kind == engine::Kind::rotating ? truth.bracket().distance_from_body(body, 0, point).low
                                               : truth.cast().distance_from_body(body, 0, point).low;
}

void judge_normal(Judgement& judgement, const corpus::Case& problem, const Answer& answer,
                  const engine::Method& method, const Limits& limits) {
  const double length = answer.normal.norm();
  if (!(std::abs(length - 1) <= std::max(16 * method.unit_roundoff, limits.contact_u)))
    return add_fault(judgement.bad_contact,
                     fmt::format("the normal of a start in contact has length {:.17g}", length));
  if (method.guarantee == nullptr || method.guarantee->start_normal == engine::StartNormal::any) return;
  const std::optional<double> error = beyond_least_penetration(problem, answer.normal);
  if (!error) return;
  judgement.errors.normal = over(std::max(0.0, *error), limits.scale);
  if (*error > limits.contact)
    add_fault(
        judgement.bad_contact,
        fmt::format("B moved along the normal goes {:.2e} of scale farther than by the least penetration",
                    over(*error, limits.scale)));
}

void judge_witnesses(Judgement& judgement, Truth& truth, const Answer& answer, const engine::Method& method,
                     const Limits& limits) {
  double worst = 0;
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    if (!point.allFinite()) return add_fault(judgement.bad_contact, "a witness is not finite");
    // Its coordinates round by 2 u of its distance from the origin (docs/reference/guarantees.md).
    const double granted =
        2 * method.unit_roundoff * point.norm() + (body == 'a' ? answer.reach_a : answer.reach_b);
    worst = std::max(worst, distance_from_body(truth, method, body, point) - granted);
  }
  judgement.errors.witness = over(worst, limits.scale);
  if (worst > limits.contact)
    add_fault(judgement.bad_contact,
              fmt::format("a witness of a start in contact is {:.2e} of scale off its body",
                          over(worst, limits.scale)));
}

}  // namespace

void judge_start(Judgement& judgement, Truth& truth, const Answer& answer, const engine::Method& method,
                 const Limits& limits, Request request) {
  if (answer.outcome != Outcome::initially_overlapping || !judgement.wrong.empty()) return;
  if (method.is_ours()) {
    if (answer.has_normal() || answer.has_points || !answer.point_a.isZero(0) || !answer.point_b.isZero(0))
      add_fault(judgement.bad_contact, "returns a contact of the start, which its documentation excludes");
    return;
  }
  if (asks_for(request, Request::normal) && answer.has_normal())
    judge_normal(judgement, truth.problem(), answer, method, limits);
  if (asks_for(request, Request::witnesses) && answer.has_points)
    judge_witnesses(judgement, truth, answer, method, limits);
}

}  // namespace graze::law
