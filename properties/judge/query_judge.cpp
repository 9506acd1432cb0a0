#include "properties/judge/query_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/format/names.hpp"

namespace graze::law {

using corpus::Query;
using engine::Answer;
using engine::Interval;
using oracle::Enclosure;

QueryJudge::QueryJudge(const corpus::Case& problem, const engine::Method& method, const Answer& answer,
                       double tolerance, double scale)
    : problem_(problem),
      answer_(answer),
      has_witnesses_(method.holds.witnesses),
      scale_(scale),
      limits_(limits_of(method, problem, scale)),
      limit_(limits_.limit),
      wide_(limit_ + tolerance * scale) {
  judgement_.outcome = answer.outcome;
  judgement_.errors.scale = scale_;
  judgement_.stalled = answer.stalled || answer.outcome == Outcome::not_converged;
}

Judgement QueryJudge::operator()() {
  if (answer_.outcome == Outcome::invalid_input) {
    add_fault(judgement_.wrong, "a valid case was refused");
    return judgement_;
  }
  switch (problem_.query) {
    case Query::overlap:
      overlap();
      break;
    case Query::distance:
      distance();
      break;
    case Query::penetration:
      penetration();
      break;
    case Query::penetration_along:
      penetration_along();
      break;
    case Query::line:
      line();
      break;
    case Query::swept_overlap:
      swept_overlap();
      break;
    case Query::cast:
      add_fault(judgement_.wrong, "a cast is judged elsewhere");
      break;
  }
  return judgement_;
}

void QueryJudge::erred(double length) {
  const double error = std::max(length, 0.0);
  judgement_.errors.backward = std::fmax(judgement_.errors.backward, in_scale(error));
  judgement_.errors.over_limit = std::fmax(judgement_.errors.over_limit, over(error, wide_));
}

void QueryJudge::verdict_errs(double error, const char* what) {
  erred(error);
  if (error <= limit_) {
    judgement_.within_tolerance = true;
  } else {
    add_fault(judgement_.wrong, fmt::format("says {}; {} by {:.2e} of scale",
                                            corpus::name_of(answer_.outcome), what, in_scale(error)));
  }
}

void QueryJudge::measure(const char* what, double error) {
  if (judgement_.stalled) return;
  erred(error);
  if (!(error <= wide_)) {
    add_fault(judgement_.off, fmt::format("{} is off by {:.2e} of scale", what, in_scale(error)));
  }
}

void QueryJudge::held(const char* what, double miss) {
  if (!(miss <= limit_)) {
    add_fault(judgement_.off,
              fmt::format("the bracket of {} misses it by {:.2e} of scale", what, in_scale(miss)));
  }
}

void QueryJudge::normal_off(double error, double limit) {
  judgement_.errors.normal = std::fmax(judgement_.errors.normal, in_scale(std::max(error, 0.0)));
  if (!(error <= limit)) {
    add_fault(judgement_.bad_contact, fmt::format("the normal is {:.2e} of scale off", in_scale(error)));
  }
}

bool QueryJudge::witnesses() {
  if (!has_witnesses_) return false;
  if (!answer_.has_points) {
    add_fault(judgement_.bad_contact, "a witness is missing");
    return false;
  }
  bool are_on_bodies = true;
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer_.point_a : answer_.point_b;
    const double error =
        distance_from_body(body, point) - rounding(point) - (body == 'a' ? answer_.reach_a : answer_.reach_b);
    judgement_.errors.witness = std::fmax(judgement_.errors.witness, in_scale(std::max(error, 0.0)));
    if (error <= limit_) continue;
    are_on_bodies = false;
    add_fault(judgement_.bad_contact,
              fmt::format("a witness is {:.2e} of scale off its body", in_scale(error)));
  }
  return are_on_bodies;
}

void QueryJudge::closest_points(const Enclosure& distance) {
  const double between = (answer_.point_a - answer_.point_b).norm(),
               error =
                   std::max(distance.low - between, between - pair_reach() - distance.high) - pair_rounding();
  if (!(error <= 2 * limit_ + wide_)) {
    add_fault(judgement_.bad_contact,
              fmt::format("the closest points' distance is {:.2e} of scale off", in_scale(error)));
  }
}

bool QueryJudge::states_depth() {
  if (answer_.outcome != Outcome::initially_overlapping) return false;
  if (!answer_.depth) add_fault(judgement_.wrong, "no depth");
  return answer_.depth.has_value();
}

bool QueryJudge::is_beyond_scalar(const Interval& bracket, const Enclosure& end) const {
  const double u = limits_.unit_roundoff;
  return (is_beyond_range(bracket.lower, bracket.upper, u) ||
          is_beyond_range(-bracket.upper, -bracket.lower, u)) &&
         bracket.lower <= end.high && end.low <= bracket.upper;
}

double QueryJudge::largest() const {
  return limits_.unit_roundoff == kUnitRoundoff<float> ? double(std::numeric_limits<float>::max())
                                                       : std::numeric_limits<double>::max();
}

}  // namespace graze::law
