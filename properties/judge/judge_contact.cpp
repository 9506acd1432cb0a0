#include "properties/judge/judge_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/judge/judge.hpp"

namespace graze::law {

using engine::Answer;
using oracle::CaseTruth;

namespace {

// Error of the normal as a support of C where the path is at contact:  (h(n) - n.(t v)) / |n|. The answer is true of a
// convex set near C, and its normal is a normal there. At a graze, that set's time of impact may be far from C's own.
// So t is the TOI or either end of the bracket, whichever is best.
double normal_error(const CaseTruth& exact, const Answer& answer, const Vec3<double>& v) {
  const double at_toi = exact.normal_error(answer.normal).low, slope = answer.normal.normalized().dot(v);
  const double toi = exact.toi_lower();
  return std::min(
      {at_toi, at_toi + (toi - answer.toi_lower) * slope, at_toi + (toi - answer.toi_upper) * slope});
}

double witness_error(const CaseTruth& exact, const Answer& answer, double unit_roundoff) {
  double worst = 0;
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    // The coordinates are rounded too, which is allowed beside the limit. A witness is the sum of position,
    // motion and offset, and both additions round each coordinate by u of its size.
    const double rounding = 2 * unit_roundoff * point.norm(),
                 reach = body == 'a' ? answer.reach_a : answer.reach_b;
    worst = std::max(worst, exact.distance_from_body(body, answer.toi_lower, point).low - rounding - reach);
  }
  return worst;
}

}  // namespace

void judge_contact(Judgement& judgement, const CaseTruth& exact, const Answer& answer,
                   const engine::Method& method, const corpus::Case& problem, const Limits& limits,
                   Request request) {
  if (answer.outcome != Outcome::hit || exact.outcome() == Outcome::miss) return;
  const double scale = exact.scale().low;
  const double limit = limits.contact_at(std::min(exact.toi_upper(), answer.toi_upper));
  if (asks_for(request, Request::normal)) {
    const double length = answer.normal.norm();
    const Vec3<double> v = problem.b.displacement - problem.a.displacement;
    if (!(std::abs(length - 1) <= std::max(16 * method.unit_roundoff, limits.contact_u))) {
      add_fault(judgement.bad_contact, fmt::format("the normal has length {:.17g}", length));
    } else if (!(answer.normal.dot(v) <= limits.contact_u * v.norm())) {
      add_fault(judgement.bad_contact, "the normal points along the motion");
    } else if (const double error = normal_error(exact, answer, v); error > limit) {
      add_fault(judgement.bad_contact,
                fmt::format("the normal supports C {:.2e} of scale beyond the contact", over(error, scale)));
    }
  }
  if (asks_for(request, Request::witnesses)) {
    if (!answer.point_a.allFinite() || !answer.point_b.allFinite()) {
      add_fault(judgement.bad_contact, "a witness is not finite");
    } else if (const double error = witness_error(exact, answer, method.unit_roundoff); error > limit) {
      add_fault(judgement.bad_contact,
                fmt::format("a witness is {:.2e} of scale off its body", over(error, scale)));
    }
  }
}

Errors errors_of(Truth& truth, const Answer& answer, Request request) {
  Errors errors;
  const CaseTruth& exact = truth.cast();
  const double scale = exact.scale().high;
  const bool contact = exact.outcome() != Outcome::miss;
  if (answer.outcome == Outcome::invalid_input || !senseless(answer, truth.problem().t_max).empty())
    return errors;
  if (answer.outcome == Outcome::miss) {
    if (contact) errors.backward = over(exact.depth().high, scale);
    return errors;
  }
  // A bracket without an upper end has no error there.
  for (const double t : {answer.toi_lower, answer.toi_upper}) {
    if (!(t < kInfinity<double>)) continue;
    const double backward = over(exact.backward_error(t).high, scale);
    errors.backward = std::fmax(errors.backward, backward);
    // No time is right if the oracle leaves the contact open.
    const bool known = contact && exact.outcome() != Outcome::not_converged;
    if (known) errors.forward = std::fmax(errors.forward, over(exact.forward_error(t).high, scale));
  }
  if (answer.outcome == Outcome::hit && contact) {
    if (asks_for(request, Request::normal) && answer.normal.allFinite() && !answer.normal.isZero(0)) {
      const corpus::Case& problem = truth.problem();
      const Vec3<double> v = problem.b.displacement - problem.a.displacement;
      errors.normal = over(std::max(0.0, normal_error(exact, answer, v)), scale);
    }
    if (asks_for(request, Request::witnesses) && answer.point_a.allFinite() && answer.point_b.allFinite()) {
      const double t = answer.toi_lower,
                   a = exact.distance_from_body('a', t, answer.point_a).high - answer.reach_a,
                   b = exact.distance_from_body('b', t, answer.point_b).high - answer.reach_b;
      errors.witness = over(std::max({a, b, 0.0}), scale);
    }
  }
  return errors;
}

}  // namespace graze::law
